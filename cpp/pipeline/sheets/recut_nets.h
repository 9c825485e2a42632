#pragma once

#include "mesh/input_error.h"
#include "pipeline/state.h"

namespace foldwright {

/// Code of the error for a single face that fits no sheet.
inline constexpr Code kFaceTooLarge = "face-too-large";

/// Looks at the size asked for before anything is searched: a flat face cannot be cut again.
/// \throw InputError `kFaceTooLarge` if one does not fit the sheet, or "bad-margin"
void check_panels_fit(const JobState& state);

/// Finds the largest scale in millimetres per model unit at which every net of a state fits a
/// sheet, with all the flaps that it would have if sheets had no end; at most that of the earlier
/// result, if there is one to keep to.
class ScaleFinder {
 public:
  /// The state must outlive this.
  /// \throw InputError if margins leave nothing of the sheet
  explicit ScaleFinder(const JobState& state);

  /// Tries one scale; true when it is found.
  bool step();

  double scale() const { return low_; }

 private:
  bool step_freely();
  bool step_straight();
  bool fits_at(double scale) const;

  const JobState& state_;
  double low_, high_;
  int trials_ = 0;
  bool may_straighten_ = false;
  bool is_straight_ = false;  ///< whether pieces are to fit along their grain
  double free_ = 0;           ///< the scale that is found if they need not
};

/// What a step of work comes to that ends where a single face is larger than a sheet.
enum class FitStep { kRunning, kDone, kDoesNotFit };

/// Cuts nets again until every piece fits the sheet; nets that fit stay as they are, and so do all
/// where the size asked for is the one that fits.
class NetCutter {
 public:
  /// `scale`: millimetres per model unit. The state must outlive this.
  NetCutter(const JobState& state, std::vector<FoundNet> nets, double scale);

  /// Looks at one net and cuts it once if it must; done when all fit.
  /// \throw InputError if margins leave nothing of the sheet
  FitStep step();

  /// Says what does not fit. \pre `step` came to that
  InputError misfit() const { return *misfit_; }

  /// The pieces in the order of the nets. \pre `step` was done; leaves this empty
  std::vector<FoundNet> take() { return std::move(fitting_); }

 private:
  const JobState& state_;
  double scale_;
  std::vector<FoundNet> open_;  ///< the next one last
  std::vector<FoundNet> fitting_;
  std::optional<InputError> misfit_;
};

/// All of it at once. \throw InputError `kFaceTooLarge` if a single face does not fit the sheet
std::vector<FoundNet> recut_nets(const JobState& state, std::vector<FoundNet> nets, double scale);

}  // namespace foldwright
