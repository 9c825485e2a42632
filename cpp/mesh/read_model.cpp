#include "mesh/read_model.h"

#include <string>

#include "mesh/formats.h"
#include "mesh/input_error.h"
#include "mesh/text_scanner.h"

namespace foldwright {

PolygonSoup read_model(std::span<const std::byte> bytes, std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  const std::string ending =
      dot == std::string_view::npos ? "" : lower_case(file_name.substr(dot + 1));
  const auto reader = ending == "obj"   ? read_obj
                      : ending == "stl" ? read_stl
                      : ending == "off" ? read_off
                      : ending == "ply" ? read_ply
                                        : nullptr;
  if (reader == nullptr) {
    throw InputError(
        "unknown-format",
        (ending.empty() ? "a file name without an ending tells no format"
                        : "files that end in " + quoted("." + ending) + " are not read") +
            std::string("; OBJ, STL, OFF and PLY are"));
  }
  if (bytes.empty()) throw InputError("empty-file", "the file is empty");
  PolygonSoup soup = reader(bytes);
  // What STL files are made for, printers and machine tools, has its bed in the plane of x and y.
  if (ending == "stl") soup.usual_up = Axis::kZ;
  return soup;
}

}  // namespace foldwright
