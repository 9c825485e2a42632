#pragma once

#include <span>

#include "repair/triangle_soup.h"

namespace foldwright {

/// Cracks between borders that were closed.
struct ClosedCracks {
  int edges = 0;     ///< border edges that were joined to another or cut to be
  double width = 0;  ///< of the widest crack
  /// No corner of a face is further from where it was than this.
  double moved = 0;
};

/// Closes cracks where a border edge faces a chain of shorter ones: border vertices that lie on the
/// inside of a border edge, within `tolerance`, are put on it and its face is cut accordingly.
///
/// A vertex is put on an edge only where this lets two border edges meet, so that sheets that
/// merely touch stay as they are. The edges told of are those that were cut.
ClosedCracks close_t_junctions(TriangleSoup& soup, double tolerance);

/// The same with a tolerance of its own for each vertex: the least of a vertex and the two ends of
/// an edge counts.
ClosedCracks close_t_junctions(TriangleSoup& soup, std::span<const double> tolerances);

}  // namespace foldwright
