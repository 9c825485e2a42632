#pragma once

#include "pipeline/values/options.h"

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

/// Millimetres per model unit where the options fix them: by height, width,
/// depth or scale.
/// \pre `size.by` is one of these
/// \throw InputError if the model has no extent in that direction
double fixed_scale(const Mesh& mesh, const SizeOptions& size);

/// Area, in square model units, above which a part is unlikely to go on a sheet in one piece;
/// infinite where the size follows from the nets (`kFit`, `kSheets`).
/// \throw InputError as `fixed_scale`, or if the margins leave nothing of the sheet
double largest_part_area(const Mesh& mesh, const PaperOptions& paper);

}  // namespace foldwright
