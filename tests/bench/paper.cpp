// Measures what comes out on paper: flaps, ids, sheets, and pieces that are cut again.
//
// Arguments: numbers of faces (300, 574 and 1000 when none is given), `model=NAME` to take one
// model alone, and `folding=off` for nets that need not fold up. Runs whole jobs of nine organic
// models in 8 parts, 150 mm high on A4, and prints one JSON line per model and a line of means and
// worst values per number of faces, shares in percent. The models of the first size are laid out
// once more at 300 mm, where pieces are too large for the sheet; `pieces_per_need` compares them
// with what the area of each part needs at least.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "outline_gaps.h"
#include "paper/packing.h"
#include "pipeline/sheets/flat_net.h"
#include "seam_counts.h"
#include "timed_job.h"

namespace foldwright::testing {
namespace {

constexpr const char* kModels[] = {"cat",       "fish",    "goathead", "hand", "koala",
                                   "nefertiti", "penguin", "skull",    "spot"};

double area_of(const Footprint& print) {
  double twice = 0;
  for (const std::vector<Vec2>& polygon : print.polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  return twice / 2;
}

struct Measures {
  std::map<std::string, double> values;  ///< by name, in the order of printing
};

void print_line(const std::string& head, const Measures& measures) {
  std::printf("{%s", head.c_str());
  for (const auto& [name, value] : measures.values) {
    std::printf(",\"%s\":%.4g", name.c_str(), value);
  }
  std::printf("}\n");
  std::fflush(stdout);
}

/// Face and flap area over the part of the printable sheets down to the lowest piece.
double strip_efficiency(const JobResult& result, const std::vector<Footprint>& prints,
                        const SheetOptions& options) {
  double area = 0;
  for (const Footprint& print : prints) area += area_of(print);
  const SheetLayout& sheets = result.sheets;
  const double taken = ruled_margin(options) + options.margin;
  const double full = sheets.sheet_height - taken;
  return area /
         ((sheets.sheet_width - taken) * (full * (sheets.sheet_count - 1) + sheets.used_height));
}

double seconds_of_packing(const std::vector<Footprint>& prints, const SheetOptions& options) {
  const std::clock_t start = std::clock();
  lay_on_sheets({.pieces = prints, .options = options});
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::vector<Footprint> prints_of(const JobResult& result) {
  std::vector<Footprint> prints;
  for (const Piece& piece : result.pieces) prints.push_back(footprint_of(piece.net, piece.flaps));
  return prints;
}

Measures measure(const TimedJob& job, const JobOptions& options) {
  const JobResult& result = *job.result;
  const std::vector<Footprint> prints = prints_of(result);
  const FlapCounts& counts = result.flap_counts;
  Measures m;
  m.values["flaps"] = 100.0 * (counts.full + counts.shrunk) / counts.wanted;
  m.values["full"] = 100.0 * counts.full / counts.wanted;
  m.values["missing_mm"] = 100 * counts.missing_length / counts.wanted_length;
  const char* names[] = {"miss_short", "miss_thin", "miss_narrow", "miss_blocked"};
  for (const char* name : names) m.values[name] = 0;
  for (const MissedFlap& miss : result.missed_flaps) {
    m.values[names[static_cast<int>(miss.why)]] += 100.0 / counts.wanted;
  }
  const auto numbered = static_cast<double>(result.skipped_ids.size()) + result.printed_ids;
  m.values["ids"] = 100 * result.printed_ids / numbered;
  int texts = 0;
  int small = 0;
  for (const Piece& piece : result.pieces) {
    for (const Label& label : piece.labels) {
      if (label.text == piece.name) continue;
      ++texts;
      if (label.size < 2) ++small;
    }
  }
  m.values["small"] = texts == 0 ? 0 : 100.0 * small / texts;
  const SeamCounts counted = count_seams(result);
  const auto& turns = counted.between;
  m.values["seams"] = counted.seams;
  m.values["glue_mm"] = counted.glue;
  m.values["changes"] = turns.followers == 0 ? 0 : 100.0 * turns.changes / turns.followers;
  OutlineGaps gaps;
  for (const Piece& piece : result.pieces) gaps += outline_gaps(piece.net, piece.flaps);
  m.values["close"] = 100 * gaps.close / gaps.length;
  m.values["close_corner"] = 100 * gaps.corner / gaps.length;
  m.values["close_hair"] = 100 * gaps.hair / gaps.length;
  m.values["strip"] = 100 * strip_efficiency(result, prints, options.paper.sheet);
  m.values["pieces"] = static_cast<double>(result.pieces.size());
  m.values["sheets"] = result.sheets.sheet_count;
  m.values["strips"] = static_cast<double>(result.strips.size());
  m.values["taped"] = result.taped;
  double seconds = 0;
  for (const auto& [stage, passed] : job.seconds) seconds += passed;
  m.values["seconds"] = seconds;
  m.values["seconds_paper"] = job.seconds.at(StageId::kPaper);
  m.values["seconds_packing"] = seconds_of_packing(prints, options.paper.sheet);
  m.values["longest_step"] = job.longest_step.at(StageId::kPaper);
  const Extent room = printable(options.paper.sheet);
  std::map<int, double> areas;  // of the faces of each part
  bool fits = true;
  for (std::size_t i = 0; i < prints.size(); ++i) {
    areas[result.pieces[i].part] += prints[i].face_area;
    fits = fits && fits_somehow(prints[i], room);
  }
  m.values["too_large"] = fits ? 0 : 1;
  double needed = 0;
  for (const auto& [part, size] : areas) needed += std::ceil(size / (room.width * room.height));
  m.values["pieces_per_need"] = static_cast<double>(result.pieces.size()) / needed;
  return m;
}

/// The mean, and the worst in the direction that is bad.
void print_summary(const std::string& head, const std::vector<Measures>& all) {
  Measures summary;
  for (const auto& [name, unused] : all.front().values) {
    double sum = 0;
    double least = 1e300;
    double most = -1e300;
    for (const Measures& m : all) {
      const double value = m.values.at(name);
      sum += value;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    const bool more_is_better =
        name == "flaps" || name == "full" || name == "ids" || name == "strip";
    summary.values[name] = sum / static_cast<double>(all.size());
    summary.values[name + "_worst"] = more_is_better ? least : most;
  }
  print_line(head, summary);
}

struct Wishes {
  std::vector<int> sizes;
  std::string only;  ///< name of a model; empty: all
  FoldingMode folding = FoldingMode::kPrefer;
};

void measure_all(int faces, double height, const Wishes& wishes) {
  std::vector<Measures> all;
  for (const char* name : kModels) {
    if (!wishes.only.empty() && wishes.only != name) continue;
    const auto path = shared_folder() / "models/organic" /
                      (std::string(name) + "_" + std::to_string(faces) + ".obj");
    if (!std::filesystem::exists(path)) continue;
    JobOptions options;
    options.parts.count = 8;
    options.nets.folding = wishes.folding;
    options.paper.size = {Sizing::kHeight, height};
    options.paper.strips = GlueStrips::kFree;
    const TimedJob job = run_timed(path, options);
    if (!job.result) continue;
    all.push_back(measure(job, options));
    print_line("\"model\":\"" + std::string(name) + "\",\"faces\":" + std::to_string(faces) +
                   ",\"height\":" + std::to_string(static_cast<int>(height)),
               all.back());
  }
  if (all.empty()) return;
  print_summary("\"faces\":" + std::to_string(faces) +
                    ",\"height\":" + std::to_string(static_cast<int>(height)),
                all);
}

}  // namespace
}  // namespace foldwright::testing

int main(int argc, char** argv) {
  foldwright::testing::Wishes wishes;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    if (text.starts_with("model=")) {
      wishes.only = text.substr(6);
    } else if (text == "folding=off") {
      wishes.folding = foldwright::FoldingMode::kOff;
    } else {
      wishes.sizes.push_back(std::atoi(argv[i]));
    }
  }
  if (wishes.sizes.empty()) wishes.sizes = {300, 574, 1000};
  for (const int faces : wishes.sizes) foldwright::testing::measure_all(faces, 150, wishes);
  foldwright::testing::measure_all(wishes.sizes[0], 300, wishes);
  return 0;
}
