#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "paper/flaps.h"
#include "paper/label.h"
#include "paper/seams.h"
#include "paper/sheet_obstacles.h"

namespace foldwright {

/// The id of a seam at one of its sides.
struct SideId {
  const SeamSide* side = nullptr;
  std::string text;
};

/// What is to be written on a net.
struct PieceTextTask {
  const Net* net = nullptr;     ///< as it lies on its sheet, in millimetres
  std::span<const Flap> flaps;  ///< of the net
  std::string name;
  IdPlace place = IdPlace::kFlap;
  std::span<const Stroke> lines;            ///< that texts keep off, beside those of net and flaps
  std::vector<SideId> ids;                  ///< in the order in which they choose their places
  std::optional<Surroundings> around = {};  ///< on the sheet; needed for `IdPlace::kOutside`
};

/// What was written on a net.
struct PieceTexts {
  std::vector<Label> labels;     ///< the name comes first if it is there
  std::vector<TextBox> boxes;    ///< of the labels
  std::vector<char> is_written;  ///< per id
  std::vector<TextBox> outside;  ///< of the labels that stand beside the net
};

/// Writes name and ids on one net, see `LabelPlacer`. Depends on the task alone.
class PieceWriter {
 public:
  /// What the task refers to must outlive the writer.
  explicit PieceWriter(PieceTextTask task);
  ~PieceWriter();
  PieceWriter(PieceWriter&&) noexcept;
  PieceWriter& operator=(PieceWriter&&) noexcept;

  /// Does some milliseconds of work; true when all is written.
  bool step();

  /// \pre `step` returned true; leaves the writer empty
  PieceTexts take();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace foldwright
