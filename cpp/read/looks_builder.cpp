#include "read/looks_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace foldwright {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr PicturePlace kNoPlace = {kNone, kNone};
constexpr long long kUnnamed = std::numeric_limits<long long>::min();
constexpr Rgb kWhite = {255, 255, 255};

/// Sets a value of a list that is only as long as it has to be.
template <class Value>
void set_at(std::vector<Value>& values, std::size_t index, const Value& value,
            const Value& unknown) {
  if (values.size() <= index) values.resize(index + 1, unknown);
  values[index] = value;
}

template <class Value>
Value at(const std::vector<Value>& values, std::size_t index, const Value& unknown) {
  return index < values.size() ? values[index] : unknown;
}

bool is_place(const PicturePlace& place) {
  return std::isfinite(place[0]) && std::isfinite(place[1]);
}

}  // namespace

void LooksBuilder::name_place(std::size_t corner, long long number) {
  set_at(place_numbers_, corner, number, kUnnamed);
}

void LooksBuilder::place_corner(std::size_t corner, const PicturePlace& place) {
  set_at(corner_places_, corner, place, kNoPlace);
}

void LooksBuilder::place_vertex(int vertex, const PicturePlace& place) {
  set_at(vertex_places_, static_cast<std::size_t>(vertex), place, kNoPlace);
}

void LooksBuilder::colour_vertex(int vertex, const Vec3& colour) {
  if (!colour.allFinite()) return;
  largest_ = std::max(largest_, colour.maxCoeff());
  set_at(vertex_colours_, static_cast<std::size_t>(vertex), {colour}, {});
}

void LooksBuilder::colour_face(int face, const Vec3& colour) {
  if (!colour.allFinite()) return;
  largest_ = std::max(largest_, colour.maxCoeff());
  set_at(face_colours_, static_cast<std::size_t>(face), {colour}, {});
}

void LooksBuilder::set_material(int face, int number) {
  set_at(looks_.materials, static_cast<std::size_t>(face), std::max(number, -1), -1);
}

int LooksBuilder::material_named(std::string_view name) {
  const auto next = static_cast<int>(looks_.material_names.size());
  const auto [found, is_new] = materials_.emplace(name, next);
  if (is_new) looks_.material_names.emplace_back(name);
  return found->second;
}

PicturePlace LooksBuilder::place_of(std::size_t corner, int vertex) {
  const PicturePlace own = at(corner_places_, corner, kNoPlace);
  if (is_place(own)) return own;
  const long long named = at(place_numbers_, corner, kUnnamed);
  if (named == kUnnamed) return at(vertex_places_, static_cast<std::size_t>(vertex), kNoPlace);
  const long long number = named + place_offset_;
  if (number >= 0 && number < place_count()) return listed_places_[number];
  ++lost_places_;
  return kNoPlace;
}

Rgb LooksBuilder::rgb(const Vec3& colour) const {
  const double one = largest_ > 1 ? 255 : 1;
  Rgb value;
  for (int k = 0; k < 3; ++k) {
    const double share = std::clamp(colour[k] / one, 0.0, 1.0);
    value[k] = static_cast<std::uint8_t>(std::lround(255 * share));
  }
  return value;
}

Rgb LooksBuilder::colour_of(int vertex, int face) const {
  const std::optional<Vec3> none;
  std::optional<Vec3> colour = at(vertex_colours_, static_cast<std::size_t>(vertex), none);
  if (!colour) colour = at(face_colours_, static_cast<std::size_t>(face), none);
  return colour ? rgb(*colour) : kWhite;
}

SoupLooks LooksBuilder::finish(const PolygonSoup& soup) {
  const bool has_colours = !vertex_colours_.empty() || !face_colours_.empty();
  for (int face = 0; face < soup.face_count(); ++face) {
    for (int i = soup.first_corner[face]; i < soup.first_corner[face + 1]; ++i) {
      looks_.places.push_back(place_of(static_cast<std::size_t>(i), soup.corners[i]));
      if (has_colours) looks_.colours.push_back(colour_of(soup.corners[i], face));
    }
  }
  if (std::ranges::none_of(looks_.places, is_place)) looks_.places.clear();
  const bool has_materials =
      std::ranges::any_of(looks_.materials, [](int number) { return number >= 0; });
  looks_.materials.resize(has_materials ? soup.face_count() : 0, -1);
  return std::move(looks_);
}

}  // namespace foldwright
