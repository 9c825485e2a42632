#pragma once

#include <array>
#include <map>
#include <span>

#include "paper/flaps.h"
#include "paper/seams.h"

namespace foldwright {

/// Which of a seam's sides may have flaps, and whether all of them are to.
struct FlapWish {
  std::array<bool, 2> allowed;
  bool both;
};

/// What is asked for at the edges of a mesh: the options for all of them and what a person decided
/// about single ones.
class FlapWishes {
 public:
  /// Keeps `mesh` and `options`. \throw InputError if a choice names an edge that the mesh has not
  FlapWishes(const Mesh& mesh, const FlapOptions& options);

  FlapWish of(const Seam& seam, std::span<const Net> nets) const;

  /// Whether a border along these edges of the mesh may have a flap.
  bool allow_border(std::span<const int> mesh_edges) const;

  /// How flaps along these edges of the mesh may look.
  FlapShape shape_at(std::span<const int> mesh_edges) const;

 private:
  /// What a person decided about an edge, seen along it as the mesh has it.
  struct EdgeChoice {
    EdgeFlaps flaps;
    double height;  ///< mm; 0: as all others
    int order;      ///< among all choices
  };

  /// The latest choice for one of these edges, with the edge; null: none.
  const std::pair<const int, EdgeChoice>* choice_at(std::span<const int> mesh_edges) const;

  const Mesh& mesh_;
  const FlapOptions& options_;
  std::map<int, EdgeChoice> choices_;  ///< by mesh edge
};

}  // namespace foldwright
