#pragma once

#include <optional>

#include "pipeline/sheets/recut_nets.h"

namespace foldwright {

/// Nets of one size with their flaps, on sheets.
struct PaperDraft {
  /// Those of the state in the order of gluing, some of them cut again.
  std::vector<FoundNet> nets;
  std::vector<std::string> names;  ///< per net
  std::vector<Net> flat;           ///< per net: in millimetres, turned, its box from (0, 0)
  std::vector<Footprint> prints;   ///< per net, likewise
  FlapPlan flaps;                  ///< where the nets lie
  SheetLayout sheets;
  int lost_pins = 0;  ///< pins whose piece there is no more
};

/// Makes a draft at a given scale, step by step.
class PaperDrafter {
 public:
  /// `scale`: millimetres per model unit; `effort`: see `SheetTask`. The state must outlive this.
  PaperDrafter(const JobState& state, double scale, int effort);

  /// Does some milliseconds of work.
  /// \throw InputError if margins leave nothing of the sheet, or a pinned piece cannot stay
  FitStep step();

  /// Says which face fits no sheet. \pre `step` came to that
  InputError misfit() const { return cutter_.misfit(); }

  /// \pre `step` was done; leaves this empty
  PaperDraft take() { return std::move(draft_); }

 private:
  enum class Phase { kCut, kFlaps, kPack };

  void begin_pieces();
  bool place_flaps_on_sheets();
  void begin_packing();
  void hold_places();
  SheetTask sheet_task(std::span<const std::optional<Pin>> pins) const;
  bool pack();
  void finish();

  const JobState& state_;
  double scale_;
  int effort_;
  Phase phase_ = Phase::kCut;
  NetCutter cutter_;
  std::vector<std::vector<std::vector<Vec2>>> keep_off_;
  std::vector<std::optional<std::array<double, 2>>> held_;  ///< see `Footprint::fitting_turn`
  std::vector<int> parts_;
  std::vector<std::optional<Pin>> pins_;       ///< that a person put
  std::vector<std::optional<Pin>> held_pins_;  ///< these, and places of the earlier result
  bool holds_ = false;                         ///< packing tries with the latter
  std::optional<SheetPlanner> planner_;
  PaperDraft draft_;
};

}  // namespace foldwright
