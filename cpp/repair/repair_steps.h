#pragma once

#include <array>
#include <bitset>
#include <string_view>

namespace foldwright {

/// The steps of `repair`, in the order in which they run.
enum class RepairStep {
  kWeld,
  kPolygons,
  kDegenerate,
  kDuplicates,
  kTwoSided,
  kJunctions,
  kCracks,
  kHoles,
  kWinding,
  kNonManifold,
  kCrossing,
  kInside,
  kFlatten
};

/// What decides whether a step is done.
enum class StepKind {
  kSwitch,   ///< it is done unless it is switched off
  kRequest,  ///< it is done where an option of its own asks for it
  kAlways    ///< unfolding needs it
};

struct RepairStepRow {
  std::string_view name;  ///< a stable word for programs and people
  StepKind kind;
};

/// By `RepairStep`. `web/model/repair-steps.ts` has the same words.
inline constexpr std::array kRepairSteps = std::to_array<RepairStepRow>({
    {"weld", StepKind::kSwitch},
    {"polygons", StepKind::kAlways},    // nets are made of triangles
    {"degenerate", StepKind::kAlways},  // a face without an area has no place in a net
    {"duplicates", StepKind::kSwitch},
    {"two-sided", StepKind::kSwitch},
    {"t-junctions", StepKind::kSwitch},
    {"cracks", StepKind::kSwitch},
    {"holes", StepKind::kRequest},
    {"winding", StepKind::kSwitch},
    {"non-manifold", StepKind::kAlways},  // a fold joins two faces, and no more
    {"crossing", StepKind::kRequest},
    {"inside", StepKind::kRequest},
    {"flatten", StepKind::kSwitch},
});

/// Some of the steps.
using RepairSteps = std::bitset<kRepairSteps.size()>;

}  // namespace foldwright
