// Groups and cameras that are placed by words.
#include "source/parse/scn/Placing.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

R3::Matrix Placed(const std::string& words) {
  return ParseText("begin -1 " + words + " sphere -1 0 0 0 1 end").scene.root.children.at(0).transform;
}

void ExpectNear(const R3::Point& got, const R3::Point& wanted) {
  EXPECT_NEAR(got.x, wanted.x, 1e-15);
  EXPECT_NEAR(got.y, wanted.y, 1e-15);
  EXPECT_NEAR(got.z, wanted.z, 1e-15);
}

TEST(Placing, EachWordIsAMatrixAndQuarterTurnsAreExact) {
  EXPECT_EQ(Placed("translate 1 -2 .5"), Placed("1 0 0 1  0 1 0 -2  0 0 1 .5  0 0 0 1"));
  EXPECT_EQ(Placed("scale 2"), Placed("2 0 0 0  0 2 0 0  0 0 2 0  0 0 0 1"));
  EXPECT_EQ(Placed("scale 2 3 4"), Placed("2 0 0 0  0 3 0 0  0 0 4 0  0 0 0 1"));
  EXPECT_EQ(Placed("rotate 90 0 0 3"), Placed("0 -1 0 0  1 0 0 0  0 0 1 0  0 0 0 1"));
  EXPECT_EQ(Placed("rotate -90 1 0 0"), Placed("1 0 0 0  0 0 1 0  0 -1 0 0  0 0 0 1"));
  EXPECT_EQ(Placed("rotate 540 0 1 0"), Placed("-1 0 0 0  0 1 0 0  0 0 -1 0  0 0 0 1"));
}

// A third of a turn about the diagonal of a cube permutes its axes.
TEST(Placing, TheAxisOfARotationMayBeAny) {
  const R3::Matrix third = Placed("rotate 120 5 5 5");
  ExpectNear(third * R3::Point{1, 0, 0}, {0, 1, 0});
  ExpectNear(third * R3::Point{0, 1, 0}, {0, 0, 1});
  ExpectNear(third * R3::Point{1, 2, 3}, {3, 1, 2});
}

TEST(Placing, WordsInARowAreGroupsWithinGroups) {
  // Doubled, then turned from x to -z, then lifted.
  const R3::Matrix all = Placed("translate 0 1 0\n rotate 90 0 1 0\n scale 2");
  EXPECT_EQ(all * (R3::Point{1, 0, 0}), (R3::Point{0, 1, -2}));
  const Scene nested =
      ParseText("begin -1 translate 0 1 0 begin -1 rotate 90 0 1 0 begin -1 scale 2 end end end").scene;
  const Node& outer = nested.root.children.at(0);
  const Node& middle = outer.children.at(0);
  EXPECT_EQ(outer.transform * (middle.transform * (middle.children.at(0).transform * R3::Point{1, 0, 0})),
            (R3::Point{0, 1, -2}));
}

// Any number of words may place a group, including none.
TEST(Placing, AGroupWithoutWordsStandsWhereItsParentDoes) {
  EXPECT_EQ(Placed(""), R3::Matrix());
  for (const char* scene : {"begin -1 end", "begin -1\nend", "begin -1\n# a comment\n\nmotion 1 0 0 end",
                            "begin -1 begin -1 sphere -1 0 0 0 1 end end"})
    EXPECT_EQ(ParseText(scene).scene.root.children.at(0).transform, R3::Matrix()) << scene;
}

TEST(Placing, LookAtTurnsTheZAxisToItsTarget) {
  const R3::Matrix frame = Placed("look_at 1 2 3  1 2 13  0 1 0");
  EXPECT_EQ(frame, Placed("1 0 0 1  0 1 0 2  0 0 1 3  0 0 0 1"));
  const R3::Matrix slanted = Placed("look_at 0 0 0  1 1 0  0 9 0");
  const double h = std::numbers::sqrt2 / 2;
  ExpectNear(slanted * R3::Point{0, 0, 1}, {h, h, 0});
  ExpectNear(slanted * R3::Point{0, 1, 0}, {-h, h, 0});
  ExpectNear(slanted * R3::Point{1, 0, 0}, {0, 0, -1});
}

TEST(Placing, LookAtTakesATargetAndFullAngleInDegrees) {
  const Camera words = ParseText("camera look_at 1 2 3  1 2 -4  0 1 0  60").scene.camera;
  const Camera numbers =
      ParseText("camera 1 2 3  0 0 -7  0 1 0  " + std::to_string(std::numbers::pi / 6) + " .01 100").scene.camera;
  EXPECT_EQ(words.eye, numbers.eye);
  EXPECT_EQ(words.towards, numbers.towards);
  EXPECT_EQ(words.up, numbers.up);
  EXPECT_DOUBLE_EQ(words.xfov, std::numbers::pi / 6);
}

}  // namespace
}  // namespace ray
