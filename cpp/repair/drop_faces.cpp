#include "repair/drop_faces.h"

#include <algorithm>
#include <utility>

namespace foldwright {

void keep_only(TriangleSoup& soup, const std::vector<char>& keep) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    if (!keep[f]) continue;
    soup.faces[kept] = soup.faces[f];
    soup.source_faces[kept] = soup.source_faces[f];
    if (!soup.origins.empty()) soup.origins[kept] = soup.origins[f];
    ++kept;
  }
  soup.faces.resize(kept);
  soup.source_faces.resize(kept);
  if (!soup.origins.empty()) soup.origins.resize(kept);
}

void drop_degenerate(TriangleSoup& soup, double smallest_area) {
  std::vector<char> keep(soup.faces.size());
  for (int f = 0; f < soup.face_count(); ++f) {
    keep[f] = area_vector(soup, f).norm() > 2 * smallest_area;
  }
  keep_only(soup, keep);
}

void drop_duplicates(TriangleSoup& soup) {
  std::vector<std::pair<std::array<int, 3>, int>> sorted;
  for (int f = 0; f < soup.face_count(); ++f) {
    std::array<int, 3> face = soup.faces[f];
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    sorted.emplace_back(face, f);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> keep(soup.faces.size(), true);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) keep[sorted[i].second] = false;
  }
  keep_only(soup, keep);
}

}  // namespace foldwright
