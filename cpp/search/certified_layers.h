#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fold/certificate.h"
#include "search/moving_layout.h"

namespace foldwright {

/// After so many accepted moves a search lays its tree out anew, before rounding can pile up.
inline constexpr std::int64_t kRefreshEvery = 2000;

/// The shares of the folding at which a search looks for collisions, and the certificate of the
/// whole motion, which says where else to look.
class CertifiedLayers {
 public:
  /// `graph` must outlive this object. `clearance`: in mean edge lengths, above 0
  CertifiedLayers(const DualGraph& graph, double clearance);
  // Layouts and the certificate refer to what stands here.
  CertifiedLayers(const CertifiedLayers&) = delete;
  CertifiedLayers& operator=(const CertifiedLayers&) = delete;

  /// Whether no shares are looked at yet.
  bool empty() const { return shares_.empty(); }
  /// Looks at the first few shares in a layout. \pre empty()
  void add_first(MovingLayout& layout);
  /// Looks at more shares; false when it did at all of them already.
  bool add(std::span<const double> shares, MovingLayout& layout);
  /// Looks at the same shares in a layout that was made anew.
  void lay(MovingLayout& layout) const;

  /// Begins to certify that a net folds straight.
  void begin_certificate(std::span<const int> folds);
  bool is_certifying() const { return certificate_.has_value(); }
  /// Does a slice of up to `work` microseconds' worth of the certificate, and returns how much.
  /// \pre is_certifying()
  std::int64_t certify(std::int64_t work);
  /// Whether the certificate has come to its verdict.
  bool is_decided() const {
    return certificate_ && certificate_->state() != Certificate::State::kRunning;
  }
  /// Ends the certificate: the shares at which faces meet, or nothing when the motion is certified.
  /// \pre is_decided()
  std::optional<std::vector<double>> take_counterexamples();

 private:
  const DualGraph* graph_;
  Foldable foldable_;  ///< for the layers
  Foldable exact_;     ///< for the certificate
  std::vector<double> shares_;
  std::optional<Certificate> certificate_;
};

}  // namespace foldwright
