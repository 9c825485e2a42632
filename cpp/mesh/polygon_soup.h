#pragma once

#include <string>
#include <vector>

#include "geometry/vec.h"
#include "mesh/looks.h"
#include "mesh/message.h"

namespace foldwright {

/// Something that was mended or noticed in the input, for the report.
struct Repair {
  std::string code;       ///< stable kebab-case word, e.g. "welded-vertices"
  int count = 0;          ///< how many vertices, edges or faces it concerns
  Parameters parameters;  ///< what else its sentence needs

  Repair() = default;
  Repair(Code word, int concerned, Parameters more = {})
      : code(word.word()), count(concerned), parameters(std::move(more)) {}
};

/// A repair as a message: its count is the first parameter.
inline Message message_of(const Repair& repair) {
  Message message;
  message.code = repair.code;
  message.parameters = repair.parameters;
  message.parameters.insert(message.parameters.begin(), {"count", repair.count});
  return message;
}

/// An axis of the coordinates.
enum class Axis { kX, kY, kZ };

/// A model as its file says it: polygons over vertices, nothing welded, checked or oriented.
/// Face i has the corners `corners[first_corner[i]] .. corners[first_corner[i + 1] - 1]`;
/// all corner indices are valid and all coordinates finite.
struct PolygonSoup {
  std::vector<Vec3> positions;
  std::vector<int> corners;
  std::vector<int> first_corner = {0};  ///< one more entry than faces
  std::vector<Repair> repairs;          ///< what the reader itself had to put up with
  /// Largest rounding error of a coordinate, in model units, as estimated by CoordinatePrecision
  /// from how the file writes its numbers; 0 for a soup that was not read from a file.
  double precision = 0;
  int unusable_faces = 0;    ///< faces of which the reader left no corner, told by its repairs
  Axis usual_up = Axis::kY;  ///< the axis that points up in most files of its format
  SoupLooks looks;

  int face_count() const { return static_cast<int>(first_corner.size()) - 1; }
};

}  // namespace foldwright
