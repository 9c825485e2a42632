#pragma once

#include <optional>
#include <string>

#include "paper/text_box.h"

namespace foldwright {

/// Where the ids of cut edges go.
enum class IdPlace {
  kNone,
  kInside,  ///< on the faces, beside the edge
  kFlap,    ///< on flaps, and beside edges without one
  kBoth,
  kOutside  ///< on flaps, and beyond edges without one, on what is cut off
};

/// A short text on a piece: the piece's name, or the id of an edge.
struct Label {
  std::string text;
  Vec2 centre;   ///< of its box
  double angle;  ///< of its baseline in radians, in (-pi/2, pi/2]: never upside down
  double size;   ///< of the font; mm
  /// From the text to what it names, where it stands apart from it.
  std::optional<Stroke> leader = {};
  bool is_beside = false;  ///< beside the piece, on what is cut off
};

}  // namespace foldwright
