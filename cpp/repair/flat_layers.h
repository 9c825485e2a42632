#pragma once

#include <vector>

#include "repair/edge_groups.h"
#include "repair/triangle_soup.h"

namespace foldwright {

/// Faces in one plane that lie side by side and cover no place twice.
struct FlatLayer {
  std::vector<int> border;  ///< edge groups around it, ascending
  std::vector<int> faces;   ///< ascending
};

/// How far a layer goes where layers lie on each other.
enum class LayerExtent {
  kWhole,         ///< over every edge at which all layers go on
  kToSharedEdges  ///< ... but none that several layers have
};

/// The layers that lie on others over all of their border or may do so: of each border edge another
/// face lies in the plane. They are sorted by border, then by faces, so that layers with the same
/// border, which coincide, come one after the other.
///
/// At an edge the faces in one plane, up to `tolerance`, go on where as many with the same side up
/// lie to its left as to its right; which of them go on in which does not matter: over a polygon
/// whose corners are all on its border each layer covers the whole polygon. n log n.
std::vector<FlatLayer> find_flat_layers(const TriangleSoup& soup, const EdgeGroups& groups,
                                        double tolerance, LayerExtent extent);

/// Whether two layers with the same border are flat as a whole, and thus coincide.
bool coincide(const TriangleSoup& soup, const FlatLayer& a, const FlatLayer& b, double tolerance);

/// Sum of the area vectors of a layer's faces, each twice as long as the area.
Vec3 area_vector(const TriangleSoup& soup, const FlatLayer& layer);

}  // namespace foldwright
