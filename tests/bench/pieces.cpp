// Whether models come out in as many pieces as parts were asked for: organic models of 300 to 2000
// faces in 4 to 16 parts, with folding and without. Prints a line for each number of faces and
// parts, and one for each run that came to more pieces or to a piece without a motion.

#include <array>
#include <cstdio>
#include <string>

#include "timed_job.h"

namespace {

using namespace foldwright;

struct Sums {
  int runs = 0, equal = 0, folded = 0;
  double seconds = 0;
};

int count_folded(const JobResult& result) {
  return static_cast<int>(std::ranges::count_if(
      result.pieces, [](const Piece& piece) { return piece.motion.kind != Folding::kNone; }));
}

void add_run(const std::filesystem::path& path, const JobOptions& options, Sums& sums) {
  const testing::TimedJob timed = testing::run_timed(path, options);
  if (!timed.result) return;
  const auto pieces = static_cast<int>(timed.result->pieces.size());
  const int folded = count_folded(*timed.result);
  const bool wants_folding = options.nets.folding != FoldingMode::kOff;
  ++sums.runs;
  sums.equal += pieces == options.parts.count;
  sums.folded += wants_folding && folded == pieces;
  sums.seconds += timed.seconds.at(StageId::kSearch);
  if (pieces == options.parts.count && (!wants_folding || folded == pieces)) return;
  std::printf("  %s in %d parts, folding %s: %d pieces, %d fold\n",
              path.filename().string().c_str(), options.parts.count, wants_folding ? "on" : "off",
              pieces, folded);
}

}  // namespace

int main() {
  Sums all;
  std::printf("%5s %5s %7s %5s %15s %12s %9s\n", "faces", "parts", "folding", "runs",
              "pieces = parts", "all folded", "search s");
  for (const char* faces : {"300", "574", "1000", "2000"}) {
    for (const int parts : {4, 8, 12, 16}) {
      for (const FoldingMode folding : {FoldingMode::kOff, FoldingMode::kPrefer}) {
        Sums sums;
        JobOptions options;
        options.parts.count = parts;
        options.nets.folding = folding;
        options.nets.compaction = false;
        for (const auto& path : testing::files_below("models/organic")) {
          const std::string name = path.filename().string();
          if (name.find("_" + std::string(faces) + ".") == std::string::npos) continue;
          add_run(path, options, sums);
        }
        std::printf("%5s %5d %7s %5d %15d %12d %9.2f\n", faces, parts,
                    folding == FoldingMode::kOff ? "off" : "on", sums.runs, sums.equal, sums.folded,
                    sums.seconds);
        std::fflush(stdout);
        all.runs += sums.runs;
        all.equal += sums.equal;
      }
    }
  }
  std::printf("%d of %d runs: as many pieces as parts\n", all.equal, all.runs);
  return 0;
}
