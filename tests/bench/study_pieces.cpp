// Table 3 of the paper: pieces obtained for the parts asked for, beside unfolding and splitting,
// and a search for one net. `bench_study_pieces [FOLDER]`

#include <cstdio>

#include "split_unfolding.h"
#include "study.h"
#include "timed_job.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

constexpr int kParts = 9;
constexpr int kSizes[] = {574, 1000, 2000, 3000};

// From the paper's Table 3: parts that it got (and asked for), and what Pepakura Designer and the
// search of Takahashi et al. came to; "-" where there is no figure.
constexpr std::array<const char*, 5> kPublished[] = {
    {"snail", "574", "5 (5)", "5", "1"},         {"peekaboo", "1000", "9 (9)", "18", "-"},
    {"dinosaur", "1000", "9 (9)", "29", "-"},    {"triceratops", "1000", "11 (11)", "36", "5"},
    {"squirtle", "1718", "6 (6)", "18", "4"},    {"angel", "2000", "16 (11)", "42", "14"},
    {"monkey", "2000", "10 (10)", "50", "13"},   {"children", "3000", "16 (13)", "68", "17"},
    {"Yi Sun-sin", "3000", "11 (9)", "79", "-"}, {"dragon", "5000", "34 (11)", "130", "16"}};

}  // namespace

int main(int argc, char** argv) {
  if (!has_study_models("study of pieces")) return 0;
  const StudyFolder folder(std::span(argv, static_cast<std::size_t>(argc)));
  Table table({"model", "triangles", "pieces (asked)", "split at overlaps", "one-net search"});
  for (const int faces : kSizes) {
    for (const char* model : kStudyModels) {
      const auto path = organic_model(model, faces);
      const auto parts = run_timed(path, {.parts = {.count = kParts}}).result;
      const auto whole =
          run_timed(path, {.parts = {.count = 1}, .nets = {.folding = FoldingMode::kOff}}).result;
      const std::vector<int> split = unfold_and_split(parts->mesh, build_dual_graph(parts->mesh));
      table.add({model, std::to_string(faces),
                 std::to_string(parts->pieces.size()) + " (" + std::to_string(kParts) + ")",
                 std::to_string(1 + *std::max_element(split.begin(), split.end())),
                 std::to_string(whole->pieces.size())});
    }
  }
  for (const auto& row : kPublished) {
    table.add({std::string(row[0]) + " [paper]", row[1], row[2], row[3], row[4]});
  }
  folder.save("table-3.md", "Table 3: pieces, beside unfolding and splitting, and one-net search",
              table);
  return 0;
}
