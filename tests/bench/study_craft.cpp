// What makes the parts easy to craft [paper, 5.2 and Fig. 9]: how even they are in size, how many
// of their folds are mountains, and how convex they are. `bench_study_craft [FOLDER]`

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "split_unfolding.h"
#include "study.h"
#include "svg_canvas.h"
#include "timed_job.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

constexpr int kParts = 9, kFaces = 1000;
constexpr double kBar = 22, kRow = 190, kLeft = 20, kHeight = 130;
constexpr double kFlat = 1e-3;  // of a panel's own size: so far above a plane counts as in it

/// Share of folds that are mountains among those inside parts that are not flat, in percent.
double mountain_share(const DualGraph& graph, std::span<const int> part) {
  int mountains = 0, all = 0;
  for (const Hinge& hinge : graph.hinges) {
    if (part[hinge.panels[0]] != part[hinge.panels[1]] || hinge.angle == 0) continue;
    ++all;
    mountains += hinge.angle < 0;
  }
  return all == 0 ? 100 : 100.0 * mountains / all;
}

/// Share of pairs of panels of one part, by area, that bend away from each other: each has the
/// centroid of the other behind its plane. All of a convex surface; in percent.
double convexity(const Mesh& mesh, const DualGraph& graph, std::span<const int> part) {
  std::vector<Vec3> centroids, normals;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    Vec3 centroid = Vec3::Zero(), normal = Vec3::Zero();
    for (const int face : graph.panel_faces(panel)) {
      const auto& [a, b, c] = mesh.faces[face];
      const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
      centroid += face_area(mesh, face) / graph.areas[panel] * (p + q + r) / 3;
      normal += (q - p).cross(r - p);
    }
    centroids.push_back(centroid);
    normals.push_back(normal.normalized());
  }
  const auto behind = [&](int panel, int plane) {
    return normals[plane].dot(centroids[panel] - centroids[plane]) <
           kFlat * std::sqrt(graph.areas[plane]);
  };
  double convex = 0, all = 0;
  for (int a = 0; a < graph.panel_count(); ++a) {
    for (int b = 0; b < a; ++b) {
      if (part[a] != part[b]) continue;
      const double weight = graph.areas[a] * graph.areas[b];
      all += weight;
      if (behind(a, b) && behind(b, a)) convex += weight;
    }
  }
  return all == 0 ? 100 : 100 * convex / all;
}

/// Areas of pieces over that of the surface, the largest first.
std::vector<double> shares(const DualGraph& graph, std::span<const int> part) {
  std::vector<double> areas(1 + *std::max_element(part.begin(), part.end()), 0);
  double total = 0;
  for (int panel = 0; panel < graph.panel_count(); ++panel) {
    areas[part[panel]] += graph.areas[panel];
    total += graph.areas[panel];
  }
  for (double& area : areas) area /= total;
  std::sort(areas.rbegin(), areas.rend());
  return areas;
}

/// Standard deviation over the mean, in percent: 0 where all are alike.
double spread(const std::vector<double>& values) {
  double mean = 0, variance = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) {
    variance += (value - mean) * (value - mean) / static_cast<double>(values.size());
  }
  return 100 * std::sqrt(variance) / mean;
}

void draw_bars(SvgCanvas& canvas, const Vec2& at, const std::string& title,
               const std::vector<double>& values) {
  canvas.text({at.x(), at.y() + 16}, 14, Anchor::kStart, title);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double height = kHeight * values[i] / 0.5;  // half the surface is a full bar
    canvas.rectangle({at.x() + kBar * static_cast<double>(i), at.y() + kRow - 20 - height, kBar - 4,
                      std::max(1.0, height)},
                     part_colour(1));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (!has_study_models("study of craft")) return 0;
  const StudyFolder folder(std::span(argv, static_cast<std::size_t>(argc)));
  Table table({"model", "spread of areas, %", "split at overlaps: spread, %", "largest piece, %",
               "mountains in parts, %", "in the model, %", "convexity of parts, %",
               "of the model, %"});
  SvgCanvas canvas(1000, kRow * std::size(kStudyModels));
  double y = 0;
  for (const char* model : kStudyModels) {
    const auto result =
        run_timed(organic_model(model, kFaces), {.parts = {.count = kParts}}).result;
    const Mesh& mesh = result->mesh;
    const DualGraph graph = build_dual_graph(mesh);
    const std::vector<int> whole(graph.panel_count(), 0);
    std::vector<int> part;
    for (int panel = 0; panel < graph.panel_count(); ++panel) {
      part.push_back(result->labels[graph.panel_faces(panel)[0]]);
    }
    const std::vector<double> areas = shares(graph, part);
    const std::vector<double> split = shares(graph, unfold_and_split(mesh, graph));
    table.add({model, decimal(spread(areas), 0), decimal(spread(split), 0),
               decimal(100 * areas[0], 0), decimal(mountain_share(graph, part), 1),
               decimal(mountain_share(graph, whole), 1), decimal(convexity(mesh, graph, part), 1),
               decimal(convexity(mesh, graph, whole), 1)});
    draw_bars(canvas, {kLeft, y}, std::string(model) + ": shares of the surface, by part", areas);
    draw_bars(canvas, {kLeft + 330, y}, "unfolded and split at overlaps", split);
    y += kRow;
  }
  folder.save("figure-9.md",
              "Fig. 9 and section 5.2: size, folds and convexity; 9 parts, 1000 faces", table);
  folder.save("figure-9.svg", canvas.svg());
  return 0;
}
