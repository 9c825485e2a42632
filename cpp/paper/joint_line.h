#pragma once

#include <optional>

#include "paper/seams.h"
#include "paper/text_box.h"

namespace foldwright {

/// The line to be drawn where something stands on a side of a net, in millimetres: along the edge,
/// ending just inside it. None where a fold or a cut is drawn there, or the edge is too short.
std::optional<Stroke> joint_line(const Net& net, const SeamSide& host);

}  // namespace foldwright
