#include "pipeline/sheets/model_size.h"

#include <limits>
#include <string>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

constexpr double kLeastModel = 20;  // mm

// Share of a sheet's printable area that the faces of a part may cover. Nets of nine organic models
// that just fit A4 cover 0.17 to 0.62 of it: a part that is larger than that will be cut again.
constexpr double kSheetShare = 0.65;

double per_extent(double wished, double extent, Code if_none) {
  if (extent > 0) return wished / extent;
  throw InputError(if_none);
}

}  // namespace

ModelUnit model_unit(const Mesh& mesh, Unit asked) {
  if (asked != Unit::kGuess) return {asked, false};
  const double largest = extents(mesh).maxCoeff();
  for (const Unit unit : {Unit::kMillimetre, Unit::kCentimetre}) {
    if (largest * millimetres(unit) >= kLeastModel) return {unit, true};
  }
  return {Unit::kMetre, true};
}

double millimetres(Unit unit) {
  switch (unit) {
    case Unit::kCentimetre:
      return 10;
    case Unit::kMetre:
      return 1000;
    case Unit::kInch:
      return 25.4;
    default:
      return 1;
  }
}

Vec3 extents(const Mesh& mesh) {
  if (mesh.positions.empty()) return Vec3::Zero();
  Vec3 low = mesh.positions[0];
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return high - low;
}

double fixed_scale(const Mesh& mesh, const SizeOptions& size) {
  const Vec3 extent = extents(mesh);
  if (size.by == Sizing::kHeight) return per_extent(size.value, extent.y(), "no-height");
  if (size.by == Sizing::kWidth) return per_extent(size.value, extent.x(), "no-width");
  if (size.by == Sizing::kDepth) return per_extent(size.value, extent.z(), "no-depth");
  return size.value * millimetres(model_unit(mesh, size.unit).unit);
}

double largest_part_area(const Mesh& mesh, const PaperOptions& paper) {
  const Sizing by = paper.size.by;
  if (by == Sizing::kFit || by == Sizing::kSheets) return std::numeric_limits<double>::infinity();
  const double scale = fixed_scale(mesh, paper.size);
  const Extent room = printable(paper.sheet);
  return kSheetShare * room.width * room.height / (scale * scale);
}

}  // namespace foldwright
