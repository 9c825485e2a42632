#include "repair/repair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "mesh/input_error.h"
#include "repair/close_cracks.h"
#include "repair/drawn_planes.h"
#include "repair/drop_faces.h"
#include "repair/fill_holes.h"
#include "repair/flatten_planes.h"
#include "repair/frame.h"
#include "repair/joints.h"
#include "repair/make_manifold.h"
#include "repair/mend_bodies.h"
#include "repair/merge_sides.h"
#include "repair/t_junctions.h"
#include "repair/thin_bodies.h"
#include "repair/triangulate_soup.h"
#include "repair/unite_bodies.h"
#include "repair/weld.h"

namespace foldwright {
namespace {

/// Notes what happened to some vertices, edges or faces, if it happened to any.
void report(RepairedModel& model, Code code, int count, Parameters more = {}) {
  if (count > 0) model.repairs.push_back({code, count, std::move(more)});
}

/// What a step did and to how many things, or would do where it is switched off.
struct StepWork {
  RepairStep step;
  Code code;
  int count;
  Parameters more = {};
};

void report(RepairedModel& model, const RepairOptions& options, StepWork work) {
  if (options.does(work.step)) {
    return report(model, work.code, work.count, std::move(work.more));
  }
  const std::string_view name = kRepairSteps[static_cast<std::size_t>(work.step)].name;
  report(model, "step-off", work.count, {{"what", name}});
}

/// What a step works on: where it is switched off a copy, which tells what it would do.
class Workpiece {
 public:
  Workpiece(TriangleSoup& triangles, bool is_done)
      : copy_(is_done ? TriangleSoup{} : triangles), piece_(is_done ? triangles : copy_) {}

  TriangleSoup& operator*() { return piece_; }

 private:
  TriangleSoup copy_;
  TriangleSoup& piece_;
};

/// Indices of the vertices that some face uses, ascending.
std::vector<int> used_vertices(std::span<const int> corners, std::size_t vertex_count) {
  std::vector<char> is_used(vertex_count, false);
  for (const int corner : corners) is_used[corner] = true;
  std::vector<int> used;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (is_used[v]) used.push_back(static_cast<int>(v));
  }
  return used;
}

/// Number of source faces of which something is left, or of which `selected` faces are a part.
int count_sources(const TriangleSoup& soup, int source_count, const std::vector<char>* selected) {
  std::vector<char> present(source_count, false);
  for (int f = 0; f < soup.face_count(); ++f) {
    const int source = soup.source_faces[f];
    if (source != -1 && (selected == nullptr || (*selected)[f])) present[source] = true;
  }
  return static_cast<int>(std::count(present.begin(), present.end(), true));
}

TriangleSoup welded_triangles(const PolygonSoup& soup, const std::vector<int>& used,
                              const Frame& frame, const RepairOptions& options,
                              RepairedModel& model) {
  std::vector<Vec3> positions;
  for (const int v : used) positions.push_back(frame.scaled(soup.positions[v]));
  std::vector<int> standing_for = weld(positions, options.weld_tolerance * frame.diagonal);
  int welded = 0;
  for (std::size_t i = 0; i < used.size(); ++i) welded += standing_for[i] != static_cast<int>(i);
  report(model, options, {RepairStep::kWeld, "welded-vertices", welded});
  if (!options.does(RepairStep::kWeld)) std::iota(standing_for.begin(), standing_for.end(), 0);
  std::vector<int> vertex_of(soup.positions.size(), -1);
  for (std::size_t i = 0; i < used.size(); ++i) vertex_of[used[i]] = standing_for[i];
  int polygons = 0;
  for (int f = 0; f < soup.face_count(); ++f) {
    polygons += soup.first_corner[f + 1] - soup.first_corner[f] > 3;
  }
  report(model, "triangulated-polygons", polygons);
  std::vector<double> errors(positions.size(), frame.scaled(soup.precision));
  for (std::size_t i = 0; i < used.size(); ++i) {
    const int stands = standing_for[i];
    const double moved = (positions[i] - positions[stands]).norm();
    errors[stands] = std::max(errors[stands], moved);
    model.largest_move = std::max(model.largest_move, frame.in_model_units(moved));
  }
  TriangleSoup triangles = triangulate_soup(soup, vertex_of, std::move(positions));
  triangles.errors = std::move(errors);
  return triangles;
}

/// Number of source faces in a list of which nothing is left.
int count_lost(const TriangleSoup& soup, int source_count, const std::vector<int>& sources) {
  std::vector<char> lost(source_count, false);
  for (const int source : sources) lost[source] = true;
  for (const int source : soup.source_faces) lost[source] = false;
  return static_cast<int>(std::count(lost.begin(), lost.end(), true));
}

/// Drops triangles without an area and those that repeat others, from either side.
class FaceDropper {
 public:
  // Vertices are at least the tolerance apart, so that the apex of a triangle this small lies
  // within two tolerances of its longest side: the crack it leaves is within reach of the closer.
  FaceDropper(int source_count, double tolerance, LayerChoice layers)
      : source_count_(source_count), tolerance_(tolerance), layers_(layers) {}

  void drop(TriangleSoup& triangles) {
    drop_degenerate(triangles, tolerance_ * tolerance_);
    const int before = count_sources(triangles, source_count_, nullptr);
    const std::vector<int> other_sides = merge_sides(triangles, tolerance_, layers_);
    const int two_sided = count_lost(triangles, source_count_, other_sides);
    two_sided_ += two_sided;
    duplicates_ += before - count_sources(triangles, source_count_, nullptr) - two_sided;
  }

  void report_to(RepairedModel& model, const TriangleSoup& triangles,
                 const RepairOptions& options) const {
    const int left = count_sources(triangles, source_count_, nullptr);
    const int told = duplicates_ + two_sided_ + model.unusable_faces;
    report(model, "dropped-degenerate-faces", source_count_ - left - told);
    FaceDropper all(source_count_, tolerance_, {});
    TriangleSoup copy = triangles;
    if (!layers_.same || !layers_.opposite) all.drop(copy);
    report(model, options,
           {RepairStep::kDuplicates, "dropped-duplicate-faces",
            layers_.same ? duplicates_ : all.duplicates_});
    report(model, options,
           {RepairStep::kTwoSided, "merged-two-sided",
            layers_.opposite ? two_sided_ : all.two_sided_});
  }

 private:
  int source_count_;
  double tolerance_;
  LayerChoice layers_;
  int duplicates_ = 0;
  int two_sided_ = 0;
};

LayerChoice dropped_layers(const RepairOptions& options) {
  return {.same = options.does(RepairStep::kDuplicates),
          .opposite = options.does(RepairStep::kTwoSided)};
}

/// Closes T-junctions of an edge's length, dropping what is left without an area.
ClosedCracks close_junctions(TriangleSoup& triangles, double tolerance, FaceDropper& dropper) {
  // Cutting a face at a crack may open another one; in practice the second pass finds none.
  constexpr int kMostPasses = 8;
  ClosedCracks closed;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    dropper.drop(triangles);
    const ClosedCracks closed_now = close_t_junctions(triangles, 2 * tolerance);
    if (closed_now.edges == 0) break;
    closed.edges += closed_now.edges;
    closed.moved += closed_now.moved;
  }
  return closed;
}

/// Drops what is no face and closes the cracks that this or the file leaves.
void mend_faces(TriangleSoup& triangles, const Frame& frame, const RepairOptions& options,
                RepairedModel& model) {
  const double tolerance = options.weld_tolerance * frame.diagonal;
  FaceDropper dropper(model.source_face_count, tolerance, dropped_layers(options));
  const bool joins = options.does(RepairStep::kJunctions);
  if (!joins) dropper.drop(triangles);
  FaceDropper others = dropper;
  const ClosedCracks junctions =
      close_junctions(*Workpiece(triangles, joins), tolerance, joins ? dropper : others);
  const bool closes = options.does(RepairStep::kCracks);
  const ClosedCracks cracks =
      close_cracks(*Workpiece(triangles, closes), options.widest_crack * frame.diagonal);
  dropper.drop(triangles);
  dropper.report_to(model, triangles, options);
  for (const auto& [is_done, moved] : {std::pair(joins, junctions.moved), {closes, cracks.moved}}) {
    if (is_done) model.largest_move += frame.in_model_units(moved);
  }
  report(model, options, {RepairStep::kJunctions, "closed-t-junctions", junctions.edges});
  report(model, options,
         {RepairStep::kCracks,
          "closed-cracks",
          cracks.edges,
          {{"width", frame.in_model_units(cracks.width)}}});
  if (triangles.faces.empty()) throw InputError("no-area", {{"what", "faces"}});
}

/// Fills the holes that are to be filled, and tells of those that could be.
void mend_holes(TriangleSoup& triangles, const Frame& frame, const RepairOptions& options,
                RepairedModel& model) {
  // What people call small; larger holes may well be meant.
  constexpr double kSmall = 0.1;
  const double least_height = 2 * options.weld_tolerance * frame.diagonal;
  const Holes holes = fill_holes(triangles, options.fill_holes * frame.longest, least_height);
  report(model, "filled-holes", holes.filled);
  report(model, "unfilled-holes", holes.refused);
  report(model, "huge-holes", holes.huge, {{"edges", kMostHoleEdges}});
  if (holes.left.empty()) return;
  const auto percent = [&](double width) {
    return std::ceil(1000 * width / frame.longest) / 10;  // enough to fill it
  };
  const auto is_small = [&](double width) { return percent(width) <= 100 * kSmall; };
  report(model, "open-holes", static_cast<int>(holes.left.size()),
         {{"percent", percent(holes.left.back())},
          {"small", static_cast<int>(std::ranges::count_if(holes.left, is_small))},
          {"small_percent", 100 * kSmall}});
}

/// Makes flat what was drawn flat.
void flatten_faces(TriangleSoup& triangles, const Frame& frame, const RepairOptions& options,
                   RepairedModel& model) {
  const bool is_done = options.does(RepairStep::kFlatten);
  const Flattening flattening =
      flatten_planes(*Workpiece(triangles, is_done), find_drawn_planes(triangles));
  std::vector<char> flattened(triangles.faces.size(), false);
  for (const int face : flattening.faces) flattened[face] = true;
  if (is_done) model.largest_move += frame.in_model_units(flattening.distance);
  report(model, options,
         {RepairStep::kFlatten,
          "flattened-faces",
          count_sources(triangles, model.source_face_count, &flattened),
          {{"distance", frame.in_model_units(flattening.distance)}}});
}

void report_manifold(const ManifoldWork& work, RepairedModel& model) {
  report(model, "split-nonmanifold-edges", work.nonmanifold_edges);
  report(model, "split-nonmanifold-vertices", work.splits.vertices);
  report(model, "halved-edges", work.splits.midpoints);
  report(model, "cut-nonorientable", work.contradictions);
}

/// Leaves out bodies inside others if that is asked for, or tells of them.
void sort_out_inner(TriangleSoup& triangles, const RepairOptions& options, BodyWork& bodies,
                    std::vector<char>& turned, RepairedModel& model) {
  const int inner = bodies.inner();
  if (!options.drop_inner || inner == 0) return report(model, "inner-bodies", inner);
  const int before = count_sources(triangles, model.source_face_count, nullptr);
  drop_inner_bodies(triangles, bodies, turned);
  const int left = count_sources(triangles, model.source_face_count, nullptr);
  report(model, "dropped-inner-bodies", inner, {{"faces", before - left}});
}

/// Makes one surface of bodies that run through each other.
void unite_crossing_bodies(TriangleSoup& triangles, const Frame& frame, const BodyWork& bodies,
                           const RepairOptions& options, RepairedModel& model) {
  const int before = count_sources(triangles, model.source_face_count, nullptr);
  const UnitedBodies result = unite_bodies(triangles, bodies, options.uniter);
  // Where surfaces nearly touch, they are cut into faces without an area.
  const double tolerance = options.weld_tolerance * frame.diagonal;
  FaceDropper dropper(model.source_face_count, tolerance, dropped_layers(options));
  if (options.does(RepairStep::kJunctions)) {
    const ClosedCracks junctions = close_junctions(triangles, tolerance, dropper);
    model.largest_move += frame.in_model_units(junctions.moved);
  } else {
    dropper.drop(triangles);
  }
  const int left = count_sources(triangles, model.source_face_count, nullptr);
  report(model, "united-bodies", result.united, {{"faces", before - left}});
  report(model, "not-united", result.open + result.failed, {{"open", result.open}});
}

/// Makes an oriented manifold of the faces, and mends how its bodies lie.
BodyWork mend_surface(TriangleSoup& triangles, const Frame& frame, const RepairOptions& options,
                      RepairedModel& model) {
  ManifoldWork manifold = make_manifold(triangles);
  BodyWork bodies = mend_bodies(triangles, manifold.turned);
  const auto turned = [&] {
    return count_sources(triangles, model.source_face_count, &manifold.turned);
  };
  if (options.unite && !bodies.crossings.pairs.empty()) {
    report(model, "flipped-faces", turned());
    report_manifold(manifold, model);
    unite_crossing_bodies(triangles, frame, bodies, options, model);
    std::vector<char> turned_then = make_manifold(triangles).turned;
    bodies = mend_bodies(triangles, turned_then);
    sort_out_inner(triangles, options, bodies, turned_then, model);
    return bodies;
  }
  sort_out_inner(triangles, options, bodies, manifold.turned, model);
  report(model, options, {RepairStep::kWinding, "flipped-faces", turned()});
  if (!options.does(RepairStep::kWinding)) {
    manifold.splits.midpoints += restore_winding(triangles, manifold.turned).midpoints;
  }
  report_manifold(manifold, model);
  return bodies;
}

/// Drops unused vertices and goes back to the model's units, with the bounding box's centre at the
/// origin.
void finish_mesh(TriangleSoup&& triangles, const Frame& frame, RepairedModel& model) {
  std::vector<int> corners;
  for (const auto& face : triangles.faces) corners.insert(corners.end(), face.begin(), face.end());
  const std::vector<int> used = used_vertices(corners, triangles.positions.size());
  Eigen::AlignedBox3d box;
  for (const int v : used) box.extend(triangles.positions[v]);
  const Vec3 centre = box.center();
  model.centre = frame.centre + frame.in_model_units(centre);
  std::vector<int> new_index(triangles.positions.size(), -1);
  std::vector<Vec3> positions;
  for (const int v : used) {
    new_index[v] = static_cast<int>(positions.size());
    positions.push_back(frame.in_model_units(Vec3(triangles.positions[v] - centre)));
  }
  for (auto& face : triangles.faces) {
    for (int& vertex : face) vertex = new_index[vertex];
  }
  model.origins = std::move(triangles.origins);
  model.mesh = make_mesh(std::move(positions), std::move(triangles.faces),
                         std::move(triangles.source_faces));
  model.mesh.joints = find_joints(model.mesh);
}

/// Tells what the mesh is, where people may not know or may have meant something else.
void report_shape(RepairedModel& model, const Frame& frame, const RepairOptions& options,
                  const BodyWork& bodies) {
  const Crossings& crossings = bodies.crossings;
  int borders = 0;
  for (const Mesh::Edge& edge : model.mesh.edges) borders += edge.faces[1] == -1;
  const double tolerance = options.weld_tolerance * frame.diagonal;
  const ThinBodies thin = find_thin_bodies(model.mesh, frame.in_model_units(tolerance));
  report(model, "open-border", borders, {{"gap", options.widest_crack}, {"bodies", thin.open}});
  report(model, "flat-bodies", thin.flat);
  report(model, "crossing-bodies", static_cast<int>(crossings.pairs.size()),
         {{"unitable", options.unite ? 0 : bodies.unitable()}});
  report(model, "self-crossing-bodies", static_cast<int>(crossings.bodies.size()));
  report(model, "crossings-unchecked", crossings.checked ? 0 : model.mesh.face_count());
}

}  // namespace

RepairedModel repair(const PolygonSoup& soup, const RepairOptions& options) {
  RepairedModel model;
  model.repairs = soup.repairs;
  model.source_face_count = soup.face_count();
  model.unusable_faces = soup.unusable_faces;
  const std::vector<int> used = used_vertices(soup.corners, soup.positions.size());
  if (used.empty()) throw InputError("no-faces", {{"what", "model"}});
  report(model, "dropped-unused-vertices", static_cast<int>(soup.positions.size() - used.size()));

  std::vector<Vec3> used_positions;
  for (const int v : used) used_positions.push_back(soup.positions[v]);
  const Frame frame = frame_of(used_positions);
  TriangleSoup triangles = welded_triangles(soup, used, frame, options, model);
  mend_faces(triangles, frame, options, model);
  mend_holes(triangles, frame, options, model);
  const BodyWork bodies = mend_surface(triangles, frame, options, model);
  flatten_faces(triangles, frame, options, model);
  finish_mesh(std::move(triangles), frame, model);
  report_shape(model, frame, options, bodies);
  return model;
}

}  // namespace foldwright
