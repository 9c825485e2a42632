#include "read/read_model.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "encodings.h"
#include "geometry/random.h"
#include "model_text.h"

namespace foldwright::testing {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(ReadModel, GoesByTheEndingInAnyCase) {
  EXPECT_EQ(read_text(kTriangle, "dir.with.dots/Triangle.OBJ").face_count(), 1);
}

TEST(ReadModel, NamesTheFormatsThatAreRead) {
  EXPECT_EQ(refusal("no model", "a.xyz"), "unknown-format what=ending ending=xyz");
  EXPECT_EQ(refusal("no model", "triangle"), "unknown-format what=nothing");
}

TEST(ReadModel, RefusesAnEmptyFile) { EXPECT_EQ(refusal("", "a.obj"), "empty-file"); }

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
    {"b.stl", std::string(80, ' ') + whole("\1\0\0\0") + std::string(24, '\0') +
                  whole("\0\0\x80?\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80?\0\0\0\0\0\0")},
    {"b.off", whole("OFF BINARY\n\0\0\0\3\0\0\0\1\0\0\0\0") + std::string(12, '\0') +
                  whole("?\x80\0\0\0\0\0\0\0\0\0\0\0\0\0\0?\x80\0\0\0\0\0\0") +
                  whole("\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\0")},
};

TEST(ReadModel, GoesByTheContentsAndReportsAnotherEnding) {
  for (const auto& [name, sample] : kSamples) {
    const int faces = read_text(sample, name).face_count();
    for (const char* other : {"x.obj", "x.stl", "x.off", "x.ply", "x.glb", "x.txt"}) {
      SCOPED_TRACE(std::string(name) + " as " + other);
      const PolygonSoup soup = read_text(sample, other);
      EXPECT_EQ(soup.face_count(), faces);
      const bool is_same = std::string_view(name).substr(1) == std::string_view(other).substr(1);
      EXPECT_EQ(repair_named(soup.repairs, "other-format").count, is_same ? 0 : 1);
    }
    EXPECT_EQ(read_text(sample, "no_ending").repairs.size(), 0u) << name;
  }
  const Repair repair = repair_named(read_text(kTriangle, "a.STL").repairs, "other-format");
  EXPECT_EQ(repair.parameters, (Parameters{{"ending", "stl"}, {"format", "OBJ"}}));
}

TEST(ReadModel, TakesNoOtherPartOfANameForAnEnding) {
  for (const char* name : {"v1.2 final", "dir.obj/part", "a.", "b.\n"}) {
    EXPECT_TRUE(read_text(kTriangle, name).repairs.empty()) << name;
  }
}

TEST(ReadModel, NamesCommonFormatsThatAreNotRead) {
  const std::pair<std::string, const char*> cases[] = {
      {whole("glTF\2\0\0\0"), "glb"},
      {"{\"asset\": {\"version\": \"2.0\"}}", "gltf"},
      {"PK\3\4 3D/3dmodel.model", "3mf"},
      {"PK\3\4 model.obj", "zip"},
      {"%PDF-1.7", "pdf"},
      {"\x89PNG\r\n", "png"},
      {whole("Kaydara FBX Binary  \0"), "fbx"},
      {whole("MM\x0A\0\0\0\2\0\0\0"), "3ds"},
      {"\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<COLLADA>", "dae"},
      {"<?xml version=\"1.0\"?>\n<a/>", "xml"},
      {"<!DOCTYPE html>\n<html>", "html"},
      {"ISO-10303-21;", "step"},
      {"BLENDER-v279", "blend"},
  };
  for (const auto& [contents, name] : cases) {
    for (const char* file_name : {"a.obj", "a.stl", "a.bin"}) {
      EXPECT_EQ(refusal(contents, file_name),
                "unknown-format what=contents format=" + std::string(name));
    }
  }
}

TEST(ReadModel, TakesTextInAnyEncoding) {
  for (const auto& [name, sample] : kSamples) {
    if (sample.find(whole("\0")) != std::string::npos) continue;
    const PolygonSoup plain = read_text(sample, name);
    const std::u32string marked = U"\uFEFF" + std::u32string(sample.begin(), sample.end());
    std::vector<std::string> variants = {"\xEF\xBB\xBF" + sample};
    for (const TextEncoding encoding : kWideEncodings) {
      variants.push_back(encoded_ascii(sample, encoding));
      variants.push_back(encoded(marked, encoding));
    }
    for (const std::string& variant : variants) {
      const PolygonSoup soup = read_text(variant, name);
      EXPECT_EQ(soup.positions, plain.positions) << name;
      EXPECT_EQ(soup.corners, plain.corners) << name;
      EXPECT_TRUE(soup.repairs.empty()) << name;
    }
  }
}

TEST(ReadModel, TakesNamesAndCommentsOfAnyBytes) {
  const std::string latin1 = "Gr\xF6\xDF\x85\xA0\xFF";
  EXPECT_EQ(refusal("# " + latin1 + "\no " + latin1 + "\n" + kTriangle, "a.obj"), "");
  EXPECT_EQ(refusal("OFF # " + latin1 + "\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off"), "");
  EXPECT_EQ(refusal("solid " + latin1 + kSamples[2].second.substr(7), "a.stl"), "");
  std::string ply = kSamples[3].second;
  ply.insert(ply.find("element"), "comment " + latin1 + "\n");
  EXPECT_EQ(refusal(ply, "a.ply"), "");
}

TEST(ReadModel, RefusesNulInTextAndNamesTheLine) {
  for (const auto& [name, sample] : kSamples) {
    if (sample.find(whole("\0")) != std::string::npos) continue;
    const auto with_nul = [](std::string text) {
      text.insert(text.rfind(" 0"), 1, '\0');
      return text;
    };
    const std::string damaged = with_nul(sample);
    const auto before = damaged.begin() + static_cast<long>(damaged.find('\0'));
    const std::string expected =
        "bad-text place=line at=" + std::to_string(1 + std::count(damaged.begin(), before, '\n'));
    EXPECT_EQ(refusal(damaged, name), expected) << name;
    EXPECT_EQ(refusal(encoded_ascii(damaged, TextEncoding::kUtf16Le), name), expected) << name;
  }
}

TEST(ReadModel, RefusesControlCharactersInNumbers) {
  EXPECT_EQ(refusal("v 0 0 0\nv 2\x01"
                    "0 0 0\nv 0 1 0\nf 1 2 3\n",
                    "a.obj"),
            "bad-number place=line at=2 what=number word=2?0");
  EXPECT_EQ(refusal(kTriangle + "\x1A", "a.obj"), "");  // as DOS ended its texts
}

TEST(ReadModel, SurvivesTheEndAtAnyByte) {
  for (const auto& [name, sample] : kSamples) {
    for (std::size_t size = 0; size < sample.size(); ++size) {
      // Either what is there is whole, or one sentence says what is missing.
      EXPECT_EQ(refusal(sample.substr(0, size), name).find('\n'), std::string::npos) << size;
    }
  }
}

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
