#include "paper/contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/box_pairs.h"
#include "geometry/convex2.h"
#include "mesh/panel_places.h"

namespace foldwright {
namespace {

// How far panels that touch are from each other, in mean edge lengths, and from being parallel.
constexpr double kTouching = 1e-3;
constexpr double kParallel = 1e-3;

// How far beside their places lines are cut at the edges of faces, in mean edge lengths.
constexpr double kAside = 1e-6;

// Shorter lines, in mean edge lengths, only touch a face.
constexpr double kShortest = 1e-2;

/// The box of a panel, and what may touch it.
Box3 reach_of(const Mesh& mesh, const DualGraph& graph, int panel) {
  Eigen::AlignedBox3d box;
  for (const int face : graph.panel_faces(panel)) {
    for (const int v : mesh.faces[face]) box.extend(mesh.positions[v]);
  }
  const Box3 tight = {{box.min().x(), box.min().y(), box.min().z()},
                      {box.max().x(), box.max().y(), box.max().z()}};
  return tight.grown(kTouching * graph.unit);
}

bool do_touch(const PanelPlace& a, const PanelPlace& b, double unit) {
  return (a.normal + b.normal).norm() < kParallel &&
         std::abs(a.normal.dot(b.centroid - a.centroid)) < kTouching * unit;
}

/// The part of a segment within a triangle, seen along its normal.
std::optional<std::array<Vec3, 2>> clipped(const std::array<Vec3, 3>& triangle, const Vec3& normal,
                                           const Vec3& from, const Vec3& to) {
  double enter = 0;
  double leave = 1;
  for (int i = 0; i < 3; ++i) {
    const Vec3 inwards = normal.cross(triangle[(i + 1) % 3] - triangle[i]);
    const double start = inwards.dot(from - triangle[i]);
    const double step = inwards.dot(to - from);
    if (std::abs(step) < 1e-12 * inwards.squaredNorm()) {
      if (start < 0) return std::nullopt;
      continue;
    }
    const double at = -start / step;
    if (step > 0) enter = std::max(enter, at);
    if (step < 0) leave = std::min(leave, at);
  }
  if (enter >= leave) return std::nullopt;
  return std::array<Vec3, 2>{from + enter * (to - from), from + leave * (to - from)};
}

/// The borders of a panel, as segments that have it on their left.
std::vector<std::array<Vec3, 2>> rim_of(const Mesh& mesh, std::span<const int> faces) {
  std::vector<std::array<Vec3, 2>> rim;
  for (const int face : faces) {
    for (const int e : mesh.face_edges[face]) {
      const auto& [a, b] = mesh.edges[e].faces;
      const int other = a == face ? b : a;
      if (std::ranges::binary_search(faces, other)) continue;
      const auto& [v, w] = mesh.edges[e].vertices;
      const auto& [from, to] = a == face ? std::pair(v, w) : std::pair(w, v);
      rim.push_back({mesh.positions[from], mesh.positions[to]});
    }
  }
  return rim;
}

/// A point of a face where the face lies in a net.
Vec2 laid(const Mesh& mesh, const Net& net, std::size_t at, const Vec3& p) {
  const auto& [a, b, c] = mesh.faces[net.faces[at]];
  const Vec3& origin = mesh.positions[a];
  const Vec3 u = mesh.positions[b] - origin;
  const Vec3 v = mesh.positions[c] - origin;
  const Vec3 normal = u.cross(v);
  const double s = (p - origin).cross(v).dot(normal) / normal.squaredNorm();
  const double t = u.cross(p - origin).dot(normal) / normal.squaredNorm();
  const auto& [i, j, k] = net.corners[at];
  const Vec2& start = net.vertices[i];
  return start + s * (net.vertices[j] - start) + t * (net.vertices[k] - start);
}

}  // namespace

std::vector<Contact> find_contacts(const Mesh& mesh, const DualGraph& graph) {
  std::vector<Contact> contacts;
  if (mesh.component_count < 2) return contacts;
  const std::vector<PanelPlace> places = panel_places(mesh, graph);
  std::vector<double> areas(mesh.component_count, 0);
  std::vector<int> body;
  std::vector<Box3> boxes;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    body.push_back(mesh.components[graph.panel_faces(panel)[0]]);
    areas[body[panel]] += graph.areas[panel];
    boxes.push_back(reach_of(mesh, graph, panel));
  }
  for (const auto& [a, b] : meeting_boxes(boxes)) {
    if (body[a] == body[b] || !do_touch(places[a], places[b], graph.unit)) continue;
    // The smaller body stands on the larger one, of equals the later one.
    const auto rank = [&](int panel) { return std::pair(areas[body[panel]], -body[panel]); };
    const auto [guest, host] = rank(a) < rank(b) ? std::pair(a, b) : std::pair(b, a);
    const std::span<const int> faces = graph.panel_faces(guest);
    for (const auto& [from, to] : rim_of(mesh, faces)) {
      // A hair outside of the guest: a rim along a diagonal of the host lies in one face then, and
      // one along the host's own rim, where a line is drawn anyway, in none.
      const Vec3 aside = kAside * graph.unit * (to - from).cross(places[guest].normal).normalized();
      for (const int face : graph.panel_faces(host)) {
        const auto& [i, j, k] = mesh.faces[face];
        const auto part = clipped({mesh.positions[i], mesh.positions[j], mesh.positions[k]},
                                  places[host].normal, from + aside, to + aside);
        if (!part || ((*part)[1] - (*part)[0]).norm() < kShortest * graph.unit) continue;
        contacts.push_back({face, faces[0], (*part)[0], (*part)[1]});
      }
    }
  }
  return contacts;
}

Standings standings_on(const Mesh& mesh, const Net& net, std::span<const Contact> contacts) {
  Standings standings;
  std::map<int, std::vector<Vec2>> points;  // by guest
  for (const Contact& contact : contacts) {
    const auto found = std::ranges::lower_bound(net.faces, contact.host);
    if (found == net.faces.end() || *found != contact.host) continue;
    const auto at = static_cast<std::size_t>(found - net.faces.begin());
    const Stroke line = {laid(mesh, net, at, contact.from), laid(mesh, net, at, contact.to)};
    standings.lines.push_back(line);
    points[contact.guest].push_back(line.from);
    points[contact.guest].push_back(line.to);
  }
  for (const auto& [guest, of_guest] : points) {
    const Box2 box = box_of(of_guest);
    const Vec2 centre(0.5 * (box.min[0] + box.max[0]), 0.5 * (box.min[1] + box.max[1]));
    standings.names.push_back({guest, centre});
  }
  return standings;
}

}  // namespace foldwright
