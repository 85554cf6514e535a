// Hard and hostile inputs, by their numbers in the plan of extremes.

#include <gtest/gtest.h>
#include <pthread.h>

#include <ctime>
#include <functional>

#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

/// Returns the CPU time of a call, independent of other load.
double SecondsOf(const std::function<void()>& f) {
  const std::clock_t start = std::clock();
  f();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Runs on a thread with a small stack, so that recursion over the user's data is detected.
void OnSmallStack(const std::function<void()>& f) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 256 * 1024), 0);
  pthread_t thread;
  const auto run = [](void* work) -> void* {
    (*static_cast<const std::function<void()>*>(work))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, const_cast<std::function<void()>*>(&f)), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

TEST(Extremes, E5_LightsMayBeFarAndStrong) {
  const Scene scene = ParseText(
                          "point_light 1e30 1e-30 0  1e12 0 0  0 0 1\nspot_light 1 1 1  0 0 0  0 0 -1  1 0 0  0 1\n"
                          "spot_light 1 1 1  0 0 0  0 0 -1  1 0 0  3.14159 1\ndir_light 1 1 1  1e-300 0 0")
                          .scene;
  EXPECT_EQ(scene.lights.size(), 4u);
  const auto sunny = scene.lights[3]->Illuminate({}, {});
  ASSERT_TRUE(sunny);
  EXPECT_EQ(sunny->to_light, (R3::Vector{-1, 0, 0}));
}

TEST(Extremes, E7_AttenuationMayBeZero) {
  const Scene scene = ParseText("point_light 0.5 0.25 1  0 0 0  0 0 0").scene;
  EXPECT_EQ(scene.lights.at(0)->Illuminate({3, 4, 0}, {})->irradiance, (R2::Color{0.5, 0.25, 1}));
}

TEST(Extremes, G2_AParallelUpIsReplacedByAPerpendicularOne) {
  for (const char* up : {"0 0 -1", "0 0 1", "1e-12 0 3", "0 0 0"}) {
    const ParsedScene parsed = ParseText("camera 0 0 6  0 0 -1  " + std::string(up) + "  0.25  0.01 100");
    EXPECT_NEAR(Length(parsed.scene.camera.up), 1, 1e-15);
    EXPECT_NEAR(Dot(parsed.scene.camera.up, parsed.scene.camera.towards), 0, 1e-15);
  }
}

TEST(Extremes, G8_EmptyScenesAreScenes) {
  for (const char* text : {"", "\n", "# nothing", "\xEF\xBB\xBF"}) {
    const Scene scene = ParseText(text).scene;
    EXPECT_TRUE(scene.root.children.empty());
    EXPECT_TRUE(scene.root.bounds.IsEmpty());
    EXPECT_EQ(scene.camera.eye, (R3::Point{0, 0, 3}));
    EXPECT_EQ(scene.lights.size(), 2u);
  }
  EXPECT_EQ(ParseText("dir_light 1 1 1 0 0 -1").scene.camera.xfov, 0.25);
  EXPECT_EQ(ParseText("camera 1 0 6  0 0 -1  0 1 0  0.5  0.01 100").scene.camera.eye, (R3::Point{1, 0, 6}));
}

TEST(Extremes, H1_AHundredThousandLevelsAreReadWithLittleStack) {
  constexpr std::size_t depth = 100'000;
  const Folder folder;
  folder.Write("scene.scn", Repeated("begin -1" + identity, depth) + "sphere -1 0 0 0 1\n" + Repeated("end ", depth));
  std::size_t found = 0;
  OnSmallStack([&] {
    const ParsedScene parsed = Parse(folder / "scene.scn", {});
    const Node* node = &parsed.scene.root;
    for (; !node->children.empty(); node = &node->children[0]) ++found;
    EXPECT_EQ(parsed.scene.root.bounds, (R3::Box{{-1, -1, -1}, {1, 1, 1}}));
  });
  EXPECT_EQ(found, depth + 1);
}

TEST(Extremes, H2_AMillionChildrenTakeLinearTime) {
  const Folder folder;
  folder.Write("few.scn", Repeated("begin -1" + identity + "end\n", 10'000));
  folder.Write("many.scn", Repeated("begin -1" + identity + "end\n", 200'000));
  const double few = SecondsOf([&] { Parse(folder / "few.scn", {}); });
  const double many =
      SecondsOf([&] { EXPECT_EQ(Parse(folder / "many.scn", {}).scene.root.children.size(), 200'000u); });
  EXPECT_LT(many, 20 * few * 5 + 0.2 * patience);
}

/// Writes files 0.scn to count-1.scn, each including the next, the last one with the given text.
void WriteChain(const Folder& folder, int count, const std::string& last) {
  for (int i = 0; i < count; ++i)
    folder.Write(std::to_string(i) + ".scn", i + 1 < count ? "include " + std::to_string(i + 1) + ".scn" : last);
}

TEST(Extremes, H3_ACycleOfAHundredFilesIsFoundToo) {
  const Folder folder;
  WriteChain(folder, 100, "include 0.scn");
  ParseOptions options;
  options.include_depth = 200;
  EXPECT_TRUE(Contains(ReportOf(folder, "0.scn", options), "99.scn -> 0.scn"));
  EXPECT_TRUE(Contains(ReportOf(folder, "0.scn"), "includes are nested deeper than 64 files"));
}

TEST(Extremes, H3_IncludesNest64DeepByDefaultAndTakeNoStack) {
  const Folder folder;
  WriteChain(folder, 1000, "sphere -1 0 0 0 1");
  EXPECT_EQ(ReportOf(folder, "935.scn"), "");  // 64 includes
  EXPECT_TRUE(Contains(ReportOf(folder, "934.scn"), "999.scn"));
  ParseOptions options;
  options.include_depth = 1000;
  OnSmallStack([&] { EXPECT_EQ(Parse(folder / "0.scn", options).scene.root.children.size(), 1u); });
}

TEST(Extremes, H4_IncludesThatDoubleThirtyTimesEndWithinASecond) {
  const Folder folder;
  for (int i = 0; i < 30; ++i) {
    const std::string next = "include " + std::to_string(i + 1) + ".scn\n";
    folder.Write(std::to_string(i) + ".scn", next + next);
  }
  folder.Write("30.scn", "sphere -1 0 0 0 1");
  std::string report;
  EXPECT_LT(SecondsOf([&] { report = ReportOf(folder, "0.scn"); }), 1 * patience);
  EXPECT_TRUE(Contains(report, "more than 10000 includes")) << report;
}

TEST(Extremes, H4_TheNumberOfNodesIsLimited) {
  ParseOptions options;
  options.max_nodes = 10;
  EXPECT_EQ(ReportOf(Repeated("sphere -1 0 0 0 1\n", 10), options), "");
  EXPECT_TRUE(Contains(ReportOf(Repeated("sphere -1 0 0 0 1\n", 11), options),
                       ":11:1: error: the scene has more than 10 nodes"));
  EXPECT_TRUE(Contains(ReportOf(Repeated("begin -1" + identity, 11), options), "more than 10 nodes"));
}

TEST(Extremes, H5_BracesThatDoNotMatchAreErrorsWithoutStack) {
  const Folder folder;
  folder.Write("open.scn", Repeated("begin -1" + identity, 100'000));
  folder.Write("extra.scn", Repeated("end\n", 100'000));
  OnSmallStack([&] {
    EXPECT_TRUE(Contains(ReportOf(folder, "open.scn"), "the innermost of 100000 unclosed groups"));
    EXPECT_TRUE(Contains(ReportOf(folder, "extra.scn"), "and at least 980 more errors"));
  });
}

TEST(Extremes, K7_LineEndsMarksAndMissingNewlinesAreAllFine) {
  for (const char* text : {"sphere -1\r\n0 0 0 1\r\nbox -1 0 0 0 1 1 1\r\n", "sphere -1\r0 0 0 1\rbox -1 0 0 0 1 1 1\r",
                           "\xEF\xBB\xBFsphere\t-1\v0\f0 0 1 # x\nbox -1 0 0 0 1 1 1"}) {
    EXPECT_EQ(ParseText(text).scene.root.children.size(), 2u) << text;
  }
}

TEST(Extremes, K7_LongLinesAndManyBlankLinesTakeLinearTime) {
  EXPECT_LT(SecondsOf([] { ParseText(std::string(30'000'000, '\n')); }), 10 * patience);
  EXPECT_LT(SecondsOf([] { ParseText(Repeated("# comment\n", 3'000'000)); }), 10 * patience);
  const std::string one_line = Repeated("sphere -1 0 0 0 1 ", 500'000);
  EXPECT_LT(SecondsOf([&] { EXPECT_EQ(ParseText(one_line).scene.root.children.size(), 500'000u); }), 10 * patience);
  // A mistake at the end of a long line is not searched from its beginning, nor is the line shown.
  const std::string report = ReportOf(one_line + "spere");
  EXPECT_TRUE(Contains(report, ":1:9000001: error: unknown command 'spere'; did you mean 'sphere'?")) << report.size();
}

const char* const sample =
    "# all commands\nmaterial .2 .2 .2  1 0 0  .5 .5 .5  0 0 0  0 0 0  10 1 0\n"
    "camera 0 0 6  0 0 -1  0 1 0  .25  .01 100\nbackground 0 0 1\nambient .1 .1 .1\ndir_light 1 1 1  0 0 -1\n"
    "begin 0  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\n  tri -1  0 0 0  1 0 0  0 1 0\n  mesh 0 t.off smooth\n"
    "  line 0  0 0 0  1 1 1\nend\ninclude inner.scn\n";

/// Parses, and returns true if that succeeded; any exception other than SceneErrors fails the test.
bool Parses(const Folder& folder, std::string_view scene) {
  folder.Write("scene.scn", scene);
  try {
    Parse(folder / "scene.scn", {});
    return true;
  } catch (const SceneErrors& errors) {
    EXPECT_FALSE(errors.All().empty());
    return false;
  }
}

TEST(Extremes, K9_ASceneCutAnywhereIsAnErrorOrAScene) {
  const Folder folder;
  folder.Write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.Write("inner.scn", "sphere -1 0 0 0 1");
  const std::string_view whole = sample;
  ASSERT_TRUE(Parses(folder, whole));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const bool parses = Parses(folder, whole.substr(0, length));
    const bool is_in_group = length >= whole.find("begin") + 5 && length < whole.find("end\n") + 3;
    EXPECT_FALSE(parses && is_in_group) << length;
  }
}

TEST(Extremes, K9_AFlippedBitGivesAnErrorOrAScene) {
  const Folder folder;
  folder.Write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.Write("inner.scn", "sphere -1 0 0 0 1");
  int errors = 0;
  for (std::size_t i = 0; i < std::string_view(sample).size(); ++i) {
    std::string flipped = sample;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << i % 8));
    errors += !Parses(folder, flipped);
  }
  EXPECT_GT(errors, 100);
}

TEST(Extremes, K10_TenMebibytesOfAnyTextTakeAtMostTenSeconds) {
  const Folder folder;
  for (const auto& [size, limit] : {std::pair<std::size_t, double>{64 << 10, 1}, {10 << 20, 10}}) {
    for (const std::string& part :
         {"begin -1" + identity, std::string("x "), std::string("mesh -1 t.off\n"), red, std::string("end\n"),
          std::string("spere -1 0 0 0 1\n"), std::string("sphere -1 0 0 nan nan\n"), std::string("9"),
          std::string("sphere -1 0 0 0 1\n"), std::string("include inner.scn\n"), std::string("\x80")}) {
      folder.Write("scene.scn", Repeated(part, size / part.size()));
      folder.Write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
      folder.Write("inner.scn", "");
      EXPECT_LT(SecondsOf([&] { ReportOf(folder, "scene.scn"); }), limit * patience) << part << size;
    }
  }
}

}  // namespace
}  // namespace ray
