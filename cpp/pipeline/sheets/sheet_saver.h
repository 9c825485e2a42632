#pragma once

#include <optional>

#include "pipeline/sheets/paper_draft.h"

namespace foldwright {

/// Looks for the size, at most a twentieth smaller, at which a layout would need fewer sheets.
/// Looks only where nobody asked for the sheets, and where that is likely and takes little time:
/// with 50 pieces at most, none of them pinned, and a last sheet that is half empty.
class SheetSaver {
 public:
  /// What the layout of the state's nets came to. The state must outlive this.
  SheetSaver(const JobState& state, const SheetLayout& layout);

  /// Does some milliseconds of work; true when it is done.
  bool step();

  /// The largest scale that was tried and needs fewer sheets, mm per model unit; if there is one.
  std::optional<double> scale() const { return found_; }
  /// The sheets it needs. \pre there is one
  int sheets() const { return sheets_; }

 private:
  void begin(double scale);

  const JobState& state_;
  double high_;  ///< needs all sheets
  double tried_ = 0;
  int most_;  ///< sheets that would be fewer
  int trials_ = 0;
  std::optional<PaperDrafter> drafter_;  ///< of the scale that is tried; none: done
  std::optional<double> found_;
  int sheets_ = 0;
};

}  // namespace foldwright
