#include "pipeline/values/result.h"

#include <bit>
#include <concepts>

namespace foldwright {
namespace {

/// Appends numbers as little-endian 64-bit words.
class Dump {
 public:
  void add(std::integral auto value) { word(static_cast<std::uint64_t>(value)); }
  void add(double value) { word(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec2& p) { add(p.x()), add(p.y()); }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.size());
    for (const T value : values) add(value);
  }

  std::string take() { return std::move(bytes_); }

 private:
  void word(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i)));
  }

  std::string bytes_;
};

void add_label(Dump& dump, const Label& label) {
  for (const char letter : label.text) dump.add(letter);
  dump.add(label.centre);
  dump.add(label.angle);
  dump.add(label.size);
  if (label.leader) dump.add(label.leader->from), dump.add(label.leader->to);
}

void add_piece(Dump& dump, const Piece& piece, const Placement& place) {
  dump.add(piece.part);
  dump.add(static_cast<int>(piece.cause));
  dump.add(piece.net.faces);
  for (const NetEdge& edge : piece.net.edges) {
    dump.add(edge.mesh_edge);
    dump.add(static_cast<int>(edge.assignment));
    dump.add(edge.angle);
  }
  for (const Vec2& p : piece.net.vertices) dump.add(p);
  for (const Flap& flap : piece.flaps) {
    dump.add(flap.edge);
    for (const Vec2& p : flap.corners) dump.add(p);
  }
  for (const Label& label : piece.labels) add_label(dump, label);
  for (const Stroke& mark : piece.tape_marks) dump.add(mark.from), dump.add(mark.to);
  for (const Stroke& line : piece.joint_lines) dump.add(line.from), dump.add(line.to);
  dump.add(static_cast<int>(piece.motion.kind));
  dump.add(piece.motion.root);
  dump.add(piece.motion.times);
  for (const std::vector<double>& angles : piece.motion.angles) dump.add(angles);
  dump.add(place.sheet);
  dump.add(place.x);
  dump.add(place.y);
}

}  // namespace

std::string canonical_dump(const JobResult& result) {
  Dump dump;
  for (const Vec3& p : result.mesh.positions) dump.add(p.x()), dump.add(p.y()), dump.add(p.z());
  dump.add(result.labels);
  dump.add(result.segmentation);
  dump.add(result.sheets.scale);
  for (std::size_t i = 0; i < result.pieces.size(); ++i) {
    add_piece(dump, result.pieces[i], result.sheets.placements[i]);
  }
  for (const Strip& strip : result.strips) {
    dump.add(strip.mesh_edge);
    dump.add(strip.sheet);
    for (const Vec2& p : strip.outline) dump.add(p);
    add_label(dump, strip.label);
  }
  return dump.take();
}

std::string hash_of(std::string_view bytes) {
  // Offset basis and prime of FNV-1a (Fowler, Noll, Vo).
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ull;
  }
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4)
    text.push_back("0123456789abcdef"[hash >> shift & 15]);
  return text;
}

}  // namespace foldwright
