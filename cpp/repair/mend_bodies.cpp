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
void keep_cavities(TriangleSoup& soup, BodyWork& work, std::vector<char>& turned) {
  const std::vector<int>& outermost = work.outermost;
  const std::vector<FileWinding> windings =
      file_windings(soup, work.bodies, turned, outermost.size());
  const auto is_cavity = [&](std::size_t body) {
    if (outermost[body] == -1) return false;
    const FileWinding own = windings[body];
    const FileWinding around = windings[outermost[body]];
    return own != around && own != FileWinding::kMixed && around != FileWinding::kMixed;
  };
  for (std::size_t body = 0; body < outermost.size(); ++body) {
    if (is_cavity(body)) work.cavity_of[body] = outermost[body];
  }
  std::vector<char> in_cavity(turned.size(), false);
  for (int f = 0; f < soup.face_count(); ++f) {
    in_cavity[f] = work.cavity_of[work.bodies[f]] != -1;
  }
  turn_faces(soup, in_cavity);
  for (std::size_t f = 0; f < turned.size(); ++f) turned[f] ^= in_cavity[f];
}

}  // namespace

int BodyWork::inner() const {
  return static_cast<int>(std::ranges::count_if(outermost, [](int body) { return body != -1; }));
}

int BodyWork::unitable() const {
  return static_cast<int>(std::ranges::count_if(crossings.pairs, [&](const auto& pair) {
    return closed[pair.first] && closed[pair.second];
  }));
}

BodyWork mend_bodies(TriangleSoup& soup, std::vector<char>& turned) {
  BodyWork work;
  work.bodies = find_bodies(soup);
  work.crossings = find_crossings(soup, work.bodies);
  if (!work.crossings.checked) return work;
  work.outermost = find_nesting(soup, work.bodies, work.crossings.pairs);
  work.cavity_of.assign(work.outermost.size(), -1);
  work.closed.assign(work.outermost.size(), true);
  for (const int h : border_half_edges(soup)) work.closed[work.bodies[h / 3]] = false;
  if (work.inner() > 0) keep_cavities(soup, work, turned);
  return work;
}

void drop_inner_bodies(TriangleSoup& soup, BodyWork& work, std::vector<char>& turned) {
  const auto is_inner = [&](int body) { return work.outermost[body] != -1; };
  std::erase_if(work.crossings.pairs,
                [&](const auto& pair) { return is_inner(pair.first) || is_inner(pair.second); });
  std::erase_if(work.crossings.bodies, is_inner);
  std::vector<char> keep;
  std::vector<char> turned_left;
  std::vector<int> bodies_left;
  for (int f = 0; f < soup.face_count(); ++f) {
    keep.push_back(!is_inner(work.bodies[f]));
    if (!keep.back()) continue;
    turned_left.push_back(turned[f]);
    bodies_left.push_back(work.bodies[f]);
  }
  keep_only(soup, keep);
  turned = std::move(turned_left);
  work.bodies = std::move(bodies_left);
}

}  // namespace foldwright
