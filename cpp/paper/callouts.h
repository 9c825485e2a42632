#pragma once

#include <optional>
#include <span>

#include "paper/label_space.h"
#include "paper/seams.h"

namespace foldwright {

/// A text apart from the edge that it names, and the line that leads to the edge.
struct Callout {
  TextBox box;
  double size;    ///< of the font
  Stroke leader;  ///< from the text to the edge
};

/// Finds places for texts that do not fit beside their edges, on the faces of one net.
class CalloutFinder {
 public:
  /// `least_size` and `clearance` of texts, mm
  CalloutFinder(const Net& net, double least_size, double clearance);

  /// The place nearest to the middle of the edge, within 12 mm on its inner side, that touches
  /// nothing, and to which a line leads that leaves the paper nowhere and touches no text.
  /// `sizes`: in the order in which they are tried, mm: the least one last.
  std::optional<Callout> find(const LabelSpace& space, const SeamSide& side,
                              const std::string& text, std::span<const double> sizes);

 private:
  enum class Point : char { kUnknown, kOpen, kTaken };
  struct Offset {
    double distance;
    int x, y;
  };

  bool is_inside(const Vec2& p) const;
  bool is_open(const LabelSpace& space, int x, int y);
  /// A text around a point in the first size that has room, whichever way it is turned.
  std::optional<Callout> try_at(const LabelSpace& space, const SeamSide& side,
                                const std::string& text, const Vec2& centre,
                                std::span<const double> sizes) const;

  const Net& net_;
  double least_size_, clearance_;
  Vec2 origin_;
  int columns_, rows_;
  BoxGrid<2> faces_;
  std::vector<Offset> offsets_;  ///< nearest first
  std::vector<Point> points_;    ///< of a lattice over the net, looked at when they are asked for
};

}  // namespace foldwright
