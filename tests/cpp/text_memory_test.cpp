#include "paper/text_memory.h"

#include <gtest/gtest.h>

#include "meshes.h"
#include "nets.h"
#include "paper/labels.h"

namespace foldwright::testing {
namespace {

/// Labels of the six sides of a cube of 40 mm, the first one under this name.
LabelPlan labelled(const std::string& first, TextMemory* memory) {
  const std::vector<Net> nets = squares_of(cube());
  std::vector<std::string> names = {first};
  for (int piece = 1; piece < static_cast<int>(nets.size()); ++piece) {
    names.push_back(piece_letter(piece));
  }
  const std::vector<std::vector<Flap>> flaps(nets.size());
  LabelTask task = {nets, flaps, names, IdPlace::kInside};
  task.memory = memory;
  return place_labels(task);
}

std::vector<std::string> words(const LabelPlan& plan) {
  std::vector<std::string> all;
  for (const std::vector<Label>& labels : plan.labels) {
    for (const Label& label : labels) {
      all.push_back(label.text + " " + std::to_string(label.centre.x()) + " " +
                    std::to_string(label.centre.y()) + " " + std::to_string(label.size));
    }
  }
  return all;
}

PieceTexts texts_of(const std::string& word, std::size_t count) {
  PieceTexts texts;
  for (std::size_t i = 0; i < count; ++i) {
    texts.labels.push_back({word, Vec2::Zero(), 0, 3});
    texts.boxes.push_back({Vec2::Zero(), Vec2::UnitX(), 1, 1});
  }
  return texts;
}

TEST(TextMemory, ChangesNoLabel) {
  TextMemory memory;
  for (const char* first : {"A", "A", "Ear", "A", "Tail", "Ear"}) {
    const LabelPlan alone = labelled(first, nullptr);
    const LabelPlan remembered = labelled(first, &memory);
    EXPECT_EQ(words(remembered), words(alone)) << first;
    EXPECT_EQ(remembered.printed, alone.printed);
    EXPECT_EQ(remembered.skipped, alone.skipped);
  }
}

TEST(TextMemory, IsAskedBeforePlacesAreLookedFor) {
  const Mesh mesh = cube();
  const DualGraph graph = build_dual_graph(mesh);
  const std::vector<Net> nets = {make_net(mesh, restrict_to(graph, std::array{0}), {})};
  const std::vector<std::vector<Flap>> flaps(1);
  const std::vector<std::string> names = {"A"};
  TextMemory memory;
  memory.keep(bytes_of({nets.data(), {}, "A", IdPlace::kNone, {}, {}}), texts_of("kept", 1));
  LabelTask task = {nets, flaps, names, IdPlace::kNone};
  task.memory = &memory;
  EXPECT_EQ(place_labels(task).labels[0].at(0).text, "kept");
}

TEST(TextMemory, TellsNetsApartByAllThatTextsDependOn) {
  const Mesh mesh = cube();
  const DualGraph graph = build_dual_graph(mesh);
  const Net net = make_net(mesh, restrict_to(graph, std::array{0}), {});
  PieceTextTask task{&net, {}, "A", IdPlace::kInside, {}, {}};
  const std::string key = bytes_of(task);
  EXPECT_EQ(bytes_of(task), key);
  Net moved = net;
  moved.vertices[0].x() += 1e-9;
  EXPECT_NE(bytes_of({&moved, {}, "A", IdPlace::kInside, {}, {}}), key);
  EXPECT_NE(bytes_of({&net, {}, "B", IdPlace::kInside, {}, {}}), key);
  EXPECT_NE(bytes_of({&net, {}, "A", IdPlace::kNone, {}, {}}), key);
  const std::vector<Stroke> lines = {{Vec2(0, 0), Vec2(1, 1)}};
  EXPECT_NE(bytes_of({&net, {}, "A", IdPlace::kInside, lines, {}}), key);
}

TEST(TextMemory, ForgetsWhatWasNotAskedForLately) {
  TextMemory memory;
  constexpr std::size_t kLabels = 20'000;  // some megabytes each
  memory.keep("asked", texts_of("asked", kLabels));
  memory.keep("not asked", texts_of("not asked", kLabels));
  for (int i = 0; i < 20; ++i) {
    ASSERT_NE(memory.find("asked"), nullptr) << i;
    memory.keep("other " + std::to_string(i), texts_of("other", kLabels));
  }
  EXPECT_EQ(memory.find("asked")->labels.front().text, "asked");
  EXPECT_EQ(memory.find("not asked"), nullptr);
}

}  // namespace
}  // namespace foldwright::testing
