#include "mesh/read_model.h"

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "model_text.h"

namespace foldwright::testing {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(ReadModel, GoesByTheEndingInAnyCase) {
  EXPECT_EQ(read_text(kTriangle, "dir.with.dots/Triangle.OBJ").face_count(), 1);
}

TEST(ReadModel, NamesTheFormatsThatAreRead) {
  EXPECT_EQ(refusal(kTriangle, "a.glb"),
            "files that end in '.glb' are not read; OBJ, STL, OFF and PLY are");
  EXPECT_EQ(refusal(kTriangle, "triangle"),
            "a file name without an ending tells no format; OBJ, STL, OFF and PLY are");
}

TEST(ReadModel, RefusesAnEmptyFile) { EXPECT_EQ(refusal("", "a.obj"), "the file is empty"); }

/// A literal with the NULs in it.
template <std::size_t kSize>
std::string whole(const char (&text)[kSize]) {
  return std::string(text, kSize - 1);
}

// Models to start from for the damage below: every format, with most of what it knows.
const std::pair<const char*, std::string> kSamples[] = {
    {"a.obj", kTriangle + "vt 0 0\nf 1/1 -2/1 \\\n 3//\n"},
    {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"},
    {"a.stl",
     "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 "
     "0\nendloop\n"
     "endfacet\nendsolid x\n"},
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
     "z\n"
     "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0\n3 0 1 "
     "2\n"},
    {"b.ply", whole("ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\n"
                    "property uchar y\nproperty uchar z\nelement face 1\nproperty list uchar uchar "
                    "vertex_index\nend_header\n\0\0\0\1\0\0\0\1\0\3\0\1\2")},
};

TEST(ReadModel, SurvivesAnyDamage) {
  for (const auto& [name, sample] : kSamples) {
    ASSERT_EQ(refusal(sample, name), "");
    Random random(3);
    for (int round = 0; round < 3000; ++round) {
      std::string text = sample;
      for (int hits = 1 + random.below(4); hits > 0 && !text.empty(); --hits) {
        const int at = random.below(static_cast<int>(text.size()));
        switch (random.below(4)) {
          case 0:
            text[at] = static_cast<char>(random.below(256));
            break;
          case 1:
            text.erase(at, random.below(8));
            break;
          case 2:
            text.insert(at, text.substr(random.below(static_cast<int>(text.size())), 9));
            break;
          default:
            text.resize(at + 1);
        }
      }
      EXPECT_EQ(refusal(text, name).find('\n'), std::string::npos) << round;  // or no refusal
    }
  }
}

}  // namespace
}  // namespace foldwright::testing
