#include "paper/contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/box_pairs.h"
#include "geometry/convex2.h"

namespace foldwright {
namespace {

// How far panels that touch are from each other, in mean edge lengths, and from being parallel.
constexpr double kTouching = 1e-3;
constexpr double kParallel = 1e-3;

// Shorter lines, in mean edge lengths, only touch a face.
constexpr double kShortest = 1e-2;

/// A panel in space.
struct Plane {
  Vec3 normal, centroid;
  double area;
  int body;
  Box3 box;
};

Vec3 area_vector(const Mesh& mesh, int face) {
  const auto& [a, b, c] = mesh.faces[face];
  const Vec3& origin = mesh.positions[a];
  return 0.5 * (mesh.positions[b] - origin).cross(mesh.positions[c] - origin);
}

std::vector<Plane> planes_of(const Mesh& mesh, const DualGraph& graph) {
  std::vector<Plane> planes;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    Vec3 sum = Vec3::Zero();
    Vec3 centroid = Vec3::Zero();
    Eigen::AlignedBox3d box;
    for (const int face : graph.panel_faces(panel)) {
      const Vec3 area = area_vector(mesh, face);
      sum += area;
      for (const int v : mesh.faces[face]) {
        centroid += area.norm() / 3 * mesh.positions[v];
        box.extend(mesh.positions[v]);
      }
    }
    const double reach = kTouching * graph.unit;
    const Box3 reached = {{box.min().x() - reach, box.min().y() - reach, box.min().z() - reach},
                          {box.max().x() + reach, box.max().y() + reach, box.max().z() + reach}};
    planes.push_back({sum.normalized(), centroid / graph.areas[panel], graph.areas[panel],
                      mesh.components[graph.panel_faces(panel)[0]], reached});
  }
  return planes;
}

std::vector<double> body_areas(const std::vector<Plane>& planes, int bodies) {
  std::vector<double> areas(bodies, 0);
  for (const Plane& plane : planes) areas[plane.body] += plane.area;
  return areas;
}

bool do_touch(const Plane& a, const Plane& b, double unit) {
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
      // On a side it counts for one of the two faces there, whichever it is.
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

/// The borders of a panel, as segments.
std::vector<std::array<Vec3, 2>> rim_of(const Mesh& mesh, std::span<const int> faces) {
  std::vector<std::array<Vec3, 2>> rim;
  for (const int face : faces) {
    for (const int e : mesh.face_edges[face]) {
      const auto& [a, b] = mesh.edges[e].faces;
      const int other = a == face ? b : a;
      if (std::ranges::binary_search(faces, other)) continue;
      const auto& [v, w] = mesh.edges[e].vertices;
      rim.push_back({mesh.positions[v], mesh.positions[w]});
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
  const std::vector<Plane> planes = planes_of(mesh, graph);
  const std::vector<double> areas = body_areas(planes, mesh.component_count);
  std::vector<Box3> boxes;
  for (const Plane& plane : planes) boxes.push_back(plane.box);
  for (const auto& [a, b] : meeting_boxes(boxes)) {
    if (planes[a].body == planes[b].body || !do_touch(planes[a], planes[b], graph.unit)) continue;
    // The smaller body stands on the larger one, of equals the later one.
    const auto rank = [&](int panel) {
      return std::pair(areas[planes[panel].body], -planes[panel].body);
    };
    const auto [guest, host] = rank(a) < rank(b) ? std::pair(a, b) : std::pair(b, a);
    const std::span<const int> faces = graph.panel_faces(guest);
    for (const auto& [from, to] : rim_of(mesh, faces)) {
      for (const int face : graph.panel_faces(host)) {
        const auto& [i, j, k] = mesh.faces[face];
        const auto part = clipped({mesh.positions[i], mesh.positions[j], mesh.positions[k]},
                                  planes[host].normal, from, to);
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
