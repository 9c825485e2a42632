#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "geometry/rigid_motion.h"
#include "geometry/triangle2.h"
#include "mesh/mesh.h"

namespace foldwright {

/// Faces flatter to each other than this form one panel: 0.001 degrees, in radians. Far below what
/// paper can show, far above the rounding of coordinates written with nine digits.
inline constexpr double kPanelAngle = 0.001 * 3.14159265358979323846 / 180;

/// Along a chain of nearly coplanar faces the angles add up. A panel's faces stay this close to its
/// largest one, so that its flat copy is congruent to 1e-8 (half the square of the angle).
inline constexpr double kPanelDrift = 5 * kPanelAngle;

/// The line along which two panels meet: one mesh edge, or several collinear ones.
struct Hinge {
  std::array<int, 2> panels;  ///< indices into the graph, `panels[0] < panels[1]`
  std::vector<int> edges;     ///< mesh edges, ascending
  double angle;               ///< fold angle in radians: valley positive, mountain negative
  double length;              ///< model units
  RigidMotion2 lay;           ///< lays `panels[1]` beside `panels[0]`, in the latter's coordinates
  std::array<Vec2, 2> line;   ///< of its first edge, in those: `panels[0]` lies on the left
  bool stays_fold = false;    ///< it is never to be cut

  int other(int panel) const { return panels[0] == panel ? panels[1] : panels[0]; }
};

/// Panels (maximal sets of coplanar neighbouring faces) and the hinges between them.
///
/// This is the dual graph that unfoldings are spanning trees of, with coplanar faces contracted:
/// edges inside a panel are never cut nor drawn. It may describe a whole mesh or some panels of it.
struct DualGraph {
  std::vector<int> first_face = {0};  ///< CSR over panels into `faces` and `triangles`
  std::vector<int> faces;             ///< mesh faces, panel by panel, ascending within one
  std::vector<Triangle2> triangles;   ///< each face in its panel's coordinates, model units
  std::vector<double> areas;          ///< per panel
  std::vector<Hinge> hinges;
  std::vector<int> first_hinge = {0};  ///< CSR over panels into `incident`
  std::vector<int> incident;           ///< hinges of each panel, ascending
  double unit = 1;                     ///< mean edge length: the scale tolerances are relative to

  int panel_count() const { return static_cast<int>(first_face.size()) - 1; }
  int hinge_count() const { return static_cast<int>(hinges.size()); }

  std::span<const int> panel_faces(int panel) const {
    return std::span(faces).subspan(first_face[panel], first_face[panel + 1] - first_face[panel]);
  }
  std::span<const Triangle2> panel_triangles(int panel) const {
    return std::span(triangles).subspan(first_face[panel],
                                        first_face[panel + 1] - first_face[panel]);
  }
  std::span<const int> hinges_of(int panel) const {
    return std::span(incident).subspan(first_hinge[panel],
                                       first_hinge[panel + 1] - first_hinge[panel]);
  }
  /// Motion that lays `panel` beside its neighbour across `hinge`, in the neighbour's coordinates.
  RigidMotion2 lay_beside(int hinge, int panel) const {
    const Hinge& h = hinges[hinge];
    return h.panels[1] == panel ? h.lay : h.lay.inverse();
  }
};

/// Fold angle of an inner edge in radians, in [-pi, pi): 0 flat, valley (concave) positive,
/// mountain (convex) negative. Faces folded onto each other count as a mountain.
double fold_angle(const Mesh& mesh, int edge);

/// A person's wish that an edge is always a fold, or never one.
struct EdgeLock {
  std::array<int, 2> vertices;  ///< of the mesh, in either order
  bool is_fold;
};

/// The dual graph of the whole mesh. Panels are numbered by their lowest face; they grow from their
/// largest one, and also take in needles that lie in its plane up to rounding, whose own normals
/// tell nothing.
DualGraph build_dual_graph(const Mesh& mesh);

/// A graph as its locks leave it: a hinge with an edge that is never to be a fold is not in it, one
/// with an edge that is always to be one `stays_fold`. Locks of edges that are on no hinge do
/// nothing.
DualGraph lock_edges(const Mesh& mesh, DualGraph graph, std::span<const EdgeLock> locks);

/// Whether a body was drawn in polygons rather than in triangles: on average at least three faces
/// in two panels. Only such bodies have walls and lids, and edges of very different lengths.
bool is_of_polygons(const DualGraph& graph);

/// The part of `graph` made of `panels` (ascending), with the hinges between them.
DualGraph restrict_to(const DualGraph& graph, std::span<const int> panels);

/// Hinges of a graph by their first mesh edge, which names them in every graph that has them.
std::map<int, int> hinges_by_edge(const DualGraph& graph);

}  // namespace foldwright
