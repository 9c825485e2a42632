#include "repair/planar_fit.h"

#include <algorithm>

namespace foldwright {

PlanarFit fit_plane(const TriangleSoup& soup, std::span<const int> faces) {
  PlanarFit fit;
  Vec3 normal = Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (const int face : faces) {
    const Vec3 area = area_vector(soup, face);
    normal += area;
    fit.area += 0.5 * area.norm();
    for (const int v : soup.faces[face]) sum += soup.positions[v];
  }
  fit.normal = normal.normalized();
  fit.centre = sum / (3.0 * static_cast<double>(faces.size()));
  double lowest = 0;
  double highest = 0;
  for (const int face : faces) {
    fit.upright = fit.upright && area_vector(soup, face).dot(fit.normal) > 0;
    for (const int v : soup.faces[face]) {
      const Vec3 arm = soup.positions[v] - fit.centre;
      const double height = arm.dot(fit.normal);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
      fit.extent = std::max(fit.extent, 2 * arm.norm());
    }
  }
  fit.centre += 0.5 * (lowest + highest) * fit.normal;
  fit.deviation = 0.5 * (highest - lowest);
  return fit;
}

}  // namespace foldwright
