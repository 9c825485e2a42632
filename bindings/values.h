#pragma once

#include <emscripten/val.h>

#include "pipeline/events.h"
#include "pipeline/options.h"

namespace foldwright {

/// From the plain objects of `web/model/job.ts` and back. Typed arrays are copies that JavaScript
/// owns.
JobOptions options_from(const emscripten::val& object);
emscripten::val to_value(const Event& event);

}  // namespace foldwright
