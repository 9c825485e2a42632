#pragma once

#include <span>

#include "mesh/mesh.h"
#include "svg_canvas.h"

namespace foldwright::testing {

/// Where a picture of a mesh is seen from. \pre not parallel
struct Eye {
  Vec3 toward = {0.45, 0.35, 1};  ///< from the model to the eye, infinitely far away
  Vec3 up = {0, 1, 0};
};

/// An eye that sees the widest side of a mesh, a little from above; from behind with `behind`. The
/// mesh stands as it is read: `up` is the axis of the file nearest to what stands upright then.
Eye widest_eye(const Mesh& mesh, bool behind = false);

/// Draws a mesh in the middle of the box in the colours of its parts, one label per face, with
/// lines along their borders. Faces are drawn from the farthest to the nearest by their centroids,
/// so that long thin ones may hide what is before them.
void draw_mesh(SvgCanvas& canvas, const PictureBox& box, const Mesh& mesh,
               std::span<const int> labels, const Eye& eye = {});

}  // namespace foldwright::testing
