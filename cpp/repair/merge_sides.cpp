#include "repair/merge_sides.h"

#include <algorithm>

#include "geometry/union_find.h"
#include "repair/drop_faces.h"
#include "repair/edge_groups.h"
#include "repair/flat_layers.h"

namespace foldwright {
namespace {

/// What stands for what: the faces of one side, and those of the other.
struct Twins {
  std::vector<int> first;
  std::vector<int> second;  ///< the later ones in the file
};

/// Layers that coincide: with the same side up and the opposite one.
void find_twins(const TriangleSoup& soup, const EdgeGroups& groups, double tolerance,
                LayerExtent extent, std::vector<Twins>& same, std::vector<Twins>& opposite) {
  const std::vector<FlatLayer> layers = find_flat_layers(soup, groups, tolerance, extent);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    for (std::size_t j = i + 1; j < layers.size() && layers[j].border == layers[i].border; ++j) {
      if (!coincide(soup, layers[i], layers[j], tolerance)) continue;
      const bool agree = area_vector(soup, layers[i]).dot(area_vector(soup, layers[j])) > 0;
      (agree ? same : opposite).push_back({layers[i].faces, layers[j].faces});
    }
  }
}

/// Sets of connected faces that are given from both sides.
class Sheets {
 public:
  Sheets(const TriangleSoup& soup, const EdgeGroups& groups, const std::vector<Twins>& twins)
      : sheets_(soup.face_count()), layer_(soup.faces.size(), -1) {
    for (const Twins& twin : twins) {
      for (const auto* side : {&twin.first, &twin.second}) {
        for (const int face : *side) {
          layer_[face] = side->front();
          sheets_.join(face, twin.first[0]);
        }
      }
    }
    connect_and_judge(groups);
  }

  /// Whether a face belongs to a wall between rooms, both of whose sides are needed.
  bool is_wall(int face) { return has_border_[sheets_.find(face)] && !ends_[sheets_.find(face)]; }

 private:
  UnionFind sheets_;
  std::vector<int> layer_;        // per face: the first face of its layer, -1 for other faces
  std::vector<char> has_border_;  // per leading face: other faces go on somewhere
  std::vector<char> ends_;        // ... fewer than two go on somewhere at the border

  bool is_doubled(int half_edge) const { return layer_[half_edge / 3] != -1; }

  void connect_and_judge(const EdgeGroups& groups) {
    for (int g = 0; g < groups.count(); ++g) {
      int last = -1;
      for (const int h : groups.group(g)) {
        if (!is_doubled(h)) continue;
        if (last != -1) sheets_.join(last, h / 3);
        last = h / 3;
      }
    }
    has_border_.assign(layer_.size(), false);
    ends_.assign(layer_.size(), false);
    for (int g = 0; g < groups.count(); ++g) judge(groups.group(g));
  }

  void judge(std::span<const int> edge) {
    int others = 0;
    int doubled = -1;
    for (const int h : edge) {
      if (is_doubled(h)) doubled = h / 3;
      others += !is_doubled(h);
    }
    if (doubled == -1) return;
    const int sheet = sheets_.find(doubled);
    const bool both_sides_only =
        edge.size() == 2 && others == 0 && layer_[edge[0] / 3] != layer_[edge[1] / 3];
    if (others > 0) has_border_[sheet] = true;
    if (others == 1 || both_sides_only) ends_[sheet] = true;
  }
};

void drop(std::vector<char>& keep, const std::vector<int>& faces) {
  for (const int face : faces) keep[face] = false;
}

bool all_kept(const std::vector<char>& keep, const std::vector<int>& faces) {
  return std::all_of(faces.begin(), faces.end(), [&](int face) { return keep[face]; });
}

void merge_layers(TriangleSoup& soup, double tolerance, LayerExtent extent, LayerChoice choice,
                  std::vector<int>& two_sided) {
  const EdgeGroups groups = group_half_edges(soup);
  std::vector<Twins> same;
  std::vector<Twins> opposite;
  find_twins(soup, groups, tolerance, extent, same, opposite);
  if (!choice.same) same.clear();
  if (!choice.opposite) opposite.clear();
  if (same.empty() && opposite.empty()) return;
  std::vector<char> keep(soup.faces.size(), true);
  for (const Twins& twin : same) {
    if (all_kept(keep, twin.first)) drop(keep, twin.second);
  }
  Sheets sheets(soup, groups, opposite);
  for (const Twins& twin : opposite) {
    if (sheets.is_wall(twin.first[0]) || !all_kept(keep, twin.first)) continue;
    for (const int face : twin.second) {
      if (keep[face]) two_sided.push_back(soup.source_faces[face]);
    }
    drop(keep, twin.second);
  }
  keep_only(soup, keep);
}

}  // namespace

std::vector<int> merge_sides(TriangleSoup& soup, double tolerance, LayerChoice choice) {
  std::vector<int> two_sided;
  // Whole polygons first: taken apart, or without a triangle that they happen to share, three
  // layers may be left in shares that repeat each other in no way.
  merge_layers(soup, tolerance, LayerExtent::kWhole, choice, two_sided);
  // At edges with very many faces no layers are told apart; single triangles are all the same.
  if (choice.same) drop_duplicates(soup);
  // What is flat only from edge to edge.
  merge_layers(soup, tolerance, LayerExtent::kToSharedEdges, choice, two_sided);
  return two_sided;
}

}  // namespace foldwright
