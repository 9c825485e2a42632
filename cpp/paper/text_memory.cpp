#include "paper/text_memory.h"

#include <cstdint>
#include <utility>

#include "paper/bytes.h"

namespace foldwright {
namespace {

// Half of what is held: older texts are forgotten when recent ones come to as much.
constexpr std::size_t kMostRecentBytes = std::size_t{8} << 20;

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
  bytes.add(*task.net);
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
