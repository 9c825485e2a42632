// Times the stages of jobs that change an earlier result, as edits of a document do. Arguments: a
// model, by default one of 1000 faces; the kind of edit, by default all; how many of each.
//
// Prints the median of the processor's milliseconds of each stage.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/job.h"
#include "shared_models.h"
#include "timed_job.h"

namespace foldwright::testing {
namespace {

constexpr StageId kStages[] = {StageId::kRead,   StageId::kLearn,   StageId::kCluster,
                               StageId::kSearch, StageId::kCompact, StageId::kPaper};

const JobOptions kOptions = {.parts = {.count = 8},
                             .paper = {.size = {.by = Sizing::kHeight, .value = 150}}};

struct Edit {
  JobOptions options = kOptions;
  std::optional<JobStart> start;
};

JobStart start_of(const JobResult& result, bool stays_in_place) {
  JobStart start = {.labels = result.labels, .nets = result.nets};
  const SheetLayout& sheets = result.sheets;
  const double width = sheets.sheet_width;
  if (stays_in_place) start.paper = EarlierPaper{sheets.scale, sheets.sheet_count, width};
  return start;
}

/// Where nets are cut and may be joined or get other flaps, and where they are folded.
std::vector<EdgeName> edges_of(const JobResult& result, Assignment cut_or_fold) {
  std::vector<EdgeName> names;
  for (const Piece& piece : result.pieces) {
    for (const NetEdge& edge : piece.net.edges) {
      const bool is_cut = edge.assignment == Assignment::kCut;
      const bool is_fold = !is_cut && edge.angle != 0;
      if (cut_or_fold == Assignment::kCut ? !is_cut : !is_fold) continue;
      const auto& [from, to] = result.mesh.edges[edge.mesh_edge].vertices;
      names.push_back({from, to});
    }
  }
  return names;
}

template <class T>
const T& spread(const std::vector<T>& items, int round, int rounds) {
  return items[(2 * round + 1) * items.size() / (2 * rounds)];
}

/// The edit of one round.
Edit edit_of(const std::string& kind, const JobResult& result, int round, int rounds) {
  Edit edit;
  edit.start = start_of(result, kind != "paper");
  if (kind == "name") edit.options.paper.names = {{0, "Head " + std::to_string(round)}};
  if (kind == "paper") edit.options.paper.sheet.width = 215.9 + round;
  if (kind == "flap") {
    const EdgeName name = spread(edges_of(result, Assignment::kCut), round, rounds);
    edit.options.paper.flaps.choices = {{name.from, name.to, EdgeFlaps::kNone}};
  }
  if (kind == "cut") {
    edit.start->net_edits = {
        CutEdit{spread(edges_of(result, Assignment::kMountain), round, rounds)}};
  }
  return edit;
}

void measure(const std::string& kind, const ModelFile& file, const JobResult& whole,
             const std::shared_ptr<JobMemory>& memory, int rounds) {
  std::map<StageId, std::vector<double>> ms;
  for (int round = 0; round < rounds; ++round) {
    const Edit edit = edit_of(kind, whole, round, rounds);
    const TimedJob timed = run_timed(Job({file}, edit.options, edit.start, memory));
    if (!timed.result) std::fprintf(stderr, "%s: no result\n", kind.c_str());
    for (const auto& [stage, seconds] : timed.seconds) ms[stage].push_back(1000 * seconds);
  }
  std::printf("%-6s", kind.c_str());
  for (const StageId stage : kStages) {
    std::vector<double>& values = ms[stage];
    std::ranges::sort(values);
    std::printf(" %8.1f", values.empty() ? 0 : values[values.size() / 2]);
  }
  std::printf("\n");
}

}  // namespace
}  // namespace foldwright::testing

int main(int argc, char** argv) {
  using namespace foldwright;
  using namespace foldwright::testing;
  const std::filesystem::path path =
      argc > 1 ? argv[1] : shared_folder() / "models/organic/spot_1000.obj";
  const std::string text = bytes_of(path);
  const auto bytes = std::as_bytes(std::span(text));
  const ModelFile file = {path.filename().string(), {bytes.begin(), bytes.end()}};
  const auto memory = std::make_shared<JobMemory>();
  const TimedJob whole = run_timed(Job({file}, kOptions, {}, memory));
  if (!whole.result) return 1;
  const int rounds = argc > 3 ? std::max(1, std::atoi(argv[3])) : 9;
  std::printf("edit       read    learn  cluster   search  compact    paper\n");
  for (const std::string kind : {"name", "flap", "cut", "paper"}) {
    if (argc > 2 && kind != argv[2]) continue;
    measure(kind, file, *whole.result, memory, rounds);
  }
}
