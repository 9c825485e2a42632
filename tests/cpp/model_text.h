#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "mesh/input_error.h"
#include "read/read_model.h"

/// Models written down in a test, and what is said about them.
namespace foldwright::testing {

/// Reads a model from the text or the bytes in a string.
inline PolygonSoup read_text(std::string_view text, std::string_view file_name) {
  return read_model(std::as_bytes(std::span(text.data(), text.size())), file_name);
}

/// The message, for developers, with which a model is refused; empty when it is not.
inline std::string refusal(std::string_view text, std::string_view file_name) {
  try {
    read_text(text, file_name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The soup's repairs, for developers.
inline std::vector<std::string> repairs_told(const PolygonSoup& soup) {
  std::vector<std::string> told;
  for (const Repair& repair : soup.repairs) told.push_back(describe(message_of(repair)));
  return told;
}

/// Corners of one face of a soup.
inline std::vector<int> corners_of(const PolygonSoup& soup, int face) {
  return {soup.corners.begin() + soup.first_corner[face],
          soup.corners.begin() + soup.first_corner[face + 1]};
}

/// What a soup knows of its file's looks: "colours", "places" in pictures, "materials".
inline std::string looks_of(const PolygonSoup& soup) {
  std::string looks;
  const auto add = [&](bool is_there, const char* what) {
    if (is_there) looks += (looks.empty() ? "" : " ") + std::string(what);
  };
  add(!soup.looks.colours.empty(), "colours");
  add(!soup.looks.places.empty(), "places");
  add(!soup.looks.materials.empty(), "materials");
  return looks;
}

/// The repair with the given code; a count of 0 when there is none.
inline Repair repair_named(const std::vector<Repair>& repairs, std::string_view code) {
  for (const Repair& repair : repairs) {
    if (repair.code == code) return repair;
  }
  return {};
}

}  // namespace foldwright::testing
