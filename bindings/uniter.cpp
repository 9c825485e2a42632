#include "uniter.h"

#include "arrays.h"

namespace foldwright {
namespace {

using emscripten::val;

val to_value(const Solid& solid) {
  std::vector<double> positions;
  for (const Vec3& p : solid.positions) positions.insert(positions.end(), p.begin(), p.end());
  val object = val::object();
  object.set("positions", doubles(positions));
  object.set("faces", ints(flat(solid.faces)));
  return object;
}

UnitedSolids united_from(const val& object) {
  const auto positions = emscripten::convertJSArrayToNumberVector<double>(object["positions"]);
  const auto corners = emscripten::convertJSArrayToNumberVector<int>(object["faces"]);
  UnitedSolids united;
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    united.positions.emplace_back(positions[i], positions[i + 1], positions[i + 2]);
  }
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    united.faces.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  united.sources = emscripten::convertJSArrayToNumberVector<int>(object["sources"]);
  return united;
}

}  // namespace

SolidUniter uniter_from(const val& function) {
  return [function](const std::vector<Solid>& solids) -> std::optional<UnitedSolids> {
    const val united = function(list(solids, to_value));
    if (united.isNull()) return std::nullopt;
    return united_from(united);
  };
}

}  // namespace foldwright
