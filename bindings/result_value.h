#pragma once

#include <emscripten/val.h>

#include "pipeline/values/result.h"

namespace foldwright {

/// The parameters of a message as a plain object.
emscripten::val parameters_value(const Parameters& parameters);

/// A notice as `web/model/job.ts` has it.
emscripten::val notice_value(const Notice& notice);

/// A result as the plain object of `web/model/job.ts`.
emscripten::val result_value(const JobResult& result);

}  // namespace foldwright
