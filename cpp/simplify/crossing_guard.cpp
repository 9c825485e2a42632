#include "simplify/crossing_guard.h"

#include <algorithm>
#include <cassert>

#include "geometry/face_contact.h"

namespace foldwright {
namespace {

int shared_vertices(const FaceVertices& a, const FaceVertices& b) {
  int shared = 0;
  for (const int v : a) shared += std::ranges::count(b, v) > 0;
  return shared;
}

}  // namespace

CrossingGuard::CrossingGuard(int faces, double usual_edge, double extent)
    : grid_(faces, usual_edge), extent_(extent), held_(faces), seen_(faces, 0) {}

void CrossingGuard::set(int face, const FaceVertices& vertices, const Triangle3& corners) {
  if (held_[face].is_held) remove(face);
  held_[face] = {vertices, corners, true};
  grid_.insert(face, box_of(corners));
}

void CrossingGuard::remove(int face) {
  assert(held_[face].is_held);
  held_[face].is_held = false;
  grid_.remove(face, box_of(held_[face].corners));
}

int CrossingGuard::crossings(const FaceVertices& vertices, const Triangle3& corners,
                             std::span<const int> left_out) {
  ++query_;
  for (const int face : left_out) seen_[face] = query_;
  int count = 0;
  const Box3 box = box_of(corners);
  grid_.visit(box, [&](int face) {
    if (seen_[face] == query_) return true;
    seen_[face] = query_;
    const Held& other = held_[face];
    if (box.meets(box_of(other.corners)) && shared_vertices(vertices, other.vertices) < 2) {
      count += faces_cross(corners, other.corners, extent_);
    }
    return true;
  });
  return count;
}

}  // namespace foldwright
