#include "pipeline/options.h"

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

void check(bool valid, const std::string& name, const std::string& range) {
  if (!valid) throw InputError("bad-option", name + " must be " + range);
}

void check_size(const SizeOptions& size) {
  // A hundred metres, and a factor of a million from micrometres to metres: beyond are slips.
  const auto is_within = [&](double most) {
    return std::isfinite(size.value) && size.value > 0 && size.value <= most;
  };
  switch (size.by) {
    case Sizing::kFit:
      return;
    case Sizing::kHeight:
      return check(is_within(1e5), "height", "above 0 and at most 100000 mm");
    case Sizing::kWidth:
      return check(is_within(1e5), "width", "above 0 and at most 100000 mm");
    case Sizing::kDepth:
      return check(is_within(1e5), "depth", "above 0 and at most 100000 mm");
    case Sizing::kScale:
      return check(is_within(1e6), "scale", "above 0 and at most 1000000");
    case Sizing::kSheets:
      return check(is_within(1000) && size.value == std::floor(size.value), "sheets",
                   "a whole number from 1 to 1000");
  }
}

void check_flaps(const FlapOptions& flaps) {
  if (flaps.side == FlapSide::kNone && flaps.choices.empty() && !flaps.borders) return;
  // Higher ones than 50 mm would hide whole faces.
  const auto is_height = [](double mm) { return std::isfinite(mm) && mm >= 1 && mm <= 50; };
  check(is_height(flaps.shape.height), "flaps", "from 1 to 50 mm");
  for (const FlapChoice& choice : flaps.choices) {
    check(choice.height == 0 || is_height(choice.height), "the height of a flap",
          "from 1 to 50 mm");
  }
  // Steeper sides collide inside the model; flatter ones leave no flap on short edges.
  const double angle = flaps.shape.angle * 180 / std::numbers::pi;
  check(angle > 10 - 1e-9 && angle < 60 + 1e-9, "flap-angle", "from 10 to 60 degrees");
}

void check_names(std::span<const PartName> names) {
  std::set<int> parts;
  std::set<std::string> taken;
  for (const auto& [part, name] : names) {
    const std::string fault = fault_of_name(name);
    if (!fault.empty()) throw InputError("bad-option", "the name of a part " + fault);
    check(part >= 0 && parts.insert(part).second, "the names of parts",
          "at most one for each part");
    if (!taken.insert(name).second) {
      throw InputError("bad-option", "two parts cannot have the same name, \"" + name + "\"");
    }
  }
}

void check_pins(std::span<const PinnedPiece> pins) {
  for (const auto& [part, face, pin] : pins) {
    check(part >= 0 && face >= 0, "a pinned piece", "named by its part and a face of it");
    check(pin.place.sheet >= 0 && pin.place.sheet < 1000, "the sheet of a pinned piece",
          "one of the first 1000");
    check(std::isfinite(pin.place.x) && std::isfinite(pin.place.y) && std::isfinite(pin.angle),
          "the place of a pinned piece", "a finite number");
  }
}

}  // namespace

void check_options(const JobOptions& options) {
  check(options.parts >= 0, "parts", "auto or at least 1");
  check(options.runs >= 1 && options.runs <= 65535, "runs", "from 1 to 65535");
  // Less is lost in the rounding of coordinates; more erodes all faces by as much as they may be.
  check(options.clearance >= 1e-4 && options.clearance <= 0.2, "clearance", "from 0.0001 to 0.2");
  check(options.proxy >= 0, "proxy", "0 or more");
  // A closed surface has at least four faces.
  check(options.faces == 0 || options.faces >= 4, "faces", "at least 4");
  check_size(options.size);
  check_flaps(options.flaps);
  check_names(options.names);
  check_pins(options.pins);
  const SheetOptions& sheet = options.sheet;
  // Ten metres: wider than any roll, and far below what would lose precision.
  const auto is_length = [](double mm) { return std::isfinite(mm) && mm > 0 && mm <= 10000; };
  check(is_length(sheet.width) && is_length(sheet.height), "paper", "between 0 and 10000 mm");
  check(std::isfinite(sheet.margin) && sheet.margin >= 0 &&
            2 * sheet.margin < std::min(sheet.width, sheet.height),
        "margin", "0 mm or more, and less than half the paper's shorter side");
}

}  // namespace foldwright
