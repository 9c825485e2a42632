#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/message.h"
#include "paper/sheets.h"

namespace foldwright {

/// The pin of a piece that a motion takes from how it came to its place on a sheet.
Pin pin_at(const Footprint& piece, int sheet, const RigidMotion2& motion);

/// Takes out of `held` all pins with which pieces would leave the printable area or overlap one
/// pinned before; those that are in `pins`, too, stay. With the orientation of the task, which is
/// not automatic. False if `pins` cannot stay. `task.pins` is not read.
bool drop_clashing_pins(const SheetTask& task, std::span<const std::optional<Pin>> pins,
                        std::span<std::optional<Pin>> held);

/// The pins of a task as they are on a sheet with this room: pieces that stick out of it by no more
/// than the task's play are moved into it.
std::vector<std::optional<Pin>> pulled_in(const SheetTask& task, const Extent& room);

/// Says why pins of a task's pieces cannot stay in this room: the parameters of "bad-pin"; empty if
/// they can.
std::optional<Parameters> fault_of_pins(const SheetTask& task,
                                        std::span<const std::optional<Pin>> pins,
                                        const Extent& room);

}  // namespace foldwright
