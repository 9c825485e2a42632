#include "paper/text_memory.h"

#include <cstdint>
#include <utility>

namespace foldwright {
namespace {

// Half of what is held: older texts are forgotten when recent ones come to as much.
constexpr std::size_t kMostRecentBytes = std::size_t{8} << 20;

/// Appends values as raw bytes; a count before each list keeps them apart.
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

void add_net(const Net& net, Bytes& bytes) {
  bytes.add_all(net.vertices, [&](const Vec2& p) { bytes.add(p); });
  bytes.add_all(net.corners, [&](const std::array<int, 3>& corners) {
    for (const int corner : corners) bytes.add(corner);
  });
  bytes.add_all(net.edges, [&](const NetEdge& edge) {
    for (const int vertex : edge.vertices) bytes.add(vertex);
    bytes.add(static_cast<int>(edge.assignment));
  });
}

void add_id(const SideId& id, Bytes& bytes) {
  bytes.add_all(id.side->edges, [&](int edge) { bytes.add(edge); });
  bytes.add(id.side->from);
  bytes.add(id.side->to);
  bytes.add(id.text);
}

void add_surroundings(const Surroundings& around, Bytes& bytes) {
  for (const double value : around.paper.min) bytes.add(value);
  for (const double value : around.paper.max) bytes.add(value);
  bytes.add_all(around.obstacles, [&](const Obstacle& obstacle) {
    bytes.add_all(obstacle.polygon, [&](const Vec2& p) { bytes.add(p); });
  });
}

std::size_t size_of(const std::string& key, const PieceTexts& texts) {
  return key.size() + texts.labels.size() * (sizeof(Label) + sizeof(TextBox));
}

}  // namespace

std::string bytes_of(const PieceTextTask& task) {
  Bytes bytes;
  bytes.add(static_cast<int>(task.place));
  bytes.add(task.name);
  add_net(*task.net, bytes);
  bytes.add_all(task.flaps, [&](const Flap& flap) {
    bytes.add(flap.edge);
    bytes.add(flap.height);
    for (const Vec2& p : flap.corners) bytes.add(p);
  });
  bytes.add_all(task.lines, [&](const Stroke& line) { bytes.add(line); });
  bytes.add_all(task.ids, [&](const SideId& id) { add_id(id, bytes); });
  if (task.around) add_surroundings(*task.around, bytes);
  return bytes.take();
}

const PieceTexts* TextMemory::find(const std::string& key) {
  if (const auto found = recent_.find(key); found != recent_.end()) return &found->second;
  const auto found = older_.find(key);
  if (found == older_.end()) return nullptr;
  Kept::node_type node = older_.extract(found);
  keep(std::move(node.key()), std::move(node.mapped()));
  return &recent_.find(key)->second;
}

void TextMemory::keep(std::string key, PieceTexts texts) {
  const std::size_t size = size_of(key, texts);
  if (recent_bytes_ + size > kMostRecentBytes) {
    older_ = std::exchange(recent_, {});
    recent_bytes_ = 0;
  }
  recent_bytes_ += size;
  recent_.insert_or_assign(std::move(key), std::move(texts));
}

}  // namespace foldwright
