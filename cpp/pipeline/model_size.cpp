#include "pipeline/model_size.h"

#include <string>

#include "mesh/input_error.h"

namespace foldwright {
namespace {

constexpr double kLeastModel = 20;  // mm

double per_extent(double wished, double extent, const std::string& direction) {
  if (extent > 0) return wished / extent;
  throw InputError("no-" + direction, "the model has no " + direction + " that could be scaled");
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
  if (size.by == Sizing::kHeight) return per_extent(size.value, extent.y(), "height");
  if (size.by == Sizing::kWidth) return per_extent(size.value, extent.x(), "width");
  return size.value * millimetres(model_unit(mesh, size.unit).unit);
}

}  // namespace foldwright
