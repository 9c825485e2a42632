#include "segment/min_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

struct Network {
  struct Terminal {
    double on_sink_side, on_source_side;
  };
  struct Link {
    int a, b;
    double cost;
  };
  std::vector<Terminal> terminals;
  std::vector<Link> links;

  /// Of having the nodes of a bit set on the source's side.
  double cost(unsigned with_source) const {
    double sum = 0;
    const auto is_with_source = [&](int node) { return ((with_source >> node) & 1u) != 0; };
    for (int node = 0; node < static_cast<int>(terminals.size()); ++node) {
      sum += is_with_source(node) ? terminals[node].on_source_side : terminals[node].on_sink_side;
    }
    for (const Link& link : links) {
      if (is_with_source(link.a) != is_with_source(link.b)) sum += link.cost;
    }
    return sum;
  }

  unsigned least_cut() const {
    MinCut cut(static_cast<int>(terminals.size()));
    for (int node = 0; node < static_cast<int>(terminals.size()); ++node) {
      cut.add_terminal(node, terminals[node].on_sink_side, terminals[node].on_source_side);
    }
    for (const Link& link : links) cut.add_link(link.a, link.b, link.cost);
    unsigned with_source = 0;
    const std::vector<char> sides = cut.solve();
    for (std::size_t node = 0; node < sides.size(); ++node) {
      if (sides[node]) with_source |= 1u << node;
    }
    return with_source;
  }
};

TEST(MinCut, IsAsCheapAsTheBestOfAllCuts) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const int nodes = 1 + static_cast<int>(random.uniform() * 9);
    Network network;
    for (int node = 0; node < nodes; ++node) {
      network.terminals.push_back({random.uniform(), random.uniform()});
      for (int other = 0; other < node; ++other) {
        if (random.uniform() < 0.5) network.links.push_back({node, other, random.uniform()});
      }
    }
    double least = network.cost(0);
    for (unsigned sides = 1; sides < 1u << nodes; ++sides) {
      least = std::min(least, network.cost(sides));
    }
    EXPECT_NEAR(network.cost(network.least_cut()), least, 1e-9) << "round " << round;
  }
}

TEST(MinCut, FollowsTheTerminalsWhereNothingIsLinked) {
  const Network network{{{2, 1}, {1, 2}, {0, 0}}, {}};
  EXPECT_EQ(network.least_cut(), 0b001u);
}

TEST(MinCut, CutsALongChainAtItsWeakestLink) {
  MinCut cut(5000);
  cut.add_terminal(0, std::numeric_limits<double>::infinity(), 0);
  cut.add_terminal(4999, 0, std::numeric_limits<double>::infinity());
  for (int node = 0; node < 4999; ++node) cut.add_link(node, node + 1, node == 3000 ? 0.5 : 1);
  std::vector<char> expected(5000, 0);
  std::fill_n(expected.begin(), 3001, 1);
  EXPECT_TRUE(cut.solve() == expected);
}

}  // namespace
}  // namespace foldwright::testing
