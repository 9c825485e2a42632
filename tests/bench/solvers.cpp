// The genetic search beside the tree search, whole meshes beside segmented ones [paper, 4.3]: how
// long the search stage takes and how many pieces come out. The paper reports a factor of three for
// segmenting its snail of 574 faces first.

#include <cstdio>
#include <cstring>

#include "timed_job.h"

namespace {

using namespace foldwright;
void print_row(const std::filesystem::path& path, int parts, Solver solver) {
  JobOptions options;
  options.parts.count = parts;
  options.nets.solver = solver;
  options.nets.folding = FoldingMode::kOff;
  const testing::TimedJob timed = testing::run_timed(path, options);
  if (!timed.result) return;
  const JobResult& result = *timed.result;
  std::size_t invalid = 0;
  for (const Piece& piece : result.pieces) invalid += piece.check.valid() ? 0 : 1;
  std::printf("%-20s %-8s %5d %6zu %8zu %12lld %12d %9.2f\n", path.filename().c_str(),
              solver == Solver::kTree ? "tree" : "genetic", parts, result.pieces.size(), invalid,
              static_cast<long long>(result.moves), result.generations,
              timed.seconds.at(StageId::kSearch));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  // The 574-face models are the paper's size, and take the genetic search minutes: on demand.
  const bool full = argc > 1 && std::strcmp(argv[1], "--full") == 0;
  std::printf("%-20s %-8s %5s %6s %8s %12s %12s %9s\n", "model", "solver", "parts", "pieces",
              "invalid", "moves", "generations", "seconds");
  for (const char* folder : {"models/organic", "models/academic"}) {
    for (const auto& path : testing::files_below(folder)) {
      const std::string name = path.filename().string();
      const bool small =
          name.find("_300.") != std::string::npos || std::strcmp(folder, "models/academic") == 0;
      if (!small && !(full && name.find("_574.") != std::string::npos)) continue;
      for (const int parts : {1, 8}) {
        for (const Solver solver : {Solver::kTree, Solver::kGenetic}) {
          print_row(path, parts, solver);
        }
      }
    }
  }
}
