#include "search/certified_layers.h"

#include <algorithm>
#include <array>

namespace foldwright {
namespace {

// Shares of the folding that are looked at first: most collisions come late.
constexpr std::array<double, 5> kFirstShares = {0.3, 0.6, 0.8, 0.9, 0.97};

// The layers keep faces a little farther apart than the certificate asks, so that what is free of
// collisions there can be told apart in between.
constexpr double kSearchClearance = 0.8;

}  // namespace

CertifiedLayers::CertifiedLayers(const DualGraph& graph, double clearance)
    : graph_(&graph),
      foldable_(make_foldable(graph, kSearchClearance * clearance)),
      exact_(make_foldable(graph, clearance)) {}

void CertifiedLayers::add_first(MovingLayout& layout) { add(kFirstShares, layout); }

bool CertifiedLayers::add(std::span<const double> shares, MovingLayout& layout) {
  bool added = false;
  for (const double share : shares) {
    if (std::ranges::find(shares_, share) != shares_.end()) continue;
    shares_.push_back(share);
    layout.add_layer(foldable_, share);
    added = true;
  }
  return added;
}

void CertifiedLayers::lay(MovingLayout& layout) const {
  for (const double share : shares_) layout.add_layer(foldable_, share);
}

void CertifiedLayers::begin_certificate(std::span<const int> folds) {
  certificate_.emplace(exact_, folds, straight_leg(*graph_));
}

std::int64_t CertifiedLayers::certify(std::int64_t work) {
  const std::int64_t slice = std::min(work, kStepSlice);
  certificate_->step(slice);
  return slice;
}

std::optional<std::vector<double>> CertifiedLayers::take_counterexamples() {
  const bool certified = certificate_->state() == Certificate::State::kCertified;
  std::vector<double> counterexamples = certificate_->counterexamples();
  certificate_.reset();
  if (certified) return std::nullopt;
  return counterexamples;
}

}  // namespace foldwright
