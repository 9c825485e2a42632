#include "paper/flap_memory.h"

#include <algorithm>
#include <utility>

#include "paper/bytes.h"

namespace foldwright {
namespace {

constexpr std::size_t kMostBytes = std::size_t{16} << 20;

void add_mesh(const Mesh& mesh, Bytes& bytes) {
  bytes.add_all(mesh.positions, [&](const Vec3& p) {
    for (const double x : p) bytes.add(x);
  });
  bytes.add_all(mesh.faces, [&](const std::array<int, 3>& face) {
    for (const int vertex : face) bytes.add(vertex);
  });
  bytes.add_all(mesh.joints, [&](const Joint& joint) {
    bytes.add(joint.edge);
    bytes.add(joint.host);
  });
}

void add_options(const FlapOptions& options, Bytes& bytes) {
  bytes.add(static_cast<int>(options.side));
  bytes.add(options.shape.height);
  bytes.add(options.shape.least);
  for (const double angle : options.shape.angles) bytes.add(angle);
  bytes.add(static_cast<int>(options.style));
  bytes.add(static_cast<int>(options.borders));
  bytes.add_all(options.choices, [&](const FlapChoice& choice) {
    for (const int value : {choice.from, choice.to, static_cast<int>(choice.flaps)}) {
      bytes.add(value);
    }
    bytes.add(choice.height);
  });
}

std::size_t size_of(const FlapPlan& plan) {
  std::size_t flaps = 0;
  for (const std::vector<Flap>& of_net : plan.flaps) flaps += of_net.size();
  return flaps * sizeof(Flap) + plan.missed.size() * sizeof(MissedFlap);
}

}  // namespace

FlapPlan FlapMemory::place(const Mesh& mesh, std::span<const Net> nets, const FlapOptions& options,
                           std::span<const std::vector<std::vector<Vec2>>> keep_off) {
  Bytes bytes;
  add_mesh(mesh, bytes);
  bytes.add_all(nets, [&](const Net& net) { bytes.add(net); });
  add_options(options, bytes);
  bytes.add_all(keep_off, [&](const std::vector<std::vector<Vec2>>& of_net) {
    bytes.add_all(of_net, [&](const std::vector<Vec2>& polygon) {
      bytes.add_all(polygon, [&](const Vec2& p) { bytes.add(p); });
    });
  });
  std::string key = bytes.take();
  const auto held = std::ranges::find(kept_, key, &Kept::key);
  if (held == kept_.end()) {
    FlapPlan plan = place_flaps(mesh, nets, options, keep_off);
    kept_.push_front({std::move(key), std::move(plan)});
    forget_oldest();
  } else {
    std::rotate(kept_.begin(), held, held + 1);
  }
  return kept_.front().plan;
}

void FlapMemory::forget_oldest() {
  std::size_t bytes = 0;
  std::size_t count = 0;
  for (const Kept& kept : kept_) {
    bytes += kept.key.size() + size_of(kept.plan);
    if (count > 0 && bytes > kMostBytes) break;
    ++count;
  }
  kept_.resize(count);
}

}  // namespace foldwright
