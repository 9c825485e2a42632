#include "pipeline/values/options.h"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/input_error.h"

namespace foldwright::testing {
namespace {

/// The option for which options are refused; empty when they are not.
std::string refusal(const JobOptions& options) {
  try {
    check_options(options);
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), "bad-option");
    EXPECT_EQ(error.parameters().at(0).name, "what");
    return std::get<std::string>(error.parameters()[0].value);
  }
  return "";
}

JobOptions with_sheet(const SheetOptions& sheet) {
  JobOptions options;
  options.paper.sheet = sheet;
  return options;
}

JobOptions with_size(Sizing by, double value) {
  JobOptions options;
  options.paper.size = {by, value};
  return options;
}

TEST(CheckOptions, TakesTheDefaultsAndTheEndsOfAllRanges) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({.model = {.faces = 4}, .parts = {.count = 1, .runs = 1, .proxy = 0}}), "");
  EXPECT_EQ(refusal({.model = {.faces = 1000000}, .parts = {.count = 1000000, .runs = 65535}}), "");
  EXPECT_EQ(refusal(with_sheet({.width = 1, .height = 10000, .margin = 0})), "");
  EXPECT_EQ(refusal(with_size(Sizing::kHeight, 150)), "");
  EXPECT_EQ(refusal(with_size(Sizing::kSheets, 1)), "");
}

TEST(CheckOptions, NamesABadOption) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<JobOptions, const char*> cases[] = {
      {{.parts = {.count = -1}}, "parts"},
      {{.parts = {.runs = 0}}, "runs"},
      {{.parts = {.runs = 65536}}, "runs"},
      {{.parts = {.proxy = -1}}, "proxy"},
      {{.model = {.faces = 3}}, "faces"},
      {{.model = {.faces = -5}}, "faces"},
      {{.model = {.fill_holes = -1}}, "fill-holes"},
      {{.model = {.fill_holes = 201}}, "fill-holes"},
      {with_sheet({.width = 0}), "paper"},
      {with_sheet({.width = -210}), "paper"},
      {with_sheet({.height = infinity}), "paper"},
      {with_sheet({.height = 10001}), "paper"},
      {with_sheet({.height = nan}), "paper"},
      {with_sheet({.margin = -1}), "margin"},
      {with_sheet({.margin = 105}), "margin"},
      {with_sheet({.margin = nan}), "margin"},
      {with_size(Sizing::kHeight, 0), "height"},
      {with_size(Sizing::kWidth, nan), "width"},
      {with_size(Sizing::kDepth, -1), "depth"},
      {with_size(Sizing::kScale, infinity), "scale"},
      {with_size(Sizing::kSheets, 1.5), "sheets"},
  };
  for (const auto& [options, name] : cases) {
    EXPECT_EQ(refusal(options), name);
  }
}

}  // namespace
}  // namespace foldwright::testing
