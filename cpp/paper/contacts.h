#pragma once

#include <span>
#include <vector>

#include "paper/text_box.h"
#include "unfold/net.h"

namespace foldwright {

/// A piece of the rim of what stands flat on another body: studs on a chest, a house on its plot.
struct Contact {
  int host;       ///< face that it stands on
  int guest;      ///< lowest face of the flat panel that stands there
  Vec3 from, to;  ///< within the host's face, model units
};

/// Where panels of bodies lie on panels of larger ones, face to face, to a thousandth of the mean
/// edge length: the rims of the smaller ones, cut at the edges of the others' faces. Near-linear in
/// panels; for two that touch, edges of the one times faces of the other.
std::vector<Contact> find_contacts(const Mesh& mesh, const DualGraph& graph);

/// What is to be drawn on a net where others stand.
struct Standings {
  std::vector<Stroke> lines;
  struct Name {
    int guest;    ///< as `Contact` has it
    Vec2 centre;  ///< of its lines
  };
  std::vector<Name> names;  ///< one for each guest
};

/// The contacts whose hosts are faces of a net, where that lies. `contacts`: of the net's mesh
Standings standings_on(const Mesh& mesh, const Net& net, std::span<const Contact> contacts);

}  // namespace foldwright
