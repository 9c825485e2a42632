#include "result_value.h"

#include <emscripten/bind.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>

#include "arrays.h"
#include "names.h"

namespace foldwright {
namespace {

using emscripten::val;

/// A value of a parameter as JavaScript has it.
struct ParameterValue {
  val operator()(double number) const { return val(number); }
  val operator()(const std::string& text) const { return val(text); }
  template <class Item>
  val operator()(const std::vector<Item>& items) const {
    return list(items, [](const Item& item) { return val(item); });
  }
};

val repair_value(const Repair& repair) {
  val object = val::object();
  object.set("code", repair.code);
  object.set("count", repair.count);
  object.set("params", parameters_value(repair.parameters));
  return object;
}

/// Triples of coordinates in millimetres.
val positions_value(const std::vector<Vec3>& positions, double scale) {
  std::vector<double> values;
  for (const Vec3& p : positions) {
    for (const double x : {p.x(), p.y(), p.z()}) values.push_back(scale * x);
  }
  return doubles(values);
}

/// The mesh at its finished size.
val model_value(const JobResult& result) {
  val object = val::object();
  object.set("vertices", positions_value(result.mesh.positions, result.sheets.scale));
  object.set("faces", ints(flat(result.mesh.faces)));
  object.set("components", result.mesh.component_count);
  return object;
}

/// Fold angle of an edge as the page has it: NaN for a cut.
double degrees(const NetEdge& edge, double radians) {
  return edge.assignment == Assignment::kCut ? std::numeric_limits<double>::quiet_NaN()
                                             : radians * 180 / std::numbers::pi;
}

void set_edges(val& object, const Net& net) {
  std::vector<int> ends, mesh_edges;
  std::vector<double> angles;
  std::string assignments;
  for (const NetEdge& edge : net.edges) {
    ends.insert(ends.end(), edge.vertices.begin(), edge.vertices.end());
    mesh_edges.push_back(edge.mesh_edge);
    assignments.push_back(static_cast<char>(edge.assignment));
    angles.push_back(degrees(edge, edge.angle));
  }
  object.set("edges", ints(ends));
  object.set("assignments", assignments);
  object.set("foldAngles", doubles(angles));
  object.set("modelEdges", ints(mesh_edges));
}

val motion_value(const Piece& piece) {
  std::vector<double> angles;
  for (const std::vector<double>& key : piece.motion.angles) {
    for (std::size_t i = 0; i < key.size(); ++i) {
      angles.push_back(degrees(piece.net.edges[i], key[i]));
    }
  }
  val object = val::object();
  object.set("root", piece.motion.root);
  object.set("times", doubles(piece.motion.times));
  object.set("angles", doubles(angles));
  return object;
}

val flaps_value(const std::vector<Flap>& flaps) {
  std::vector<int> edges, bases;
  std::vector<double> corners, angles;
  for (const Flap& flap : flaps) {
    edges.push_back(flap.edge);
    bases.insert(bases.end(), flap.base.begin(), flap.base.end());
    for (const Vec2& p : flap.corners) corners.insert(corners.end(), {p.x(), p.y()});
    angles.push_back(flap.angle * 180 / std::numbers::pi);
  }
  val object = val::object();
  object.set("edges", ints(edges));
  object.set("bases", ints(bases));
  object.set("corners", doubles(corners));
  object.set("angles", doubles(angles));
  return object;
}

val seam_value(const NamedSeam& seam) {
  val object = val::object();
  object.set("modelEdges", ints(seam.mesh_edges));
  object.set("pieces", list(seam.nets, [](int piece) { return val(piece); }));
  object.set("texts", list(seam.id.texts, [](const std::string& text) { return val(text); }));
  object.set("name", seam.id.name);
  return object;
}

/// How many flaps there are, and why others are missing.
val flap_counts_value(const JobResult& result) {
  int misses[4] = {0, 0, 0, 0};
  for (const MissedFlap& miss : result.missed_flaps) ++misses[static_cast<int>(miss.why)];
  val missing = val::object();
  missing.set("narrow", misses[static_cast<int>(FlapMiss::kNarrow)]);
  missing.set("thin", misses[static_cast<int>(FlapMiss::kThin)]);
  missing.set("blocked", misses[static_cast<int>(FlapMiss::kBlocked)]);
  missing.set("short", misses[static_cast<int>(FlapMiss::kShort)]);
  const FlapCounts& counts = result.flap_counts;
  val object = val::object();
  object.set("wanted", counts.wanted);
  object.set("full", counts.full);
  object.set("shrunk", counts.shrunk);
  object.set("missing", missing);
  object.set("wanted_mm", counts.wanted_length);
  object.set("missing_mm", counts.missing_length);
  object.set("borders", counts.borders);
  object.set("strips", static_cast<int>(result.strips.size()));
  object.set("taped", result.taped);
  return object;
}

/// x and y of both ends of each stroke.
std::vector<double> coordinates_of(std::span<const Stroke> strokes) {
  std::vector<double> values;
  for (const auto& [from, to] : strokes) {
    values.insert(values.end(), {from.x(), from.y(), to.x(), to.y()});
  }
  return values;
}

/// Texts lie on the sheet as the piece does; angles in degrees.
val label_value(const Label& label) {
  val object = val::object();
  object.set("text", label.text);
  object.set("x", label.centre.x());
  object.set("y", label.centre.y());
  object.set("angle", label.angle * 180 / std::numbers::pi);
  object.set("size", label.size);
  if (label.leader) object.set("leader", doubles(coordinates_of(std::array{*label.leader})));
  if (label.is_beside) object.set("isBeside", true);
  return object;
}

val strip_value(const Strip& strip) {
  std::vector<double> outline;
  for (const Vec2& p : strip.outline) outline.insert(outline.end(), {p.x(), p.y()});
  val object = val::object();
  object.set("id", strip.id);
  object.set("modelEdge", strip.mesh_edge);
  object.set("sheet", strip.sheet);
  object.set("outline", doubles(outline));
  object.set("fold", doubles(coordinates_of(std::array{strip.fold})));
  object.set("foldAngle", strip.angle * 180 / std::numbers::pi);
  object.set("label", label_value(strip.label));
  return object;
}

val ids_value(const JobResult& result) {
  val object = val::object();
  object.set("printed", result.printed_ids);
  object.set("skipped", list(result.skipped_ids, [](const std::string& id) { return val(id); }));
  return object;
}

val piece_value(const Piece& piece, int id, const Placement& place) {
  const Net& net = piece.net;
  std::vector<double> vertices;
  Vec2 size = Vec2::Zero();
  for (const Vec2& p : net.vertices) {
    vertices.push_back(p.x());
    vertices.push_back(p.y());
    size = size.cwiseMax(p);
  }
  val object = val::object();
  for (const Flap& flap : piece.flaps) {
    for (const Vec2& p : flap.corners) size = size.cwiseMax(p);
  }
  object.set("id", id);
  object.set("name", piece.name);
  object.set("part", piece.part);
  object.set("cause", name_of<Cause>(kCauses, piece.cause));
  object.set("overlaps", piece.check.overlaps);
  object.set("width", size.x());
  object.set("height", size.y());
  object.set("vertices", doubles(vertices));
  object.set("faces", ints(flat(net.corners)));
  object.set("sources", ints(net.faces));
  set_edges(object, net);
  object.set("foldable", name_of<Folding>(kFoldings, piece.motion.kind));
  if (!piece.motion.times.empty()) object.set("motion", motion_value(piece));
  object.set("outlines", list(piece.outlines, ints));
  object.set("necks", doubles(piece.necks));
  object.set("flaps", flaps_value(piece.flaps));
  object.set("labels", list(piece.labels, label_value));
  object.set("tapeMarks", doubles(coordinates_of(piece.tape_marks)));
  object.set("jointLines", doubles(coordinates_of(piece.joint_lines)));
  object.set("sheet", place.sheet);
  object.set("x", place.x);
  object.set("y", place.y);
  object.set("angle", piece.angle * 180 / std::numbers::pi);
  return object;
}

val pieces_value(const JobResult& result) {
  val array = val::array();
  for (std::size_t i = 0; i < result.pieces.size(); ++i) {
    array.call<void>(
        "push", piece_value(result.pieces[i], static_cast<int>(i), result.sheets.placements[i]));
  }
  return array;
}

val part_name_value(const PartName& chosen) {
  val object = val::object();
  object.set("part", chosen.part);
  object.set("name", chosen.name);
  return object;
}

val saved_net_value(const SavedNet& net) {
  val object = val::object();
  object.set("part", net.part);
  object.set("cause", name_of<Cause>(kCauses, net.cause));
  object.set("faces", ints(net.faces));
  object.set("folds", ints(net.folds));
  object.set("foldable", name_of<Folding>(kFoldings, net.motion.kind));
  object.set("times", doubles(net.motion.times));
  object.set("shares", list(net.motion.shares, doubles));
  if (net.place) {
    const RigidMotion2& motion = net.place->motion;
    val place = val::object();
    place.set("sheet", net.place->sheet);
    place.set("x", motion.t.x());
    place.set("y", motion.t.y());
    place.set("angle", std::atan2(motion.s, motion.c) * 180 / std::numbers::pi);
    object.set("place", place);
  }
  return object;
}

/// A list as a typed array, row by row; null for an empty one.
template <class Row>
val rows_or_null(const char* array, const std::vector<Row>& rows) {
  if (rows.empty()) return val::null();
  std::vector<typename Row::value_type> values;
  for (const Row& row : rows) values.insert(values.end(), row.begin(), row.end());
  return copied(array, values);
}

val looks_value(const ModelLooks& looks, double scale) {
  val original = val::null();
  if (looks.original) {
    original = val::object();
    original.set("vertices", positions_value(looks.original->positions, scale));
    original.set("faces", ints(flat(looks.original->faces)));
  }
  const FaceLooks& faces = looks.faces;
  val surface = val::object();
  surface.set("original", original);
  surface.set("places", rows_or_null("Float32Array", faces.places));
  surface.set("colours", rows_or_null("Uint8Array", faces.colours));
  surface.set("materials", faces.materials.empty() ? val::null() : ints(faces.materials));
  const auto text = [](const std::string& name) { return val(name); };
  val object = val::object();
  object.set("surface", surface);
  object.set("materialNames", list(looks.material_names, text));
  object.set("libraries", list(looks.libraries, text));
  return object;
}

val sheets_value(const SheetLayout& layout) {
  val array = val::array();
  for (int i = 0; i < layout.sheet_count; ++i) {
    val sheet = val::object();
    sheet.set("width", layout.sheet_width);
    sheet.set("height", layout.sheet_height);
    array.call<void>("push", sheet);
  }
  return array;
}

}  // namespace

val parameters_value(const Parameters& parameters) {
  val object = val::object();
  for (const auto& [name, value] : parameters) {
    object.set(name, std::visit(ParameterValue{}, value));
  }
  return object;
}

val notice_value(const Notice& notice) {
  val object = val::object();
  object.set("code", notice.code);
  object.set("params", parameters_value(notice.parameters));
  return object;
}

val result_value(const JobResult& result) {
  val search = val::object();
  search.set("generations", result.generations);
  search.set("moves", static_cast<double>(result.moves));
  val object = val::object();
  object.set("file", result.file);
  object.set("model", model_value(result));
  object.set("deviation", result.sheets.scale * result.simplified_deviation);
  if (result.looks) object.set("looks", looks_value(*result.looks, result.sheets.scale));
  object.set("repairs", list(result.repairs, repair_value));
  object.set("segmentation", ints(result.segmentation));
  object.set("labels", ints(result.labels));
  object.set("parts", result.parts);
  object.set("names", list(result.names, part_name_value));
  object.set("pieces", pieces_value(result));
  object.set("nets", list(result.nets, saved_net_value));
  object.set("sheets", sheets_value(result.sheets));
  object.set("strips", list(result.strips, strip_value));
  object.set("efficiency", result.sheets.efficiency);
  object.set("scale", result.sheets.scale);
  object.set("seams", list(result.seams, seam_value));
  object.set("flaps", flap_counts_value(result));
  object.set("ids", ids_value(result));
  object.set("search", search);
  object.set("notices", list(result.notices, notice_value));
  object.set("hash", result.hash);
  return object;
}

}  // namespace foldwright
