#include "values.h"

#include <emscripten/bind.h>

#include <string>

#include "arrays.h"
#include "result_value.h"

namespace foldwright {
namespace {

using emscripten::val;

val matrix_value(const MatrixPicture& matrix) {
  val object = val::object();
  object.set("size", matrix.size);
  object.set("values", copied("Uint8Array", matrix.values));
  if (!matrix.blocks.empty()) object.set("blocks", ints(matrix.blocks));
  return object;
}

val net_value(const NetPicture& net) {
  val object = val::object();
  object.set("corners", copied("Float32Array", net.corners));
  object.set("sources", ints(net.sources));
  object.set("overlapping", copied("Uint8Array", net.overlapping));
  return object;
}

val typed(const char* type) {
  val object = val::object();
  object.set("type", std::string(type));
  return object;
}

const char* stage_name(StageId stage) {
  constexpr const char* kNames[] = {"read", "learn", "cluster", "search", "compact", "paper"};
  return kNames[static_cast<int>(stage)];
}

/// One overload per kind of event.
struct EventValue {
  val operator()(const StageEvent& event) const {
    val object = typed("stage");
    object.set("stage", std::string(stage_name(event.stage)));
    object.set("progress", event.progress);
    return object;
  }
  val operator()(const ModelEvent& event) const {
    const Mesh& mesh = event.surface->mesh;
    std::vector<float> vertices;
    for (const Vec3& p : mesh.positions) {
      for (const double x : {p.x(), p.y(), p.z()}) vertices.push_back(static_cast<float>(x));
    }
    val object = typed("model");
    object.set("vertices", copied("Float32Array", vertices));
    object.set("faces", ints(flat(mesh.faces)));
    object.set("file", event.file);
    return object;
  }
  val operator()(const LearnedEvent& event) const {
    val object = typed("learned");
    object.set("runs", event.runs);
    object.set("of", event.of);
    if (event.matrix) object.set("matrix", matrix_value(*event.matrix));
    return object;
  }
  val operator()(const SegmentedEvent& event) const {
    val object = typed("segmented");
    object.set("labels", ints(event.labels));
    return object;
  }
  val operator()(const GenerationEvent& event) const {
    val object = typed("generation");
    object.set("part", event.part);
    object.set("generation", event.generation);
    object.set("best", event.best);
    object.set("overlaps", event.overlaps);
    object.set("hyperbolic", event.hyperbolic);
    if (event.net) object.set("net", net_value(*event.net));
    return object;
  }
  val operator()(const NetEvent& event) const {
    val object = typed("net");
    object.set("part", event.part);
    object.set("piece", event.piece);
    return object;
  }
  val operator()(const Notice& event) const {
    val object = notice_value(event);
    object.set("type", std::string("notice"));
    return object;
  }
  val operator()(const DraftEvent& event) const {
    val object = typed("draft");
    object.set("result", result_value(*event.result));
    return object;
  }
  val operator()(const DoneEvent& event) const {
    val object = typed("done");
    object.set("result", result_value(*event.result));
    return object;
  }
  val operator()(const CancelledEvent& event) const {
    val object = typed("cancelled");
    if (event.best) object.set("best", result_value(*event.best));
    return object;
  }
  val operator()(const ErrorEvent& event) const {
    val object = typed("error");
    object.set("code", event.message.code);
    object.set("params", parameters_value(event.message.parameters));
    if (!event.faces.empty()) object.set("faces", ints(event.faces));
    return object;
  }
};

}  // namespace

val to_value(const Event& event) { return std::visit(EventValue{}, event); }

}  // namespace foldwright
