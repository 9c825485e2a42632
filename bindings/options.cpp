#include "options.h"

#include <algorithm>
#include <numbers>

#include "names.h"

namespace foldwright {
namespace {

using emscripten::val;

constexpr Name<Heuristic> kHeuristics[] = {{"steepest", Heuristic::kSteepestEdge},
                                           {"flat", Heuristic::kFlatTree},
                                           {"hybrid", Heuristic::kHybrid},
                                           {"random", Heuristic::kRandom}};
constexpr Name<Segmenter> kSegmenters[] = {{"merge", Segmenter::kShape},
                                           {"spectral", Segmenter::kFoldability}};
constexpr Name<Solver> kSolvers[] = {{"tree", Solver::kTree}, {"genetic", Solver::kGenetic}};
constexpr Name<FoldingMode> kFoldingModes[] = {{"off", FoldingMode::kOff},
                                               {"prefer", FoldingMode::kPrefer},
                                               {"require", FoldingMode::kRequire}};
constexpr Name<Sizing> kSizings[] = {{"fit", Sizing::kFit},     {"height", Sizing::kHeight},
                                     {"width", Sizing::kWidth}, {"depth", Sizing::kDepth},
                                     {"scale", Sizing::kScale}, {"sheets", Sizing::kSheets}};
constexpr Name<Up> kUps[] = {{"guess", Up::kGuess}, {"x", Up::kX}, {"y", Up::kY}, {"z", Up::kZ}};
constexpr Name<FlapSide> kFlapSides[] = {{"none", FlapSide::kNone},
                                         {"one", FlapSide::kOne},
                                         {"alternate", FlapSide::kAlternate},
                                         {"both", FlapSide::kBoth}};
constexpr Name<FlapStyle> kFlapStyles[] = {
    {"edge", FlapStyle::kEdge}, {"run", FlapStyle::kRun}, {"zigzag", FlapStyle::kZigzag}};
constexpr Name<EdgeFlaps> kEdgeFlaps[] = {{"none", EdgeFlaps::kNone},
                                          {"left", EdgeFlaps::kLeft},
                                          {"right", EdgeFlaps::kRight},
                                          {"both", EdgeFlaps::kBoth},
                                          {"usual", EdgeFlaps::kUsual}};
constexpr Name<GlueStrips> kGlueStrips[] = {
    {"none", GlueStrips::kNone}, {"free", GlueStrips::kFree}, {"all", GlueStrips::kAll}};
constexpr Name<IdPlace> kIdPlaces[] = {{"none", IdPlace::kNone},
                                       {"inside", IdPlace::kInside},
                                       {"flap", IdPlace::kFlap},
                                       {"both", IdPlace::kBoth},
                                       {"outside", IdPlace::kOutside}};
constexpr Name<Unit> kUnits[] = {{"guess", Unit::kGuess},
                                 {"mm", Unit::kMillimetre},
                                 {"cm", Unit::kCentimetre},
                                 {"m", Unit::kMetre},
                                 {"in", Unit::kInch}};
constexpr Name<Orientation> kOrientations[] = {{"auto", Orientation::kAuto},
                                               {"portrait", Orientation::kPortrait},
                                               {"landscape", Orientation::kLandscape}};

std::string word(const val& value) { return value.as<std::string>(); }

double radians(const val& degrees) { return degrees.as<double>() * std::numbers::pi / 180; }

FlapChoice flap_choice(const val& object) {
  return {object["from"].as<int>(), object["to"].as<int>(),
          from_name<EdgeFlaps>(kEdgeFlaps, word(object["flaps"])),
          object["height"].isUndefined() ? 0 : object["height"].as<double>()};
}

EdgeLock edge_lock(const val& object) {
  return {{object["from"].as<int>(), object["to"].as<int>()}, word(object["as"]) == "fold"};
}

PartName part_name(const val& object) { return {object["part"].as<int>(), word(object["name"])}; }

PinnedPiece pinned_piece(const val& object) {
  const Placement place = {object["sheet"].as<int>(), object["x"].as<double>(),
                           object["y"].as<double>()};
  return {object["part"].as<int>(), object["face"].as<int>(), {place, radians(object["angle"])}};
}

/// The steps of the repair that are named.
RepairSteps repair_steps(const val& names) {
  RepairSteps steps;
  for (const std::string& name : emscripten::vecFromJSArray<std::string>(names)) {
    const auto is_called = [&](const RepairStepRow& row) { return row.name == name; };
    const auto row = std::ranges::find_if(kRepairSteps, is_called);
    if (row == kRepairSteps.end()) throw std::invalid_argument("unknown word: " + name);
    steps.set(static_cast<std::size_t>(row - kRepairSteps.begin()));
  }
  return steps;
}

/// The items of an array.
template <class Convert>
auto items(const val& array, Convert&& convert) {
  std::vector<decltype(convert(array))> found;
  for (const val& item : emscripten::vecFromJSArray<val>(array)) found.push_back(convert(item));
  return found;
}

}  // namespace

JobOptions options_from(const val& object) {
  JobOptions options;
  options.parts.count = object["parts"].as<int>();
  options.parts.heuristic = from_name<Heuristic>(kHeuristics, word(object["heuristic"]));
  options.parts.segmenter = from_name<Segmenter>(kSegmenters, word(object["segment"]));
  options.nets.solver = from_name<Solver>(kSolvers, word(object["solver"]));
  options.nets.folding = from_name<FoldingMode>(kFoldingModes, word(object["folding"]));
  options.nets.clearance = object["clearance"].as<double>();
  options.parts.runs = object["runs"].as<int>();
  options.parts.proxy = object["proxy"].as<int>();
  options.seed = object["seed"].as<std::uint32_t>();
  options.model.faces = object["faces"].as<int>();
  options.model.up = from_name<Up>(kUps, word(object["up"]));
  options.model.fill_holes = object["fillHoles"].as<double>();
  options.model.drop_inner = object["dropInner"].as<bool>();
  options.model.unite = object["unite"].as<bool>();
  options.model.off = repair_steps(object["repairOff"]);
  options.paper.size.by = from_name<Sizing>(kSizings, word(object["sizing"]));
  options.paper.size.value = object["size"].as<double>();
  options.paper.size.unit = from_name<Unit>(kUnits, word(object["unit"]));
  options.nets.compaction = object["compaction"].as<bool>();
  options.paper.ids = from_name<IdPlace>(kIdPlaces, word(object["ids"]));
  options.paper.strips = from_name<GlueStrips>(kGlueStrips, word(object["glueStrips"]));
  options.paper.names = items(object["names"], part_name);
  options.paper.pins = items(object["pins"], pinned_piece);
  options.paper.flaps.borders = object["flapBorders"].as<bool>();
  options.paper.flaps.choices = items(object["flapEdges"], flap_choice);
  options.parts.locks = items(object["locks"], edge_lock);
  options.paper.flaps.side = from_name<FlapSide>(kFlapSides, word(object["flapSide"]));
  FlapShape& flap = options.paper.flaps.shape;
  flap.height = object["flapHeight"].as<double>();
  flap.least = std::min(flap.least, flap.height);
  flap.angles.fill(radians(object["flapAngle"]));
  options.paper.flaps.style = from_name<FlapStyle>(kFlapStyles, word(object["flapStyle"]));
  options.paper.sheet.width = object["paperWidth"].as<double>();
  options.paper.sheet.height = object["paperHeight"].as<double>();
  options.paper.sheet.orientation =
      from_name<Orientation>(kOrientations, word(object["orientation"]));
  options.paper.min_piece = object["minPiece"].as<double>();
  options.paper.sheet.margin = object["margin"].as<double>();
  return options;
}

}  // namespace foldwright
