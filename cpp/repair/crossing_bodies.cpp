#include "repair/crossing_bodies.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/box_pairs.h"
#include "geometry/face_contact.h"
#include "geometry/triangle3.h"

namespace foldwright {
namespace {

constexpr int kMostFaces = 200'000;

Triangle3 corners_of(const TriangleSoup& soup, int face) {
  const auto& [a, b, c] = soup.faces[face];
  return {soup.positions[a], soup.positions[b], soup.positions[c]};
}

int shared_corners(const TriangleSoup& soup, int face, int other) {
  int shared = 0;
  for (const int v : soup.faces[face]) shared += std::ranges::count(soup.faces[other], v) > 0;
  return shared;
}

double extent_of(const TriangleSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const auto& face : soup.faces) {
    for (const int v : face) box.extend(soup.positions[v]);
  }
  return box.diagonal().norm();
}

}  // namespace

Crossings find_crossings(const TriangleSoup& soup, std::span<const int> bodies) {
  Crossings crossings;
  if (soup.face_count() > kMostFaces) {
    crossings.checked = false;
    return crossings;
  }
  const double extent = extent_of(soup);
  std::vector<Box3> boxes;
  for (int f = 0; f < soup.face_count(); ++f) boxes.push_back(box_of(corners_of(soup, f)));
  std::set<std::pair<int, int>> found;
  const bool is_one_body =
      std::ranges::adjacent_find(bodies, std::ranges::not_equal_to()) == bodies.end();
  visit_meeting_boxes(boxes, [&](int f, int g) {
    const std::pair<int, int> pair = std::minmax(bodies[f], bodies[g]);
    // One crossing of two bodies says it all; damaged models have one of nearly every two faces.
    if (found.contains(pair) || shared_corners(soup, f, g) > 0) return true;
    if (faces_cross(corners_of(soup, f), corners_of(soup, g), extent)) found.insert(pair);
    return found.empty() || !is_one_body;
  });
  for (const auto& [body, other] : found) {
    if (body == other) {
      crossings.bodies.push_back(body);
    } else {
      crossings.pairs.emplace_back(body, other);
    }
  }
  return crossings;
}

}  // namespace foldwright
