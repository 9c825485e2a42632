#include "pipeline/options.h"

#include <cmath>
#include <string>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

void check(bool valid, const std::string& name, const std::string& range) {
  if (!valid) throw InputError("bad-option", name + " must be " + range);
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
  const SheetOptions& sheet = options.sheet;
  // Ten metres: wider than any roll, and far below what would lose precision.
  const auto is_length = [](double mm) { return std::isfinite(mm) && mm > 0 && mm <= 10000; };
  check(is_length(sheet.width) && is_length(sheet.height), "paper", "between 0 and 10000 mm");
  check(std::isfinite(sheet.margin) && sheet.margin >= 0 &&
            2 * sheet.margin < std::min(sheet.width, sheet.height),
        "margin", "0 mm or more, and less than half the paper's shorter side");
}

}  // namespace foldwright
