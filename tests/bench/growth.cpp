// How time and memory grow with the number of faces: every stage of a job on one detailed model,
// simplified to each size beforehand, in 12 parts, on one thread. `bench_growth [MOST_FACES]`

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "mesh/simplify.h"
#include "timed_job.h"

namespace {

using namespace foldwright;

constexpr const char* kFolder = "models/full";
constexpr const char* kModel = "nefertiti";
constexpr int kParts = 12;

std::vector<std::byte> as_off(const Mesh& mesh) {
  std::ostringstream out;
  out.precision(9);
  out << "OFF\n" << mesh.positions.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const Vec3& p : mesh.positions) out << p.transpose() << '\n';
  for (const auto& [a, b, c] : mesh.faces) out << "3 " << a << ' ' << b << ' ' << c << '\n';
  const std::string text = out.str();
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

void measure(const Mesh& full, int faces) {
  const Mesh mesh = faces < full.face_count() ? simplify(full, {.target_faces = faces}) : full;
  JobOptions options;
  options.parts = kParts;
  const testing::TimedJob timed = testing::run_timed(as_off(mesh), "model.off", options);
  if (!timed.result) return;
  const auto seconds = [&](StageId stage) {
    const auto it = timed.seconds.find(stage);
    return it == timed.seconds.end() ? 0.0 : it->second;
  };
  double total = 0;
  for (const auto& [stage, spent] : timed.seconds) total += spent;
  std::printf("%7d %7zu %8.2f %8.2f %8.2f %8.2f %8.2f %8.2f %8.0f\n", mesh.face_count(),
              timed.result->pieces.size(), seconds(StageId::kRead), seconds(StageId::kLearn),
              seconds(StageId::kCluster), seconds(StageId::kSearch), seconds(StageId::kPaper),
              total, peak_megabytes());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int most = argc > 1 ? std::atoi(argv[1]) : 20000;
  for (const auto& path : testing::files_below(kFolder)) {
    if (path.filename().string().find(kModel) == std::string::npos) continue;
    const Mesh full = testing::load(path).mesh;
    std::printf("%7s %7s %8s %8s %8s %8s %8s %8s %8s\n", "faces", "pieces", "read s", "learn s",
                "parts s", "search s", "paper s", "all s", "MB");
    for (const int faces : {300, 1000, 3000, 5000, 10000, 20000, 30000, 70000}) {
      if (faces <= most) measure(full, faces);
    }
    return 0;
  }
  std::puts("growth: no shared models");
  return 0;
}
