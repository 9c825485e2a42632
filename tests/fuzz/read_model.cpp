// Any bytes are a model that keeps the promises of `PolygonSoup`, or are refused with a code and a
// sentence. One program per reader: its name for the file decides where the contents show no
// format.

#include "read/read_model.h"

#include <cstdint>
#include <span>

#include "expect.h"
#include "mesh/input_error.h"

namespace {

using foldwright::PolygonSoup;
using foldwright::fuzz::expect;

void expect_sound(const PolygonSoup& soup) {
  expect(soup.face_count() > 0, "a model has faces");
  expect(soup.first_corner.back() == static_cast<int>(soup.corners.size()),
         "the faces have all corners");
  for (const int corner : soup.corners) {
    expect(corner >= 0 && corner < static_cast<int>(soup.positions.size()), "a corner is a vertex");
  }
  for (const foldwright::Vec3& position : soup.positions) {
    expect(position.allFinite(), "coordinates are finite");
  }
  expect(soup.precision >= 0, "the precision is a length");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    expect_sound(foldwright::read_model(std::as_bytes(std::span(data, size)), FUZZED_FILE_NAME));
  } catch (const foldwright::InputError& error) {
    foldwright::fuzz::expect_refusal(error.code(), error.what());
  }
  return 0;
}
