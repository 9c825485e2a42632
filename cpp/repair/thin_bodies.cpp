#include "repair/thin_bodies.h"

#include <cmath>
#include <vector>

namespace foldwright {
namespace {

struct Body {
  double volume = 0;   // six times it
  double area = 0;     // twice it
  int reference = -1;  // a vertex: volumes far from the origin lose digits
  bool is_open = false;
};

}  // namespace

ThinBodies find_thin_bodies(const Mesh& mesh, double tolerance) {
  std::vector<Body> bodies(mesh.component_count);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    Body& body = bodies[mesh.components[f]];
    if (body.reference == -1) body.reference = a;
    const auto& p = mesh.positions;
    const Vec3 normal = (p[b] - p[a]).cross(p[c] - p[a]);
    body.volume += normal.dot(p[a] - p[body.reference]);
    body.area += normal.norm();
  }
  for (const Mesh::Edge& edge : mesh.edges) {
    if (edge.faces[1] == -1) bodies[mesh.components[edge.faces[0]]].is_open = true;
  }
  ThinBodies thin;
  for (const Body& body : bodies) {
    thin.open += body.is_open;
    // Two layers of half the area each, the volume between them as high as the body is thick.
    const double thickness = 2 * (std::abs(body.volume) / 6) / (body.area / 2);
    thin.flat += !body.is_open && thickness <= 2 * tolerance;
  }
  return thin;
}

}  // namespace foldwright
