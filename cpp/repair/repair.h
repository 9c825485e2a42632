#pragma once

#include <vector>

#include "mesh/corner_origin.h"
#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"
#include "repair/repair_steps.h"
#include "repair/solids.h"

namespace foldwright {

struct RepairOptions {
  /// Vertices nearer than this share of the bounding box's diagonal become one. Exporters round to
  /// six or seven digits, so genuine detail lies well above it and copies well below.
  double weld_tolerance = 1e-6;
  /// Cracks between borders up to this share of the bounding box's diagonal are closed, unless they
  /// are wider than a tenth of the edges beside them: a tenth of a millimetre on ten centimetres.
  double widest_crack = 1e-3;
  /// Holes up to this share of the longest side of the bounding box across are filled; 0: none.
  double fill_holes = 0;
  bool drop_inner = false;  ///< leave out bodies that lie inside others
  bool unite = false;       ///< make one surface of closed bodies that run through each other
  SolidUniter uniter = {};  ///< does that; without it nothing is united
  RepairSteps off = {};     ///< steps that are not done; what they would do is told ("step-off")

  bool does(RepairStep step) const { return !off[static_cast<std::size_t>(step)]; }
};

/// A mesh that can be unfolded, and what had to be done to the input for it.
struct RepairedModel {
  Mesh mesh;
  std::vector<Repair> repairs;  ///< the reader's notes first, then one entry per kind of repair
  int source_face_count = 0;  ///< faces of the file as read; a dropped one is in no `source_faces`
  int unusable_faces = 0;     ///< of those, the ones of which the reader could use no corner
  /// Per face of the mesh: the places in the file that its corners come from. Where vertices were
  /// moved, these are the places before; those of a face that fills a hole are in faces beside it.
  std::vector<FaceOrigins> origins;
  Vec3 centre = Vec3::Zero();  ///< where the mesh's origin lies in the coordinates of the polygons
  /// No corner of a face of the file lies further from its place there than this, in model units,
  /// but for the shift to the centre: what welding, closing cracks and flattening came to.
  double largest_move = 0;
};

/// Turns polygons into an oriented manifold triangle mesh, and reports everything it changed.
///
/// Vertices are welded, polygons triangulated, degenerate and duplicate faces dropped, surfaces
/// given from both sides made one skin, T-junctions and cracks closed, holes filled if that is
/// asked for (`fill_holes`), winding made consistent and outward per component, non-manifold edges
/// and vertices split, non-orientable surfaces cut open. Cavities keep their winding, and bodies
/// inside others are left out if that is asked for (`mend_bodies`). What was drawn flat is made
/// flat as far as the file's precision explains that it is not (`find_drawn_planes`). Bodies that
/// run through each other are told of, and united if that is asked for (`unite_bodies`). Each
/// component of an open surface keeps the winding that the majority of its area has in the file.
/// The bounding box is centred at the origin. Whatever is done to a face, its corners know their
/// places in the file. \throw InputError when no usable face is left
///
/// Any `StepKind::kSwitch` of `kRepairSteps` may be off, and what comes out is an oriented manifold
/// all the same: faces that the file winds against each other come apart, for one. What bodies were
/// united to is wound outwards in any case, and with it all other faces. \pre no other step is off
RepairedModel repair(const PolygonSoup& soup, const RepairOptions& options = {});

}  // namespace foldwright
