#include "geometry/box_grid.h"

#include <gtest/gtest.h>

#include "geometry/random.h"

namespace foldwright::testing {
namespace {

template <int N>
Box<N> random_box(Random& random) {
  // Now and then one that covers so many cells that it is listed apart.
  const double size = random.below(20) == 0 ? 50 : 2;
  Box<N> box;
  for (int i = 0; i < N; ++i) {
    box.min[i] = 40 * random.uniform() - 20;
    box.max[i] = box.min[i] + size * random.uniform();
  }
  return box;
}

template <int N>
void expect_to_find_every_box() {
  Random random(3);
  BoxGrid<N> grid(100, 1);
  std::vector<Box<N>> boxes;
  for (int i = 0; i < 100; ++i) {
    boxes.push_back(random_box<N>(random));
    grid.insert(i, boxes[i]);
  }
  for (int round = 0; round < 300; ++round) {
    const int item = random.below(100);
    grid.remove(item, boxes[item]);
    boxes[item] = random_box<N>(random);
    grid.insert(item, boxes[item]);
    const Box<N> query = random_box<N>(random);
    std::vector<char> visited(100, 0);
    grid.visit(query, [&](int i) { return visited[i] = 1, true; });
    for (int i = 0; i < 100; ++i) {
      EXPECT_TRUE(visited[i] || !query.meets(boxes[i])) << "box " << i << ", round " << round;
    }
  }
}

TEST(BoxGrid, FindsEveryBoxThatMayMeetInThePlane) { expect_to_find_every_box<2>(); }
TEST(BoxGrid, FindsEveryBoxThatMayMeetInSpace) { expect_to_find_every_box<3>(); }

TEST(BoxGrid, StopsWhenToldTo) {
  BoxGrid<2> grid(10, 1);
  for (int i = 0; i < 10; ++i) grid.insert(i, {0, 0, 0.5, 0.5});
  int visits = 0;
  grid.visit({0, 0, 0.5, 0.5}, [&](int) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

}  // namespace
}  // namespace foldwright::testing
