#pragma once

#include <string>

#include "paper/flaps.h"

namespace foldwright {

/// Where the ids of cut edges go.
enum class IdPlace {
  kNone,
  kInside,  ///< on the faces, beside the edge
  kFlap,    ///< on flaps, and beside edges without one
  kBoth
};

/// A short text on a piece: the piece's name, or the id of an edge.
struct Label {
  std::string text;
  Vec2 centre;   ///< of its box
  double angle;  ///< of its baseline in radians, in (-pi/2, pi/2]: never upside down
  double size;   ///< of the font; mm
};

struct LabelPlan {
  std::vector<std::vector<Label>> labels;  ///< per net; the name comes first if it is there
  int printed = 0;                         ///< cut edges with their id at both sides
  std::vector<int> skipped;  ///< ids that are unreadable at one side at least, ascending
};

/// Name of a piece from its index: A, B, .. Z, AA, AB, .. as in the columns of a sheet.
std::string piece_letter(int index);

/// Height of capitals and digits over the size of their font.
inline constexpr double kCapHeight = 0.72;

/// Width of a text over the size of its font, at most: no common sans-serif face is wider.
double text_width(const std::string& text);

/// Names the pieces, and writes the same number at both sides of each cut edge between two faces.
///
/// Texts of ids lie along their edge, as large as it allows; where another piece is met they name
/// it (`C:17`) if there is room. No text touches a line that is drawn, or another text. Numbers
/// count along the outlines, piece by piece. `nets` as they lie on their sheets, in millimetres;
/// `flaps`: per net.
LabelPlan place_labels(std::span<const Net> nets, std::span<const std::vector<Flap>> flaps,
                       IdPlace place);

}  // namespace foldwright
