// Measures whole jobs of shapes that people draw nets of by hand, against what they draw.
//
// Arguments: `only=NAME` takes one shape alone, `obj=FOLDER` writes the models there and ends.
// Prints one JSON line per shape and, of all, the worst ratio of the glue to that of the net drawn
// by hand, and how many shapes stay within 1.1 of it and within its number of pieces.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "craft_shapes.h"
#include "paper/seams.h"
#include "seam_counts.h"
#include "timed_job.h"

namespace foldwright::testing {
namespace {

constexpr double kAsGood = 1.1;

TimedJob unfold(const CraftShape& shape) {
  JobOptions options;
  options.paper.size = {Sizing::kScale, 1, Unit::kMillimetre};
  const std::string text = obj_of(shape.solid);
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return run_timed(std::move(bytes), "model.obj", options);
}

/// Whether a piece lies so that its longest straight side is parallel to the sheet.
bool is_upright(const Piece& piece) {
  double longest = 0;
  Vec2 along(1, 0);
  const std::vector<Net> nets = {piece.net};
  for (const Seam& seam : find_seams(nets)) {
    for (const SeamSide& side : seam.sides) {
      if (side.length() <= longest) continue;
      longest = side.length();
      along = Vec2(side.to - side.from).normalized();
    }
  }
  return std::min(std::abs(along.x()), std::abs(along.y())) < 0.001;
}

struct Totals {
  int shapes = 0, as_good = 0, as_whole = 0;
  double worst = 0;
};

void measure(const CraftShape& shape, Totals& totals) {
  const TimedJob job = unfold(shape);
  ++totals.shapes;
  if (!job.result) {
    std::printf("{\"shape\":\"%s\",\"refused\":true}\n", shape.solid.name.c_str());
    return;
  }
  const JobResult& result = *job.result;
  const SeamCounts seams = count_seams(result);
  int upright = 0;
  int certified = 0;
  int flaps = 0;
  for (const Piece& piece : result.pieces) {
    upright += is_upright(piece);
    certified += piece.motion.kind == Folding::kLine || piece.motion.kind == Folding::kWaypoints;
    flaps += static_cast<int>(piece.flaps.size());
  }
  double seconds = 0;
  for (const auto& [stage, passed] : job.seconds) seconds += passed;
  const double ratio = seams.glue / shape.by_hand;
  const auto pieces = static_cast<int>(result.pieces.size());
  std::printf(
      "{\"shape\":\"%s\",\"pieces\":%d,\"by_hand_pieces\":%d,\"sheets\":%d,\"glue_mm\":%.0f,"
      "\"by_hand_mm\":%.0f,\"ratio\":%.3f,\"seams\":%d,\"flaps\":%d,\"full\":%d,\"changes\":%d,"
      "\"upright\":%d,\"certified\":%d,\"seconds\":%.1f}\n",
      shape.solid.name.c_str(), pieces, shape.pieces, result.sheets.sheet_count, seams.glue,
      shape.by_hand, ratio, seams.seams, flaps, result.flap_counts.full,
      seams.between.changes + seams.within.changes, upright, certified, seconds);
  std::fflush(stdout);
  totals.worst = std::max(totals.worst, ratio);
  totals.as_good += ratio <= kAsGood;
  totals.as_whole += pieces <= shape.pieces;
}

void write_models(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const CraftShape& shape : craft_shapes()) {
    std::string name = shape.solid.name;
    std::ranges::replace(name, ' ', '_');
    std::ofstream(folder / (name + ".obj")) << obj_of(shape.solid);
  }
}

}  // namespace
}  // namespace foldwright::testing

int main(int argc, char** argv) {
  using namespace foldwright::testing;
  std::string only;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    if (text.starts_with("only=")) only = text.substr(5);
    if (text.starts_with("obj=")) {
      write_models(text.substr(4));
      return 0;
    }
  }
  Totals totals;
  for (const CraftShape& shape : craft_shapes()) {
    if (only.empty() || only == shape.solid.name) measure(shape, totals);
  }
  std::printf("{\"shapes\":%d,\"within_1.1\":%d,\"as_whole\":%d,\"worst_ratio\":%.3f}\n",
              totals.shapes, totals.as_good, totals.as_whole, totals.worst);
  return 0;
}
