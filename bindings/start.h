#pragma once

#include <emscripten/val.h>

#include "pipeline/values/job_start.h"

namespace foldwright {

/// From the plain object of `web/model/job.ts`. Throws std::invalid_argument for an unknown word.
JobStart start_from(const emscripten::val& object);

}  // namespace foldwright
