// Prints how often each heuristic makes a net, of many more unfoldings than the tests look at.
#include <cstdio>

#include "heuristic_table.h"

int main() {
  constexpr int kHulls = 500;
  constexpr int kRuns = 50;  // directions per surface
  std::fputs(foldwright::testing::heuristic_table(kHulls, kRuns).c_str(), stdout);
}
