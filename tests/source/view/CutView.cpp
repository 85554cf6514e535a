#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "source/view/Viewer.h"
#include "tests/source/view/ScriptedViewer.h"

namespace ray {
namespace {

// The scene is drawn in half of the width then, and clicks were taken as if it had all of it.
TEST_F(ViewerTest, TheMessageOfAnotherPlaneSaysWhereItCutsNow) {
  viewer_->Show();
  for (const char* keys : {"key X\nkey Shift+X", "key Shift+X", "key Shift+X"}) {
    Do(keys);
    viewer_->Show();
    EXPECT_EQ(viewer_->Message(), "cross section: " + StateLine("cut"));
  }
}

TEST_F(ViewerTest, BesideTheCutAClickMeansWhatIsSeenThere) {
  Do("click left 20 30");
  ASSERT_TRUE(viewer_->Picked() && viewer_->Picked()->point);
  const R3::Point without = *viewer_->Picked()->point;
  Do("key X\nclick left 10 27");
  ASSERT_TRUE(viewer_->Picked() && viewer_->Picked()->point);
  EXPECT_LT(Length(*viewer_->Picked()->point - without), 0.2) << "the middle of a pixel twice as wide";
  Do("click right 10 27");
  EXPECT_EQ(StateLine("pixel"), "10 27");
  Do("tick 1\nclick left 10 27\nclick left 10 27");
  ASSERT_TRUE(viewer_->navigator().Pivot());
  const auto seen = PixelOf(camera(), *viewer_->navigator().Pivot(), {width / 2, height});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x, 10, 1e-6);
  EXPECT_NEAR(seen->y, 27, 1e-6);
}

TEST_F(ViewerTest, OverTheCutThePointerTellsDistancesAlongThePlane) {
  Do("resize 640 480\nkey X\nkey Shift+X");
  viewer_->Show();
  const auto numbers = [&] {
    std::vector<double> all;
    std::istringstream words(StateLine("under the pointer"));
    for (std::string word; words >> word;)
      if (char* end = nullptr; std::strtod(word.c_str(), &end) != 0 && end != word.c_str())
        all.push_back(std::stod(word));
    return all;
  };
  Do("move 100 240");
  EXPECT_TRUE(numbers().empty()) << "not over the cut";
  const Camera before = camera();
  Do("down left 400 100\nmove 500 300");
  const auto told = numbers();  // x, z, distance from the origin, distance from the press
  ASSERT_EQ(told.size(), 4u) << StateLine("under the pointer");
  EXPECT_NEAR(told[2], std::hypot(told[0], told[1]), 1e-3);
  Do("move 400 100");
  const auto first = numbers();
  EXPECT_NEAR(told[3], std::hypot(told[0] - first[0], told[1] - first[1]), 1e-2);
  Do("up left 400 100");
  EXPECT_TRUE(IsCameraOf(before)) << "the scene is not dragged from there";
  EXPECT_EQ(numbers().size(), 3u);
}

TEST_F(ViewerTest, TheWheelOverTheCutMovesItsPlane) {
  Do("key X\nscroll 1 50 20");
  EXPECT_EQ(StateLine("cut"), "row 25");
  Do("scroll -2 50 20");
  EXPECT_EQ(StateLine("cut"), "row 24");
}

}  // namespace
}  // namespace ray
