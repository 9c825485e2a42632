#include "pipeline/values/options.h"

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

/// `what`: the option.
void check(bool valid, const char* what, Parameters bounds = {}) {
  if (valid) return;
  bounds.insert(bounds.begin(), {"what", what});
  throw InputError("bad-option", std::move(bounds));
}

constexpr int kMostSheets = 1000;

void check_size(const SizeOptions& size) {
  // A hundred metres, and a factor of a million from micrometres to metres: beyond are slips.
  constexpr double kLongest = 1e5;
  constexpr double kLargest = 1e6;
  const auto is_within = [&](double most) {
    return std::isfinite(size.value) && size.value > 0 && size.value <= most;
  };
  switch (size.by) {
    case Sizing::kFit:
      return;
    case Sizing::kHeight:
      return check(is_within(kLongest), "height", {{"most", kLongest}});
    case Sizing::kWidth:
      return check(is_within(kLongest), "width", {{"most", kLongest}});
    case Sizing::kDepth:
      return check(is_within(kLongest), "depth", {{"most", kLongest}});
    case Sizing::kScale:
      return check(is_within(kLargest), "scale", {{"most", kLargest}});
    case Sizing::kSheets:
      return check(is_within(kMostSheets) && size.value == std::floor(size.value), "sheets",
                   {{"least", 1}, {"most", kMostSheets}});
  }
}

void check_flaps(const FlapOptions& flaps) {
  if (flaps.side == FlapSide::kNone && flaps.choices.empty() && !flaps.borders) return;
  // Higher ones than 50 mm would hide whole faces.
  const auto is_height = [](double mm) { return std::isfinite(mm) && mm >= 1 && mm <= 50; };
  check(is_height(flaps.shape.height), "flaps", {{"least", 1}, {"most", 50}});
  for (const FlapChoice& choice : flaps.choices) {
    check(choice.height == 0 || is_height(choice.height), "flap-height",
          {{"least", 1}, {"most", 50}});
  }
  // Steeper sides collide inside the model; flatter ones leave no flap on short edges.
  const double angle = flaps.shape.angles[0] * 180 / std::numbers::pi;
  check(angle > 10 - 1e-9 && angle < 60 + 1e-9, "flap-angle", {{"least", 10}, {"most", 60}});
}

void check_names(std::span<const PartName> names) {
  std::set<int> parts;
  std::set<std::string> taken;
  for (const auto& [part, name] : names) {
    const std::string fault = fault_of_name(name);
    if (!fault.empty()) throw InputError("bad-option", {{"what", fault}});
    check(part >= 0 && parts.insert(part).second, "names-of-part");
    if (!taken.insert(name).second) {
      throw InputError("bad-option", {{"what", "same-name"}, {"name", name}});
    }
  }
}

void check_pins(std::span<const PinnedPiece> pins) {
  for (const auto& [part, face, pin] : pins) {
    check(part >= 0 && face >= 0, "pin-piece");
    check(pin.place.sheet >= 0 && pin.place.sheet < kMostSheets, "pin-sheet",
          {{"most", kMostSheets}});
    check(std::isfinite(pin.place.x) && std::isfinite(pin.place.y) && std::isfinite(pin.angle),
          "pin-place");
  }
}

}  // namespace

void check_options(const JobOptions& options) {
  check(options.parts.count >= 0, "parts", {{"least", 1}});
  check(options.parts.runs >= 1 && options.parts.runs <= 65535, "runs",
        {{"least", 1}, {"most", 65535}});
  // Less is lost in the rounding of coordinates; more erodes all faces by as much as they may be.
  check(options.nets.clearance >= 1e-4 && options.nets.clearance <= 0.2, "clearance",
        {{"least", 1e-4}, {"most", 0.2}});
  check(options.parts.proxy >= 0, "proxy", {{"least", 0}});
  // A closed surface has at least four faces.
  check(options.model.faces == 0 || options.model.faces >= 4, "faces", {{"least", 4}});
  // No hole is wider than the diagonal of the model's box, at most 173 % of its longest side.
  check(options.model.fill_holes >= 0 && options.model.fill_holes <= 200, "fill-holes",
        {{"least", 0}, {"most", 200}});
  for (std::size_t i = 0; i < kRepairSteps.size(); ++i) {
    const bool can_be_off = kRepairSteps[i].kind == StepKind::kSwitch;
    check(can_be_off || !options.model.off[i], "repair", {{"step", kRepairSteps[i].name}});
  }
  check(options.paper.min_piece >= 0 && options.paper.min_piece <= 1000, "min-piece",
        {{"least", 0}, {"most", 1000}});
  check_size(options.paper.size);
  check_flaps(options.paper.flaps);
  check_names(options.paper.names);
  check_pins(options.paper.pins);
  const SheetOptions& sheet = options.paper.sheet;
  // Ten metres: wider than any roll, and far below what would lose precision.
  const auto is_length = [](double mm) { return std::isfinite(mm) && mm > 0 && mm <= 10000; };
  check(is_length(sheet.width) && is_length(sheet.height), "paper", {{"most", 10000}});
  check(std::isfinite(sheet.margin) && sheet.margin >= 0 &&
            2 * sheet.margin < std::min(sheet.width, sheet.height),
        "margin", {{"least", 0}});
}

}  // namespace foldwright
