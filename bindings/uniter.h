#pragma once

#include <emscripten/val.h>

#include "repair/solids.h"

namespace foldwright {

/// A function of JavaScript that unites solids, see `web/model/solids.ts`.
SolidUniter uniter_from(const emscripten::val& function);

}  // namespace foldwright
