#pragma once

#include "pipeline/options.h"

namespace foldwright {

/// A model's unit, and whether it had to be guessed.
struct ModelUnit {
  Unit unit;
  bool guessed;
};

/// The unit asked for, or else the smallest of millimetre, centimetre and metre in which the model
/// is at least 2 cm large: smaller ones are no paper models.
ModelUnit model_unit(const Mesh& mesh, Unit asked);

/// Millimetres in one unit. \pre not `kGuess`
double millimetres(Unit unit);

/// Extents of a mesh along x, y and z, in model units.
Vec3 extents(const Mesh& mesh);

/// Millimetres per model unit where the options fix them: by height, width or scale.
/// \pre `size.by` is one of these
/// \throw InputError if the model has no extent in that direction
double fixed_scale(const Mesh& mesh, const SizeOptions& size);

}  // namespace foldwright
