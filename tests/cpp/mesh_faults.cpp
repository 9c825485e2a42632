#include "mesh_faults.h"

#include <algorithm>
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

/// What a component of a mesh encloses.
struct Enclosed {
  bool is_open = false;
  double volume = 0;  // six times it
  double area = 0;
  Vec3 reference = Vec3::Zero();  // a corner: volumes far from the origin lose digits
  Eigen::AlignedBox3d box;
};

std::vector<Enclosed> measure_components(const Mesh& mesh) {
  std::vector<Enclosed> components(mesh.component_count);
  for (const Mesh::Edge& edge : mesh.edges) {
    if (edge.faces[1] == -1) components[mesh.components[edge.faces[0]]].is_open = true;
  }
  for (int f = mesh.face_count() - 1; f >= 0; --f) {
    components[mesh.components[f]].reference = mesh.positions[mesh.faces[f][0]];
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    Enclosed& of = components[mesh.components[f]];
    const auto from = [&](int v) { return Vec3(mesh.positions[v] - of.reference); };
    of.volume += from(a).dot(from(b).cross(from(c)));
    of.area += face_area(mesh, f);
    for (const int v : mesh.faces[f]) of.box.extend(mesh.positions[v]);
  }
  return components;
}

std::string volume_fault(const Mesh& mesh) {
  const std::vector<Enclosed> components = measure_components(mesh);
  for (const Enclosed& inner : components) {
    // A sheet with two sides encloses nothing, up to rounding.
    if (inner.is_open || inner.volume >= -1e-8 * std::pow(inner.area, 1.5)) continue;
    // Only cavities are wound inwards.
    const bool is_cavity = std::any_of(components.begin(), components.end(), [&](const auto& c) {
      return !c.is_open && c.volume > -inner.volume && c.box.contains(inner.box);
    });
    if (!is_cavity) return "a closed component is wound inwards";
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

std::string fault_of_centred(Mesh mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  for (Vec3& p : mesh.positions) p -= box.center();
  return fault_of(mesh);
}

std::string bookkeeping_fault_of(const RepairedModel& model) {
  std::set<int> present(model.mesh.source_faces.begin(), model.mesh.source_faces.end());
  present.erase(-1);  // fills a hole
  if (*present.begin() < 0 || *present.rbegin() >= model.source_face_count) {
    return "a source face does not exist";
  }
  std::set<std::string> codes;
  int dropped = 0;
  for (const Repair& repair : model.repairs) {
    // Steps that are off are told one by one.
    const bool is_off = repair.code == "step-off";
    const std::string name =
        repair.code + (is_off ? std::get<std::string>(repair.parameters.at(0).value) : "");
    if (!codes.insert(name).second) return "reported twice: " + name;
    if (repair.count <= 0) return "reports nothing: " + repair.code;
    const bool drops_faces = repair.code.starts_with("dropped-") && repair.code.ends_with("-faces");
    if (drops_faces || repair.code == "merged-two-sided") {
      dropped += repair.count;
    }
    for (const auto& [name, value] : repair.parameters) {
      if (repair.code == "dropped-inner-bodies" || repair.code == "united-bodies")
        dropped += static_cast<int>(std::get<double>(value));
    }
  }
  const int accounted = static_cast<int>(present.size()) + dropped;
  return accounted == model.source_face_count ? "" : "source faces are unaccounted for";
}

std::string origin_fault_of(const PolygonSoup& soup, const RepairedModel& model) {
  for (int f = 0; f < model.mesh.face_count(); ++f) {
    const int source = model.mesh.source_faces[f];
    for (const CornerOrigin& origin : model.origins[f]) {
      // What fills a hole looks like a face beside it.
      const int expected = source == -1 ? model.origins[f][0].face : source;
      if (origin.face != expected) return "an origin is in another face";
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
      if (simple.source_faces[f] == -1) continue;  // fills a hole
      const Vec3& corner = simple.positions[simple.faces[f][i]];
      const double off = (position_at(soup, origin) - model.centre - corner).norm();
      if (off <= tolerance) continue;
      const int nearest = surface.nearest(corner, 0);
      const double distance = std::sqrt(surface.squared_distance(nearest, corner));
      // Faces that are as near up to rounding may stand for the nearest one, see `carry_origins`.
      const double rounded = 1e-6 * box_of(corners_of(simple, f)).diagonal();
      if (off > distance + tolerance + rounded) {
        return "a corner is " + std::to_string(off) + " from where it comes from, not " +
               std::to_string(distance + tolerance);
      }
    }
  }
  return "";
}

}  // namespace foldwright::testing
