#pragma once

#include <emscripten/val.h>

#include "pipeline/values/options.h"

namespace foldwright {

/// From the plain object of `web/model/job.ts`. Throws std::invalid_argument for an unknown word.
JobOptions options_from(const emscripten::val& object);

}  // namespace foldwright
