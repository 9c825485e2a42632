#pragma once

#include <string>

#include "pipeline/values/result.h"

namespace foldwright::testing {

/// What breaks the promises of a whole `JobResult`: an invalid net, a face that is not on just one
/// piece, a part without a piece, a piece without a place, a wrong hash. Empty when nothing does.
std::string fault_of(const JobResult& result);

}  // namespace foldwright::testing
