#include "read/model_format.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "read/byte_reader.h"
#include "read/off_header.h"
#include "read/stl_binary.h"
#include "read/stl_text.h"
#include "read/text_scanner.h"

namespace foldwright {
namespace {

/// Beginnings of files that people take for models.
struct Signature {
  std::string_view begin;
  std::string_view name;
};

using namespace std::string_view_literals;  // for signatures with NUL bytes in them

constexpr Signature kSignatures[] = {
    {"glTF"sv, "glb"},
    {"Kaydara FBX Binary"sv, "fbx"},
    {"; FBX"sv, "fbx"},
    {"ISO-10303-21"sv, "step"},
    {"BLENDER"sv, "blend"},
    {"\x28\xB5\x2F\xFD"sv, "zstandard"},
    {"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0"sv, "skp"},
    {"3D Geometry File Format"sv, "3dm"},
    {"#VRML"sv, "vrml"},
    {"VOX "sv, "vox"},
    {"DRACO"sv, "draco"},
    {"AutoCAD Binary DXF"sv, "dxf"},
    {"AC10"sv, "dwg"},
    {"%PDF"sv, "pdf"},
    {"%!PS"sv, "ps"},
    {"\x89PNG"sv, "png"},
    {"\xFF\xD8\xFF"sv, "jpeg"},
    {"GIF8"sv, "gif"},
    {"\x1F\x8B"sv, "gzip"},
    {"7z\xBC\xAF\x27\x1C"sv, "7z"},
    {"Rar!"sv, "rar"},
    {"version https://git-lfs"sv, "git-lfs"},
};

/// Words that tell one kind of markup from another, in lower case.
constexpr Signature kMarkups[] = {
    {"<collada", "dae"}, {"<x3d", "x3d"},   {"<amf", "amf"},
    {"<svg", "svg"},     {"<html", "html"}, {"<!doctype html", "html"},
};

/// The header of any markup ends within so many bytes; comments may come before its first element.
constexpr std::size_t kMarkupHead = 2048;

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string_view without_leading_blanks(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

/// The markup's name if the text begins like one.
std::string_view markup_name(std::string_view text) {
  if (!text.starts_with('<')) return {};
  const std::string head = lower_case(text.substr(0, kMarkupHead));
  for (const auto& [word, name] : kMarkups) {
    if (head.find(word) != std::string::npos) return name;
  }
  return "xml";
}

std::string_view json_name(std::string_view text) {
  if (!text.starts_with('{')) return {};
  const bool is_gltf = text.find("\"asset\"") != std::string_view::npos &&
                       text.find("\"version\"") != std::string_view::npos;
  return is_gltf ? "gltf" : "json";
}

/// Many formats are ZIP archives: 3MF has its model at a fixed path.
std::string_view zip_name(std::string_view text) {
  if (!text.starts_with("PK\3\4")) return {};
  return text.find("3D/3dmodel.model") != std::string_view::npos ? "3mf" : "zip";
}

/// A 3DS file is one chunk of type 0x4D4D that is as long as the file.
bool is_3ds(std::span<const std::byte> bytes) {
  if (!as_text(bytes).starts_with("MM") || bytes.size() < 6) return false;
  ByteReader reader(bytes.subspan(2), std::endian::little);
  return reader.read<std::uint32_t>() == bytes.size();
}

bool gives_obj_vertex(TextScanner& scanner) {
  if (scanner.word_in_line() != "v") return false;
  for (int i = 0; i < 3; ++i) {
    if (!parse_number(scanner.word_in_line())) return false;
  }
  return true;
}

bool is_obj(std::span<const std::byte> bytes) {
  TextScanner scanner(bytes, LineContinuation::kBackslash);
  do {
    if (gives_obj_vertex(scanner)) return true;
  } while (scanner.next_line());
  return false;
}

}  // namespace

std::optional<ModelFormat> format_of_contents(std::span<const std::byte> bytes) {
  // A solid's name of a few hundred bytes may come before the first facet.
  constexpr std::size_t kStlSample = 1024;
  if (has_size_of_binary_stl(bytes)) return ModelFormat::kStl;
  const std::string_view first = TextScanner(bytes).word();
  if (first == "ply") return ModelFormat::kPly;
  if (is_off_keyword(first)) return ModelFormat::kOff;
  if (is_stl_text(bytes.first(std::min(bytes.size(), kStlSample)))) return ModelFormat::kStl;
  if (is_obj(bytes)) return ModelFormat::kObj;
  return std::nullopt;
}

bool is_foreign_model(std::string_view format) {
  constexpr std::string_view kModels[] = {"glb", "gltf", "fbx", "step",  "skp",
                                          "3dm", "vrml", "vox", "draco", "dae",
                                          "x3d", "amf",  "3mf", "3ds",   "git-lfs"};
  return std::ranges::find(kModels, format) != std::end(kModels);
}

std::string_view foreign_format(std::span<const std::byte> bytes) {
  const std::string_view text = as_text(bytes);
  for (const auto& [begin, name] : kSignatures) {
    if (text.starts_with(begin)) return name;
  }
  if (is_3ds(bytes)) return "3ds";
  const std::string_view written = without_leading_blanks(text);
  for (const std::string_view name : {zip_name(text), markup_name(written), json_name(written)}) {
    if (!name.empty()) return name;
  }
  return {};
}

}  // namespace foldwright
