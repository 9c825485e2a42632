#pragma once

#include <gtest/gtest.h>

#include "mesh_faults.h"
#include "model_text.h"
#include "repair/repair.h"

namespace foldwright::testing {

/// Repairs, and checks all that is promised for every model.
inline RepairedModel sound_repair(const PolygonSoup& soup, const RepairOptions& options = {}) {
  RepairedModel model = repair(soup, options);
  EXPECT_EQ(fault_of(model.mesh), "");
  EXPECT_EQ(bookkeeping_fault_of(model), "");
  EXPECT_EQ(origin_fault_of(soup, model), "");
  return model;
}

/// Of the repair of this code; 0 if it was not made.
inline int count_of(const RepairedModel& model, std::string_view code) {
  return repair_named(model.repairs, code).count;
}

}  // namespace foldwright::testing
