#pragma once

#include <span>

#include "read/off_header.h"
#include "read/soup_builder.h"

namespace foldwright {

/// Takes the numbers that stand behind the coordinates of the vertex added last: a normal, a colour
/// and a place in a picture, as far as the keyword says that they are there.
void take_vertex_looks(std::span<const double> numbers, const OffLayout& layout,
                       SoupBuilder& builder);

/// Takes the numbers that stand behind the corners of the face ended last: a colour of three or
/// four numbers, or one number of a table of colours.
void take_face_looks(std::span<const double> numbers, SoupBuilder& builder);

}  // namespace foldwright
