#pragma once

#include <string>
#include <utility>

#include "paper/text_box.h"
#include "unfold/net.h"

namespace foldwright {

/// Values as raw bytes, by which what depends on them is kept; a count before each list keeps them
/// apart.
class Bytes {
 public:
  void add(double value) { append(&value, sizeof value); }
  void add(int value) { append(&value, sizeof value); }
  void add(const Vec2& p) {
    add(p.x());
    add(p.y());
  }
  void add(const Stroke& stroke) {
    add(stroke.from);
    add(stroke.to);
  }
  void add(const std::string& text) {
    add(static_cast<int>(text.size()));
    append(text.data(), text.size());
  }
  void add(const Net& net) {
    add_all(net.faces, [&](int face) { add(face); });
    add_all(net.vertices, [&](const Vec2& p) { add(p); });
    add_all(net.corners, [&](const std::array<int, 3>& corners) {
      for (const int corner : corners) add(corner);
    });
    add_all(net.edges, [&](const NetEdge& edge) {
      for (const int vertex : edge.vertices) add(vertex);
      add(edge.mesh_edge);
      add(static_cast<int>(edge.assignment));
      add(edge.angle);
    });
  }
  template <class Values, class Add>
  void add_all(const Values& values, Add&& add_one) {
    add(static_cast<int>(values.size()));
    for (const auto& value : values) add_one(value);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;

  void append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
};

}  // namespace foldwright
