// The images made so far can be looked at again, and each is the reference for the next.

#include "source/view/commands/Commands.h"
#include "source/view/compare/ImageStrip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/source/view/ScriptedViewer.h"

namespace ray {
namespace {

TEST(ImageStrip, ForgetsTheOldestAndKeepsNumbers) {
  ImageStrip strip;
  for (std::size_t i = 0; i < ImageStrip::most + 3; ++i) strip.Add({nullptr, std::to_string(i), "", "", 0, 1});
  EXPECT_EQ(strip.All().size(), ImageStrip::most);
  EXPECT_EQ(strip.All().front().scene, "3");
  EXPECT_EQ(strip.NumberOf(0), 4u);
}

TEST_F(ViewerTest, FlipsThroughTheImagesMadeSoFar) {
  Do("key Control+PageUp");
  EXPECT_NE(viewer_->Message().find("no image"), std::string::npos);
  Do("key S\nwait trace\nkey [\nkey S\nwait trace");
  ASSERT_EQ(viewer_->state().images.All().size(), 2u);
  Do("key Control+PageUp\nkey Control+PageUp");
  EXPECT_EQ(ShownImage(viewer_->state()), 0u);
  EXPECT_EQ(*viewer_->Traced().Compared(), host_.traced[0]);
  Do("key Control+PageDown");
  EXPECT_EQ(*viewer_->Traced().Compared(), host_.traced[1]);
  Do("key Control+PageDown");
  EXPECT_FALSE(ShownImage(viewer_->state()));
  EXPECT_FALSE(viewer_->Traced().Compared());
}

TEST_F(ViewerTest, ChangesExposureInQuartersOfAStop) {
  Do("key Control+Up\nkey Control+Shift+Down");
  EXPECT_EQ(viewer_->state().exposure_steps, 0.75);
  EXPECT_EQ(viewer_->Message(), "exposure 0.75 stops");
  SetExposure(viewer_->state(), -1.3);
  EXPECT_DOUBLE_EQ(viewer_->Show().seen_from.exposure.factor, std::exp2(-1.3));
}

}  // namespace
}  // namespace ray
