// How nets fold: pieces certified straight, over waypoints, or not at all, pieces against parts,
// and the seconds of the search, for segmented models and for whole closed models as one net.

#include <cstdio>
#include <string>

#include "timed_job.h"

namespace {

using namespace foldwright;

struct Sums {
  int models = 0, parts = 0, pieces = 0, line = 0, waypoints = 0, none = 0, invalid = 0;
  double seconds = 0, slowest = 0;

  void add(const JobResult& result, double search_seconds) {
    ++models;
    parts += result.parts;
    for (const Piece& piece : result.pieces) {
      ++pieces;
      line += piece.motion.kind == Folding::kLine;
      waypoints += piece.motion.kind == Folding::kWaypoints;
      none += piece.motion.kind == Folding::kNone;
      invalid += !piece.check.valid();
    }
    seconds += search_seconds;
    slowest = std::max(slowest, search_seconds);
  }

  void print(const std::string& name) const {
    std::printf("%-22s %6d %6d %7d %6d %10d %6d %8d %9.2f %9.2f\n", name.c_str(), models, parts,
                pieces, line, waypoints, none, invalid, seconds, slowest);
    std::fflush(stdout);
  }
};

void measure(const char* folder, const std::string& faces, int parts, double clearance,
             bool each = false) {
  Sums sums;
  for (const auto& path : testing::files_below(folder)) {
    const std::string name = path.filename().string();
    if (!faces.empty() && name.find("_" + faces + ".") == std::string::npos) continue;
    JobOptions options;
    options.parts.count = parts;
    options.nets.clearance = clearance;
    const testing::TimedJob timed = testing::run_timed(path, options);
    if (!timed.result) continue;
    const double seconds = timed.seconds.at(StageId::kSearch);
    if (each) {
      Sums one;
      one.add(*timed.result, seconds);
      one.print("  " + name);
    }
    sums.add(*timed.result, seconds);
  }
  char title[80];
  std::snprintf(title, sizeof title, "%s x %d, %g%%", faces.empty() ? "academic" : faces.c_str(),
                parts, 100 * clearance);
  sums.print(title);
}

}  // namespace

int main(int argc, char** argv) {
  const bool full = argc > 1 && std::string(argv[1]) == "--full";
  std::printf("%-22s %6s %6s %7s %6s %10s %6s %8s %9s %9s\n", "faces x parts, clear.", "models",
              "parts", "pieces", "line", "waypoints", "none", "invalid", "seconds", "slowest");
  for (const double clearance : {kClearance, kClearance / 10}) {
    for (const char* faces : {"300", "574", "1000", "2000"}) {
      measure("models/organic", faces, 8, clearance, full);
    }
    measure("models/academic", "", 4, clearance, full);
  }
  for (const char* faces : {"574", "1000", "2000"}) {
    measure("models/organic", faces, 1, kClearance, full);
  }
  if (!full) return 0;
  for (const char* faces : {"3000", "5000"}) measure("models/organic", faces, 1, kClearance, true);
}
