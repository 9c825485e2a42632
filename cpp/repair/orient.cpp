#include "repair/orient.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "repair/edge_groups.h"

namespace foldwright {
namespace {

bool run_opposite(const TriangleSoup& soup, int half_edge, int partner) {
  return start_vertex(soup, half_edge) == end_vertex(soup, partner);
}

/// Breadth first, so that the contradictions of a band lie close together across it.
void walk_patch(const TriangleSoup& soup, const Partners& partners, int seed, int patch,
                Orientation& orientation) {
  std::vector<int> queue = {seed};
  orientation.patches[seed] = patch;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const int face = queue[next];
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const int other = partners[h] == -1 ? -1 : partners[h] / 3;
      if (other == -1) continue;
      const char turned = orientation.turned[face] ^ !run_opposite(soup, h, partners[h]);
      if (orientation.patches[other] == -1) {
        orientation.patches[other] = patch;
        orientation.turned[other] = turned;
        queue.push_back(other);
      } else if (orientation.turned[other] != turned && h < partners[h]) {
        orientation.contradictions.push_back(h);
      }
    }
  }
}

/// Per patch: whether its faces run along each edge as often in one direction as in the other.
/// Then and only then its volume does not depend on the point it is measured from.
std::vector<char> find_balanced(const TriangleSoup& soup, const Orientation& orientation,
                                int patch_count) {
  std::vector<char> balanced(patch_count, true);
  const EdgeGroups groups = group_half_edges(soup);
  std::vector<std::pair<int, int>> directions;  // patch, +1 or -1
  for (int g = 0; g < groups.count(); ++g) {
    directions.clear();
    for (const int h : groups.group(g)) {
      const bool ascending = start_vertex(soup, h) < end_vertex(soup, h);
      const bool turned = orientation.turned[h / 3] != 0;
      directions.emplace_back(orientation.patches[h / 3], ascending != turned ? 1 : -1);
    }
    std::sort(directions.begin(), directions.end());
    int sum = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      sum += directions[i].second;
      const int patch = directions[i].first;
      if (i + 1 < directions.size() && directions[i + 1].first == patch) continue;
      if (sum != 0) balanced[patch] = false;
      sum = 0;
    }
  }
  return balanced;
}

struct Measures {
  double volume = 0;       // six times the enclosed volume, with the faces turned
  double area = 0;         // twice the area
  double turned_area = 0;  // twice the area wound against the file
  int reference = -1;      // a vertex of the patch: volumes far from the origin lose digits
};

std::vector<Measures> measure(const TriangleSoup& soup, const Orientation& orientation,
                              const std::vector<char>& turned_before, int patch_count) {
  std::vector<Measures> measures(patch_count);
  for (int f = 0; f < soup.face_count(); ++f) {
    Measures& m = measures[orientation.patches[f]];
    if (m.reference == -1) m.reference = soup.faces[f][0];
    const Vec3 normal = area_vector(soup, f);
    const Vec3& corner = soup.positions[soup.faces[f][0]];
    const double volume = normal.dot(corner - soup.positions[m.reference]);
    m.volume += orientation.turned[f] ? -volume : volume;
    m.area += normal.norm();
    if (orientation.turned[f] != turned_before[f]) m.turned_area += normal.norm();
  }
  return measures;
}

/// Whether a patch encloses more than a rounding error of volume for its area.
bool encloses_volume(const Measures& m) {
  constexpr double kFlat = 1e-9;
  return std::abs(m.volume) > kFlat * std::pow(m.area, 1.5);
}

}  // namespace

Orientation orient(const TriangleSoup& soup, const Partners& partners,
                   const std::vector<char>& turned_before) {
  Orientation orientation;
  orientation.patches.assign(soup.faces.size(), -1);
  orientation.turned.assign(soup.faces.size(), false);
  int patch_count = 0;
  for (int f = 0; f < soup.face_count(); ++f) {
    if (orientation.patches[f] == -1) walk_patch(soup, partners, f, patch_count++, orientation);
  }
  const std::vector<char> balanced = find_balanced(soup, orientation, patch_count);
  const std::vector<Measures> measures = measure(soup, orientation, turned_before, patch_count);
  std::vector<char> wrong(patch_count);
  orientation.solid.resize(patch_count);
  for (int p = 0; p < patch_count; ++p) {
    const Measures& m = measures[p];
    orientation.solid[p] = balanced[p] && encloses_volume(m);
    wrong[p] = orientation.solid[p] ? m.volume < 0 : m.turned_area > m.area / 2;
  }
  for (int f = 0; f < soup.face_count(); ++f) {
    orientation.turned[f] ^= wrong[orientation.patches[f]];
  }
  return orientation;
}

void turn_faces(TriangleSoup& soup, const std::vector<char>& turned) {
  for (int f = 0; f < soup.face_count(); ++f) {
    if (!turned[f]) continue;
    std::swap(soup.faces[f][1], soup.faces[f][2]);
    if (!soup.origins.empty()) std::swap(soup.origins[f][1], soup.origins[f][2]);
  }
}

void turn_faces(TriangleSoup& soup, Partners& partners, const std::vector<char>& turned) {
  // Turned, corners (a, b, c) become (a, c, b): the half-edge at corner i is then at corner 2 - i.
  const auto moved = [&](int h) { return turned[h / 3] ? 3 * (h / 3) + 2 - h % 3 : h; };
  Partners new_partners(partners.size(), -1);
  for (int h = 0; h < static_cast<int>(partners.size()); ++h) {
    if (partners[h] != -1) new_partners[moved(h)] = moved(partners[h]);
  }
  partners = std::move(new_partners);
  turn_faces(soup, turned);
}

}  // namespace foldwright
