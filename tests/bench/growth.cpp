// How time and memory grow with the number of faces: every stage of a job on one detailed model,
// simplified to each size beforehand, on one thread. `bench_growth [--least FACES] [--most FACES]
// [--parts K] [--seed N] [--no-folding] [--no-compaction] [--keep FOLDER]`: 0 parts lets the shape
// decide; FOLDER gets the simplified models, as FACES.off.

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

#include "mesh/decimate.h"
#include "timed_job.h"

namespace {

using namespace foldwright;

constexpr const char* kFolder = "models/full";
constexpr const char* kModel = "nefertiti";

struct Wishes {
  int least = 0;
  int most = 20000;
  JobOptions job;
  std::string keep;  ///< folder; empty: nowhere
};

Wishes wishes_of(int argc, char** argv) {
  Wishes wishes;
  wishes.job.parts.count = 12;
  for (int i = 1; i < argc; ++i) {
    const std::string_view name = argv[i];
    if (name == "--no-folding") wishes.job.nets.folding = FoldingMode::kOff;
    if (name == "--no-compaction") wishes.job.nets.compaction = false;
    if (i + 1 == argc) continue;
    if (name == "--least") wishes.least = std::atoi(argv[++i]);
    if (name == "--most") wishes.most = std::atoi(argv[++i]);
    if (name == "--parts") wishes.job.parts.count = std::atoi(argv[++i]);
    if (name == "--seed") wishes.job.seed = std::strtoull(argv[++i], nullptr, 10);
    if (name == "--keep") wishes.keep = argv[++i];
  }
  return wishes;
}

std::string as_off(const Mesh& mesh) {
  std::ostringstream out;
  out.precision(9);
  out << "OFF\n" << mesh.positions.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const Vec3& p : mesh.positions) out << p.transpose() << '\n';
  for (const auto& [a, b, c] : mesh.faces) out << "3 " << a << ' ' << b << ' ' << c << '\n';
  return out.str();
}

std::vector<std::byte> as_bytes(const std::string& text) {
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

/// Most memory the process has held so far, in MB: sizes ascend, so it is the last one's.
double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void measure(const Mesh& full, int faces, const Wishes& wishes) {
  const Mesh mesh = faces < full.face_count() ? decimate(full, faces) : full;
  const std::string text = as_off(mesh);
  if (!wishes.keep.empty()) {
    std::ofstream(wishes.keep + "/" + std::to_string(faces) + ".off") << text;
  }
  const testing::TimedJob timed = testing::run_timed(as_bytes(text), "model.off", wishes.job);
  if (!timed.result) return;
  const auto& pieces = timed.result->pieces;
  const auto folding = std::count_if(
      pieces.begin(), pieces.end(), [](const Piece& piece) { return !piece.motion.times.empty(); });
  double total = 0;
  std::printf("%7d %7zu %7d", mesh.face_count(), pieces.size(), static_cast<int>(folding));
  for (const StageId stage : {StageId::kRead, StageId::kLearn, StageId::kCluster, StageId::kSearch,
                              StageId::kCompact, StageId::kPaper}) {
    const auto it = timed.seconds.find(stage);
    const double seconds = it == timed.seconds.end() ? 0 : it->second;
    total += seconds;
    std::printf(" %8.2f", seconds);
  }
  std::printf(" %8.2f %8.0f\n", total, peak_megabytes());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const Wishes wishes = wishes_of(argc, argv);
  for (const auto& path : testing::files_below(kFolder)) {
    if (path.filename().string().find(kModel) == std::string::npos) continue;
    const Mesh full = testing::load(path).mesh;
    std::printf("%7s %7s %7s %8s %8s %8s %8s %9s %8s %8s %8s\n", "faces", "pieces", "folding",
                "read s", "learn s", "parts s", "search s", "compact s", "paper s", "all s", "MB");
    for (const int faces : {300, 1000, 3000, 5000, 10000, 20000, 30000, 70000}) {
      if (wishes.least <= faces && faces <= wishes.most) measure(full, faces, wishes);
    }
    return 0;
  }
  std::puts("growth: no shared models");
  return 0;
}
