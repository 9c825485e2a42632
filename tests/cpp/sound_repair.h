#pragma once

#include <gtest/gtest.h>

#include <string>

#include "mesh_faults.h"
#include "model_text.h"
#include "repair/repair.h"

namespace foldwright::testing {

/// Repairs, and checks all that is promised for every model.
inline RepairedModel sound_repair(const PolygonSoup& soup, const RepairOptions& options = {}) {
  RepairedModel model = repair(soup, options);
  const std::string fault = fault_of(model.mesh);
  const bool winds = options.does(RepairStep::kWinding);
  if (winds || fault != "a closed component is wound inwards") {
    EXPECT_EQ(fault, "");
  }
  EXPECT_EQ(bookkeeping_fault_of(model), "");
  EXPECT_EQ(origin_fault_of(soup, model), "");
  return model;
}

/// Of the repair of this code; 0 if it was not made.
inline int count_of(const RepairedModel& model, std::string_view code) {
  return repair_named(model.repairs, code).count;
}

}  // namespace foldwright::testing
