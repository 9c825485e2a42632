#pragma once

#include <emscripten/val.h>

#include "pipeline/values/events.h"

namespace foldwright {

/// The plain object of `web/model/job.ts`. Typed arrays are copies that JavaScript owns.
emscripten::val to_value(const Event& event);

}  // namespace foldwright
