#include "mesh_faults.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "mesh/surface_tree.h"
#include "meshes.h"

namespace foldwright::testing {
namespace {

bool has_one_fan_per_vertex(const Mesh& mesh) {
  // Following the faces of a vertex from edge to edge has to meet all of them.
  std::vector<std::map<int, int>> next_around(mesh.vertex_count());
  for (const auto& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) next_around[face[i]][face[(i + 1) % 3]] = face[(i + 2) % 3];
  }
  for (const auto& next : next_around) {
    if (next.empty()) return false;  // unused
    std::set<int> reached_from_others;
    for (const auto& [from, to] : next) reached_from_others.insert(to);
    int start = next.begin()->first;
    for (const auto& [from, to] : next) {
      if (!reached_from_others.contains(from)) start = from;  // first face of an open fan
    }
    std::size_t faces = 0;
    int at = start;
    do {
      at = next.at(at);
      ++faces;
    } while (at != start && next.contains(at));
    if (faces != next.size()) return false;
  }
  return true;
}

std::string edge_fault(const Mesh& mesh) {
  std::set<std::pair<int, int>> directed;
  for (const auto& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      const int a = face[i];
      const int b = face[(i + 1) % 3];
      if (a == b) return "a face uses a vertex twice";
      if (!directed.insert({a, b}).second) return "an edge is used twice in the same direction";
    }
  }
  return "";
}

std::string volume_fault(const Mesh& mesh) {
  std::vector<char> is_open(mesh.component_count, false);
  for (const Mesh::Edge& edge : mesh.edges) {
    if (edge.faces[1] == -1) is_open[mesh.components[edge.faces[0]]] = true;
  }
  std::vector<double> volume(mesh.component_count, 0);
  std::vector<double> area(mesh.component_count, 0);
  std::vector<Vec3> reference(mesh.component_count);
  for (int f = mesh.face_count() - 1; f >= 0; --f) {
    reference[mesh.components[f]] = mesh.positions[mesh.faces[f][0]];
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3& origin = reference[mesh.components[f]];
    volume[mesh.components[f]] +=
        (mesh.positions[a] - origin)
            .dot((mesh.positions[b] - origin).cross(mesh.positions[c] - origin));
    area[mesh.components[f]] += face_area(mesh, f);
  }
  for (int c = 0; c < mesh.component_count; ++c) {
    // A sheet with two sides encloses nothing, up to rounding.
    if (!is_open[c] && volume[c] < -1e-8 * std::pow(area[c], 1.5))
      return "a closed component is wound inwards";
  }
  return "";
}

/// What is wrong with an origin, whatever it is the origin of.
std::string place_fault(const PolygonSoup& soup, const CornerOrigin& origin) {
  if (origin.face < 0 || origin.face >= soup.face_count()) return "an origin is in no face";
  const int count = soup.first_corner[origin.face + 1] - soup.first_corner[origin.face];
  const auto& [a, b, c] = origin.corners;
  if (a == b || b == c || c == a) return "an origin is between equal corners";
  for (const int corner : origin.corners) {
    if (corner < 0 || corner >= count) return "an origin is between corners that do not exist";
  }
  if (origin.weights.minCoeff() < 0) return "an origin is outside its corners";
  if (std::abs(origin.weights.sum() - 1) > 1e-12) return "an origin's weights do not add up";
  return "";
}

/// How far the file's own coordinates may be rounded by the sums of this test and of the repair.
double rounding(const PolygonSoup& soup) {
  double largest = 0;
  for (const int v : soup.corners) {
    largest = std::max(largest, soup.positions[v].cwiseAbs().maxCoeff());
  }
  return 1e-14 * largest;
}

}  // namespace

std::string fault_of(const Mesh& mesh) {
  if (mesh.faces.empty()) return "no faces";
  if (const std::string fault = edge_fault(mesh); !fault.empty()) return fault;
  if (!has_one_fan_per_vertex(mesh)) return "a vertex has no or several fans";
  Eigen::AlignedBox3d box;
  for (const Vec3& position : mesh.positions) box.extend(position);
  const double diagonal = box.diagonal().norm();
  if (box.center().norm() > 1e-9 * diagonal) return "the bounding box is not centred";
  for (int f = 0; f < mesh.face_count(); ++f) {
    // A quarter of what the repair drops, since it may halve a face's edges afterwards.
    if (face_area(mesh, f) < 0.24e-12 * diagonal * diagonal) return "a face has no area";
  }
  return volume_fault(mesh);
}

std::string bookkeeping_fault_of(const RepairedModel& model) {
  const std::set<int> present(model.mesh.source_faces.begin(), model.mesh.source_faces.end());
  if (*present.begin() < 0 || *present.rbegin() >= model.source_face_count) {
    return "a source face does not exist";
  }
  std::set<std::string> codes;
  int dropped = 0;
  for (const Repair& repair : model.repairs) {
    if (!codes.insert(repair.code).second) return "reported twice: " + repair.code;
    if (repair.count <= 0) return "reports nothing: " + repair.code;
    const bool drops_faces = repair.code.starts_with("dropped-") && repair.code.ends_with("-faces");
    if (drops_faces || repair.code == "merged-two-sided") {
      dropped += repair.count;
    }
  }
  const int accounted = static_cast<int>(present.size()) + dropped;
  return accounted == model.source_face_count ? "" : "source faces are unaccounted for";
}

std::string origin_fault_of(const PolygonSoup& soup, const RepairedModel& model) {
  for (int f = 0; f < model.mesh.face_count(); ++f) {
    for (const CornerOrigin& origin : model.origins[f]) {
      if (origin.face != model.mesh.source_faces[f]) return "an origin is in another face";
    }
  }
  return origin_fault_of(soup, model, model.mesh, model.origins);
}

std::string origin_fault_of(const PolygonSoup& soup, const RepairedModel& model, const Mesh& simple,
                            const std::vector<FaceOrigins>& origins) {
  if (origins.size() != simple.faces.size()) return "the origins are not those of all faces";
  const SurfaceTree surface(model.mesh);
  const double tolerance = model.largest_move + rounding(soup);
  for (int f = 0; f < simple.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const CornerOrigin& origin = origins[f][i];
      if (const std::string fault = place_fault(soup, origin); !fault.empty()) return fault;
      const Vec3& corner = simple.positions[simple.faces[f][i]];
      const double off = (position_at(soup, origin) - model.centre - corner).norm();
      if (off <= tolerance) continue;
      const int nearest = surface.nearest(corner, 0);
      const double distance = std::sqrt(surface.squared_distance(nearest, corner));
      if (off > distance + tolerance) {
        return "a corner is " + std::to_string(off) + " from where it comes from, not " +
               std::to_string(distance + tolerance);
      }
    }
  }
  return "";
}

}  // namespace foldwright::testing
