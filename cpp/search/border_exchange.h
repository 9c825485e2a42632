#pragma once

#include <map>
#include <memory>

#include "search/tree_search.h"

namespace foldwright {

/// What is known of the parts before an exchange.
struct PartsSoFar {
  std::vector<int> labels;  ///< the part of each panel
  /// Mesh edges at which the best trees found so far fold, of all parts together: searches start
  /// from them.
  std::vector<int> fold_edges;
  /// Conflicts of the best tree of each part that has no net yet, or none that folds.
  std::map<int, int> shortfalls;
};

struct ExchangeOptions {
  int part = 0;          ///< the part that has no net, or none that folds
  int most_steps = 300;  ///< exchanges tried; cures need 1 to 20 accepted ones
  /// Moves of all searches together, a second or some: cures took 10 to 300 thousand.
  std::int64_t most_moves = 600'000;
  /// An exchange that adds d conflicts is still made with probability exp(-d / temperature).
  double temperature = 0.5;
  double clearance = 0;  ///< of the nets' straight folding, as in `TreeSearchOptions`
  std::uint64_t seed = 1;
};

/// Gives a part that has no net a border that has one, panel by panel, with its neighbours.
///
/// A step hands one border panel over, where the best tree so far has most conflicts, searches both
/// parts anew for a while, and keeps the exchange when the conflicts of both together do not grow.
/// Parts stay connected, none vanishes, and a neighbour comes to no more conflicts than it had: one
/// with a net keeps a net, and with a clearance gets one that folds straight. Why it works: a part
/// has no net when it holds a pocket of negative curvature near its border, such as a hyperbolic
/// vertex whose neighbours all lie on it.
class BorderExchange {
 public:
  /// `parts` refers to the panels of `graph`. Mesh and graph must outlive this object.
  BorderExchange(const Mesh& mesh, const DualGraph& graph, PartsSoFar parts,
                 const ExchangeOptions& options = {});

  enum class State { kRunning, kFound, kGaveUp };

  /// Does about `work` microseconds' worth and says where it stands.
  State step(std::int64_t work);

  const std::vector<int>& labels() const { return labels_; }
  /// Conflicts left, of each other part that has none.
  const std::map<int, int>& shortfalls() const { return shortfalls_; }
  /// Best trees of the parts that changed, of the graph restricted to each part.
  const std::map<int, FoldTree>& trees() const { return trees_; }
  /// Conflicts left; 0 once it is found, -1 before the first search has ended.
  int shortfall() const { return shortfall_; }
  std::int64_t moves() const { return moves_; }
  double progress() const;

 private:
  /// Panel `panel` goes from its part to part `to`.
  struct Exchange {
    int panel = -1;
    int to = -1;
  };
  /// A part being searched, with the graph that the search refers to.
  struct Attempt {
    DualGraph graph;
    std::unique_ptr<TreeSearch> search;
  };

  std::vector<int> panels_of(int part) const;
  void start(Attempt& attempt, int part, std::int64_t patience, int good_enough);
  FoldTree tree_of_folds(const DualGraph& graph);
  void remember_folds(const Attempt& attempt);
  std::vector<double> weigh_panels() const;
  int known_shortfall(int part) const;
  Exchange choose();
  void begin_step();
  void end_step();

  const Mesh* mesh_;
  const DualGraph* graph_;
  ExchangeOptions options_;
  Random random_;
  std::vector<int> labels_;
  std::vector<std::vector<int>> vertices_of_panel_;
  std::vector<char> folds_;       ///< per mesh edge: some part's best tree folds there
  std::vector<char> hyperbolic_;  ///< per vertex: more than a full turn of face angles
  std::vector<char> held_;        ///< per panel: it has a fold that is never to be cut
  std::map<int, FoldTree> trees_;
  int shortfall_ = -1;
  std::map<int, int> shortfalls_;
  std::vector<double> weights_;  ///< per panel: how much the part's best tree has conflicts there
  int steps_ = 0;
  std::int64_t moves_ = 0;
  State state_ = State::kRunning;
  Exchange exchange_;
  int neighbour_ = -1;  ///< the other part of the exchange under trial
  Attempt own_, other_;
};

}  // namespace foldwright
