#include "read/soup_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "read/text_scanner.h"

namespace foldwright {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Stands for no vertex: below any number that a format counts from.
constexpr long long kNoVertex = std::numeric_limits<long long>::min() / 2;

}  // namespace

double SoupBuilder::text_coordinate(std::string_view word, int line) {
  const std::optional<double> value = parse_number(word);
  if (!value) {
    meet_fault(no_number(word, line));
    return kNoNumber;
  }
  decimal_commas_ += word.find(',') != std::string_view::npos;
  if (std::isfinite(*value)) precision_.add_text(word, *value);
  return *value;
}

double SoupBuilder::single_coordinate(double value) {
  if (std::isfinite(value)) precision_.add_single(value);
  return value;
}

double SoupBuilder::double_coordinate(double value) {
  if (std::isfinite(value)) precision_.add_double(value);
  return value;
}

void SoupBuilder::add_vertex(const Vec3& position, const Place& place) {
  const bool has_place = position.allFinite();
  if (!has_place) {
    meet_fault({"not-finite", place, {{"what", "coordinate"}}});
    if (!first_placeless_) first_placeless_ = place;
  }
  soup_.positions.push_back(has_place ? position : Vec3::Zero());
  has_place_.push_back(has_place);
}

void SoupBuilder::meet_fault(const InputError& fault) {
  if (!first_fault_) first_fault_ = fault;
}

void SoupBuilder::add_lost_corner(const InputError& fault) {
  meet_fault(fault);
  add_corner(kNoVertex);
}

void SoupBuilder::end_face(const Place& place) {
  soup_.first_corner.push_back(static_cast<int>(corners_.size()));
  places_.push_back(place);
}

void SoupBuilder::end_early(const InputError& fault) {
  meet_fault(fault);
  corners_.resize(ended_corner_count());
  end_.emplace();
  std::ranges::copy_if(fault.parameters(), std::back_inserter(*end_), [](const Parameter& known) {
    return known.name == "place" || known.name == "at";
  });
}

/// Whether a file of a format that counts from 1 plainly counts from 0: so read, it names every
/// vertex and nothing else. A slip in a file that counts from 1 leaves the last one named, too.
bool SoupBuilder::counts_from_zero() const {
  if (first_index_ != 1 || corners_.empty()) return false;
  std::vector<char> named(vertex_count(), false);
  for (const long long corner : corners_) {
    if (corner < 0 || corner >= vertex_count()) return false;
    named[corner] = true;
  }
  return std::ranges::all_of(named, [](char is_named) { return is_named; });
}

/// Makes the corners numbers from 0.
void SoupBuilder::resolve_corners() {
  if (counts_from_zero()) {
    looks_.count_places_from_zero();
    note({"counts-from-zero", face_count()});
    return;
  }
  for (long long& corner : corners_) corner -= first_index_;
}

/// Notes the faces that name no vertex of the file, and those at vertices without a place.
std::vector<char> SoupBuilder::find_unusable_faces() {
  std::vector<char> unusable(face_count(), false);
  int misnumbered = 0;
  int placeless = 0;
  Place first_misnumbered = {"face", 0};
  for (int f = 0; f < face_count(); ++f) {
    bool at_placeless = false;
    for (int i = soup_.first_corner[f]; i < soup_.first_corner[f + 1] && !unusable[f]; ++i) {
      const bool exists = corners_[i] >= 0 && corners_[i] < vertex_count();
      at_placeless = at_placeless || (exists && !has_place_[corners_[i]]);
      if (exists) continue;
      unusable[f] = true;
      meet_fault({"bad-index",
                  places_[f],
                  {{"what", "beyond"},
                   {"index", corners_[i] + first_index_},
                   {"vertices", vertex_count()},
                   {"first", first_index_}}});
    }
    if (unusable[f]) {
      if (misnumbered++ == 0) first_misnumbered = places_[f];
    } else if (at_placeless) {
      unusable[f] = true;
      ++placeless;
    }
  }
  if (misnumbered > 0) note({"dropped-misnumbered-faces", misnumbered, at(first_misnumbered)});
  if (placeless > 0) note({"dropped-placeless-faces", placeless, at(*first_placeless_)});
  return unusable;
}

/// A file of which more than half is lost is not a model with a slip, but one that is damaged or
/// read in a wrong way.
void SoupBuilder::require_enough(int unusable) const {
  const int usable = face_count() - unusable;
  const long long meant = std::max<long long>(face_count(), end_ ? announced_faces_ : 0);
  if (first_fault_ && (usable == 0 || 2 * static_cast<long long>(usable) < meant)) {
    throw InputError(*first_fault_);
  }
  if (usable == 0) {
    throw InputError("no-faces", {{"what", vertex_count() == 0 ? "nothing" : "vertices"}});
  }
}

/// Takes the corners from the faces that cannot be used, in the surface and in its looks.
void SoupBuilder::drop_corners(const std::vector<char>& unusable) {
  SoupLooks& looks = soup_.looks;
  int left = 0;
  int begin = 0;
  for (int f = 0; f < face_count(); ++f) {
    const int end = soup_.first_corner[f + 1];
    for (int i = begin; i < end && !unusable[f]; ++i, ++left) {
      soup_.corners[left] = soup_.corners[i];
      if (!looks.places.empty()) looks.places[left] = looks.places[i];
      if (!looks.colours.empty()) looks.colours[left] = looks.colours[i];
    }
    begin = end;
    soup_.first_corner[f + 1] = left;
  }
  soup_.corners.resize(left);
  if (!looks.places.empty()) looks.places.resize(left);
  if (!looks.colours.empty()) looks.colours.resize(left);
}

PolygonSoup SoupBuilder::finish() {
  resolve_corners();
  const std::vector<char> unusable = find_unusable_faces();
  soup_.unusable_faces = static_cast<int>(std::ranges::count(unusable, true));
  require_enough(soup_.unusable_faces);
  if (end_) note({"cut-off", face_count(), *end_});
  if (decimal_commas_ > 0) note({"decimal-commas", decimal_commas_});
  for (int f = 0; f < face_count(); ++f) {
    for (int i = soup_.first_corner[f]; i < soup_.first_corner[f + 1]; ++i) {
      soup_.corners.push_back(unusable[f] ? 0 : static_cast<int>(corners_[i]));
    }
  }
  soup_.precision = precision_.rounding_error();
  soup_.looks = looks_.finish(soup_);
  if (looks_.lost_places() > 0) note({"lost-picture-places", looks_.lost_places()});
  if (soup_.unusable_faces > 0) drop_corners(unusable);
  return std::move(soup_);
}

PolygonSoup build_soup(int first_index, const std::function<void(SoupBuilder&)>& read) {
  SoupBuilder builder(first_index);
  try {
    read(builder);
  } catch (const InputError& fault) {
    if (fault.code() != "truncated") throw;
    builder.end_early(fault);
  }
  return builder.finish();
}

}  // namespace foldwright
