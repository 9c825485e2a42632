#pragma once

#include <map>
#include <optional>
#include <set>

#include "pipeline/stage.h"

namespace foldwright {

/// A region's best tree so far.
struct Candidate {
  FoldTree folds;
  int overlaps = -1;  ///< -1: there is none yet
  int shortfall = 0;  ///< see `SearchResult`
  FoldMotion motion;

  bool is_net() const { return overlaps == 0; }
};

/// Whether a part has so many overlaps left for its size that no exchange of a few panels at its
/// border will do.
bool is_far_from_net(const Region& region, const Candidate& candidate);

/// The same of a part with a net, and of collisions while it folds.
bool is_far_from_motion(const Candidate& candidate);

/// The best tree of every whole part, and what parts give each other where one has none.
///
/// That waits until all parts have been tried, and then goes one by one in the order of parts: each
/// changes the borders that the next one sees. Parts far from a net are regrouped first. Then
/// border panels are exchanged: a part without a net is given one, and one without a motion a net
/// that folds straight. Parts that still have no net are regrouped, too; each is only once.
class PartTrees {
 public:
  /// \pre the components have labels, and their parts numbers
  explicit PartTrees(const JobState& state);

  int part_count() const { return static_cast<int>(parts_.size()); }
  /// All panels of a part, as the labels are now.
  Region region(const JobState& state, int part) const;

  /// The part has what was asked, or gets no more.
  void accept(int part, FoundNet net);
  /// The part has not, and waits for an exchange.
  void postpone(Region region, Candidate candidate);

  /// Regroups the first part that is to be, and says which are to be searched anew: they are
  /// forgotten until then. A part that cannot be regrouped is among them if it has a net. Empty
  /// when none is left.
  std::vector<int> regroup_next(JobState& state);

  /// The part's borders may be changed as a whole once more.
  bool may_regroup(int part) const { return !regrouped_.contains(part); }

  bool exchanging() const { return exchange_.has_value(); }
  /// Part whose exchange is under way. \pre `exchanging()`
  int exchanging_part() const { return *exchange_; }
  /// Queues the next exchange; false when none waits.
  bool begin_exchange(const JobState& state, TaskQueue& queue);

  /// A part whose panels changed, and a tree of the changed part to search on from.
  struct Changed {
    int part;
    FoldTree folds;
  };
  /// Takes the outcome of the exchange: new labels, and parts to be searched again. They are
  /// forgotten until then.
  std::vector<Changed> end_exchange(JobState& state, const ExchangeResult& result);

  /// Parts that no exchange cured, with the best they came to; forgotten by this.
  std::vector<std::pair<int, Candidate>> take_uncured();

  /// Moves the trees that are nets to the state.
  void collect(JobState& state);

  /// The nets of parts that were forgotten after they had one, each with the panels it had then.
  std::vector<FoundNet> take_earlier();

 private:
  struct Tree {
    FoundNet net;
    int overlaps = 0;
    int shortfall = 0;  ///< 0: settled
  };
  /// Where a part is.
  struct Place {
    int component = 0;
    int label = 0;
  };

  void forget(int part);
  PartsSoFar parts_so_far(const JobState& state, int component, bool for_motion) const;

  std::vector<Place> parts_;         ///< by part
  std::map<int, Tree> trees_;        ///< by part
  std::map<int, FoundNet> earlier_;  ///< by part: the net that it was forgotten with
  std::set<int> to_regroup_;
  std::set<int> regrouped_;  ///< parts that were, or cannot be
  std::set<int> waiting_;    ///< parts whose exchange is to come
  std::set<int> uncured_;
  std::map<int, int> exchanges_;  ///< by part: how many it had
  std::optional<int> exchange_;   ///< part whose exchange is under way
};

}  // namespace foldwright
