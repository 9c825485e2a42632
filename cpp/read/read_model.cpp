#include "read/read_model.h"

#include <algorithm>
#include <array>
#include <string>

#include "mesh/input_error.h"
#include "read/formats.h"
#include "read/model_format.h"
#include "read/stl_binary.h"
#include "read/text_encoding.h"
#include "read/text_scanner.h"

namespace foldwright {
namespace {

struct FormatEntry {
  ModelFormat format;
  const char* ending;
  const char* name;
  PolygonSoup (*read)(std::span<const std::byte>);
};

constexpr std::array<FormatEntry, 4> kFormats = {{{ModelFormat::kObj, "obj", "OBJ", read_obj},
                                                  {ModelFormat::kStl, "stl", "STL", read_stl},
                                                  {ModelFormat::kOff, "off", "OFF", read_off},
                                                  {ModelFormat::kPly, "ply", "PLY", read_ply}}};

bool is_letter_or_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z'); }

/// The ending in lower case; empty when what follows the last point is not like one: "v1.2 final".
std::string ending_of(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos) return "";
  std::string ending = lower_case(file_name.substr(dot + 1));
  return std::all_of(ending.begin(), ending.end(), is_letter_or_digit) ? ending : "";
}

const FormatEntry* entry_of_ending(std::string_view ending) {
  for (const FormatEntry& entry : kFormats) {
    if (ending == entry.ending) return &entry;
  }
  return nullptr;
}

const FormatEntry* entry_of_contents(std::span<const std::byte> bytes) {
  const std::optional<ModelFormat> format = format_of_contents(bytes);
  for (const FormatEntry& entry : kFormats) {
    if (format == entry.format) return &entry;
  }
  return nullptr;
}

[[noreturn]] void fail_unknown(const std::string& ending) {
  if (ending.empty()) throw InputError("unknown-format", {{"what", "nothing"}});
  throw InputError("unknown-format", {{"what", "ending"}, {"ending", ending}});
}

void refuse_foreign(std::span<const std::byte> bytes) {
  const std::string_view name = foreign_format(bytes);
  if (name.empty()) return;
  throw InputError("unknown-format", {{"what", "contents"}, {"format", name}});
}

}  // namespace

bool holds_model(std::span<const std::byte> bytes) {
  if (has_size_of_binary_stl(bytes)) return true;
  if (!foreign_format(bytes).empty()) return false;
  std::string text;
  return format_of_contents(to_utf8(bytes, text)).has_value();
}

bool is_named_as_model(std::string_view file_name) {
  return entry_of_ending(ending_of(file_name)) != nullptr;
}

PolygonSoup read_model(std::span<const std::byte> bytes, std::string_view file_name) {
  if (bytes.empty()) throw InputError("empty-file");
  std::string text;
  if (!has_size_of_binary_stl(bytes)) {
    refuse_foreign(bytes);
    bytes = to_utf8(bytes, text);
  }
  const std::string ending = ending_of(file_name);
  const FormatEntry* named = entry_of_ending(ending);
  const FormatEntry* found = entry_of_contents(bytes);
  if (found == nullptr) found = named;
  if (found == nullptr) fail_unknown(ending);
  PolygonSoup soup = found->read(bytes);
  if (found != named && !ending.empty()) {
    soup.repairs.push_back({"other-format", 1, {{"ending", ending}, {"format", found->name}}});
  }
  // What STL files are made for, printers and machine tools, has its bed in the plane of x and y.
  if (found->format == ModelFormat::kStl) soup.usual_up = Axis::kZ;
  return soup;
}

}  // namespace foldwright
