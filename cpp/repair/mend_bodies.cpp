#include "repair/mend_bodies.h"

#include <algorithm>
#include <utility>

#include "geometry/union_find.h"
#include "repair/drop_faces.h"
#include "repair/edge_groups.h"
#include "repair/nesting.h"
#include "repair/orient.h"

namespace foldwright {
namespace {

/// Per face its body: the surface that edges connect it to. Bodies count from 0.
std::vector<int> find_bodies(const TriangleSoup& soup) {
  UnionFind connected(soup.face_count());
  const EdgeGroups groups = group_half_edges(soup);
  for (int g = 0; g < groups.count(); ++g) {
    const auto edge = groups.group(g);
    for (const int h : edge) connected.join(h / 3, edge.front() / 3);
  }
  std::vector<int> bodies(soup.faces.size());
  int count = 0;
  for (int f = 0; f < soup.face_count(); ++f) {
    const int first = connected.find(f);
    bodies[f] = first == f ? count++ : bodies[first];
  }
  return bodies;
}

/// How the file winds a body, whose faces are all wound outwards now.
enum class FileWinding { kUnknown, kOutwards, kInwards, kMixed };

std::vector<FileWinding> file_windings(const TriangleSoup& soup, const std::vector<int>& bodies,
                                       const std::vector<char>& turned, std::size_t body_count) {
  std::vector<FileWinding> windings(body_count, FileWinding::kUnknown);
  for (int f = 0; f < soup.face_count(); ++f) {
    if (soup.source_faces[f] == -1) continue;
    const FileWinding own = turned[f] ? FileWinding::kInwards : FileWinding::kOutwards;
    FileWinding& winding = windings[bodies[f]];
    winding = winding == FileWinding::kUnknown || winding == own ? own : FileWinding::kMixed;
  }
  return windings;
}

/// Turns those bodies inwards again that the file winds against the one that they lie in: they are
/// cavities, whose paper shows its printed side to the hollow. A file that winds all its faces
/// inwards does so by mistake, and one that winds a body both ways says nothing.
void keep_cavities(TriangleSoup& soup, const std::vector<int>& bodies,
                   const std::vector<int>& outermost, std::vector<char>& turned) {
  const std::vector<FileWinding> windings = file_windings(soup, bodies, turned, outermost.size());
  const auto is_cavity = [&](int body) {
    if (outermost[body] == -1) return false;
    const FileWinding own = windings[body];
    const FileWinding around = windings[outermost[body]];
    return own != around && own != FileWinding::kMixed && around != FileWinding::kMixed;
  };
  std::vector<char> in_cavity(turned.size(), false);
  for (int f = 0; f < soup.face_count(); ++f) in_cavity[f] = is_cavity(bodies[f]);
  turn_faces(soup, in_cavity);
  for (std::size_t f = 0; f < turned.size(); ++f) turned[f] ^= in_cavity[f];
}

/// Leaves out the bodies that lie in others.
void drop_inner_bodies(TriangleSoup& soup, const std::vector<int>& bodies,
                       const std::vector<int>& outermost, Crossings& crossings,
                       std::vector<char>& turned) {
  const auto is_inner = [&](int body) { return outermost[body] != -1; };
  std::erase_if(crossings.pairs,
                [&](const auto& pair) { return is_inner(pair.first) || is_inner(pair.second); });
  std::erase_if(crossings.bodies, is_inner);
  std::vector<char> keep;
  std::vector<char> turned_left;
  for (int f = 0; f < soup.face_count(); ++f) {
    keep.push_back(!is_inner(bodies[f]));
    if (keep.back()) turned_left.push_back(turned[f]);
  }
  keep_only(soup, keep);
  turned = std::move(turned_left);
}

}  // namespace

BodyWork mend_bodies(TriangleSoup& soup, bool drop_inner, std::vector<char>& turned) {
  const std::vector<int> bodies = find_bodies(soup);
  BodyWork work{.crossings = find_crossings(soup, bodies)};
  if (!work.crossings.checked) return work;
  const std::vector<int> outermost = find_nesting(soup, bodies, work.crossings.pairs);
  work.inner =
      static_cast<int>(std::ranges::count_if(outermost, [](int around) { return around != -1; }));
  if (work.inner == 0) return work;
  keep_cavities(soup, bodies, outermost, turned);
  if (drop_inner) drop_inner_bodies(soup, bodies, outermost, work.crossings, turned);
  return work;
}

}  // namespace foldwright
