#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/dual_graph.h"
#include "paper/mesh_panels.h"
#include "paper/room_profile.h"

namespace foldwright {

/// What is known of a cut edge whose other side is in another piece.
struct BorderRoom {
  int mesh_edge;
  double height;  ///< of the flap that may be counted on there, mm; 0: none
};

/// One copy of a run of edges that may be cut, all along one hinge; mm.
struct CraftSide {
  int slot, corner;    ///< the face of its first edge in the graph, and the corner it starts from
  double edge_length;  ///< of the first edge
  double length;       ///< of the whole run
  FlapCover cover;     ///< the panel across
  double open;         ///< height of the flap where nothing is in the way
};

/// The sides of one run.
struct CraftSeam {
  int mesh_edge;             ///< the lowest of the run
  int hinge;                 ///< -1 at the border of the piece
  std::array<int, 2> sides;  ///< second: -1 at the border
  double elsewhere;          ///< height to be counted on in another piece
};

/// All that may be cut of a piece and is long enough to want a flap. Along a hinge a straight run
/// counts once; at the border of the piece each edge stands for itself.
struct CraftSides {
  std::vector<CraftSide> sides;  ///< by slot
  std::vector<int> first_side;   ///< CSR over slots into `sides`
  std::vector<int> seam_of_side;
  std::vector<CraftSeam> seams;
  std::vector<std::vector<int>> seams_of_hinge;
};

/// How the sides of cuts are measured.
struct CraftMeasure {
  double scale;     ///< mm per model unit
  FlapShape probe;  ///< the flap that `open` is measured with
  /// Edges at the border of the piece count where one of these names them.
  std::span<const BorderRoom> borders = {};
};

CraftSides craft_sides(const Mesh& mesh, const DualGraph& graph, const CraftMeasure& measure);

}  // namespace foldwright
