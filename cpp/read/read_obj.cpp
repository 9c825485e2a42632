#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mesh/input_error.h"
#include "read/formats.h"
#include "read/soup_builder.h"
#include "read/text_encoding.h"
#include "read/text_scanner.h"

namespace foldwright {
namespace {

Place here(const TextScanner& scanner) { return {"line", scanner.line()}; }

/// NaN where there is none. At the end of the file that tells that the rest is missing.
double coordinate(TextScanner& scanner, SoupBuilder& builder) {
  const std::string_view word = scanner.word_in_line();
  if (!word.empty()) return builder.text_coordinate(word, scanner.line());
  const InputError fault("truncated", here(scanner), {{"what", "coordinates"}});
  if (scanner.at_end()) throw fault;
  builder.meet_fault(fault);
  return std::numeric_limits<double>::quiet_NaN();
}

/// The part of a corner between its first and its second slash: the place in a picture, as in "7/1"
/// or "7/1/2"; empty without one.
std::string_view place_word(std::string_view corner) {
  const std::size_t slash = corner.find('/');
  if (slash == std::string_view::npos) return {};
  corner.remove_prefix(slash + 1);
  return corner.substr(0, corner.find('/'));
}

/// A number counts from 1, or backwards from the last one so far. What is no number at all is a
/// place that does not exist.
void name_place(SoupBuilder& builder, std::string_view word) {
  if (word.empty()) return;
  LooksBuilder& looks = builder.looks();
  constexpr long long kNowhere = std::numeric_limits<int>::max();
  const long long number = parse_integer(word).value_or(kNowhere);
  const long long index = number < 0 ? looks.place_count() + number : number - 1;
  looks.name_place(builder.corner_count(), index < -1 ? kNowhere : index);
}

/// A corner such as "7", "7/1", "7//2" or "-1/-1/-1"; normals do not count.
void add_corner(SoupBuilder& builder, std::string_view word, const Place& place) {
  name_place(builder, place_word(word));
  const std::string_view vertex = word.substr(0, word.find('/'));
  const std::optional<long long> index = parse_integer(vertex);
  if (!index) {
    return builder.add_lost_corner(no_whole_number(vertex, static_cast<int>(place.number)));
  }
  if (*index >= 0) return builder.add_corner(*index);
  const long long absolute = builder.vertex_count() + 1 + *index;
  if (absolute >= 1) return builder.add_corner(absolute);
  builder.add_lost_corner(
      {"bad-index",
       place,
       {{"what", "before"}, {"index", *index}, {"vertices", builder.vertex_count()}}});
}

void read_vertex(TextScanner& scanner, SoupBuilder& builder) {
  const Place place = here(scanner);
  const double x = coordinate(scanner, builder);
  const double y = coordinate(scanner, builder);
  const double z = coordinate(scanner, builder);
  builder.add_vertex({x, y, z}, place);
  // A single number more is a weight; three or four are a colour, as sculpting programs write it.
  std::vector<double> more;
  for (std::string_view word = scanner.word_in_line(); !word.empty();
       word = scanner.word_in_line()) {
    more.push_back(parse_number(word).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  if (more.size() < 3) return;
  builder.looks().colour_vertex(builder.vertex_count() - 1, {more[0], more[1], more[2]});
}

/// A place without a number in it is a place that pictures do not have.
void read_place(TextScanner& scanner, SoupBuilder& builder) {
  PicturePlace place = {0, 0};  // a second number may be missing
  for (float& number : place) {
    const std::string_view word = scanner.word_in_line();
    if (word.empty()) break;
    number =
        static_cast<float>(parse_number(word).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  builder.looks().add_place(place);
}

/// `material`: the number of the one in use, or none.
void read_face(TextScanner& scanner, SoupBuilder& builder, std::optional<int> material) {
  const Place place = here(scanner);
  int corners = 0;
  for (std::string_view word = scanner.word_in_line(); !word.empty();
       word = scanner.word_in_line()) {
    add_corner(builder, word, place);
    ++corners;
  }
  // A short face elsewhere is one bad face; at the very end, without a line break, it tells that
  // the rest of the file is missing.
  if (corners < 3 && scanner.at_end()) {
    throw InputError("truncated", place, {{"what", "face"}});
  }
  if (material) builder.looks().set_material(builder.face_count(), *material);
  builder.end_face(place);
}

/// What a model may have besides faces; no paper comes of it.
struct Ignored {
  int points = 0;
  int lines = 0;
  int curves = 0;
  int surfaces = 0;

  void count(std::string_view keyword) {
    points += keyword == "p";
    lines += keyword == "l";
    curves += keyword == "curv" || keyword == "curv2";
    surfaces += keyword == "surf";
  }
  int total() const { return points + lines + curves + surfaces; }
};

void note_ignored(const Ignored& ignored, SoupBuilder& builder) {
  if (ignored.total() == 0) return;
  builder.note({"ignored-elements",
                ignored.total(),
                {{"points", ignored.points},
                 {"lines", ignored.lines},
                 {"curves", ignored.curves},
                 {"surfaces", ignored.surfaces}}});
}

/// Says why there is no face where the file has shapes of another kind.
void require_faces(const Ignored& ignored, const SoupBuilder& builder) {
  if (builder.face_count() > 0 || ignored.surfaces == 0) return;
  throw InputError("no-faces", {{"what", "surfaces"}});
}

void read_lines(TextScanner scanner, SoupBuilder& builder) {
  Ignored ignored;
  std::optional<int> material;
  do {
    const std::string_view keyword = scanner.word_in_line();
    if (keyword == "v") {
      read_vertex(scanner, builder);
    } else if (keyword == "f" || keyword == "fo") {  // "fo": faces of old exporters
      read_face(scanner, builder, material);
    } else if (keyword == "vt") {
      read_place(scanner, builder);
    } else if (keyword == "usemtl") {
      material = builder.looks().material_named(scanner.rest_of_line());
    } else if (keyword == "mtllib") {
      builder.looks().add_library(scanner.rest_of_line());
    } else {
      ignored.count(keyword);
    }
  } while (scanner.next_line());
  require_faces(ignored, builder);
  note_ignored(ignored, builder);
}

}  // namespace

PolygonSoup read_obj(std::span<const std::byte> bytes) {
  refuse_nul(bytes);
  const TextScanner scanner(bytes, LineContinuation::kBackslash);
  return build_soup(1, [&](SoupBuilder& builder) { read_lines(scanner, builder); });
}

}  // namespace foldwright
