#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "source/text/NumberText.h"
#include "source/view/Viewer.h"
#include "tests/source/view/ScriptedViewer.h"

namespace ray {
namespace {

TEST_F(ViewerTest, TheRenderedImageIsShownFlatUntilEscape) {
  Do("key I");
  EXPECT_FALSE(viewer_->Show().covering) << "nothing is rendered yet";
  Do("key S\nwait trace\nkey I");
  FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.covering && shown.covering->frame);
  EXPECT_EQ(shown.covering->frame, &viewer_->Traced().Trace()->frame());
  EXPECT_EQ(shown.covering->place.width, width);
  EXPECT_EQ(shown.covering->place.height, height);
  EXPECT_EQ(shown.split, width) << "all of it";
  EXPECT_TRUE(shown.lines->empty());
  Do("key Control+Up");
  EXPECT_EQ(viewer_->Show().covering->exposure.factor, 2);
  Do("key Escape");
  EXPECT_FALSE(viewer_->Show().covering);
  EXPECT_EQ(viewer_->Show().split, -1);
}

TEST_F(ViewerTest, TheWheelZoomsAndADragMovesTheFlatImage) {
  Do("key S\nwait trace\nkey I\nmove 10.5 20.5");
  const Camera before = camera();
  const R2::Point pixel = viewer_->state().PointerInShownImage();
  Do("scroll 5 10.5 20.5");
  const PixelBox zoomed = viewer_->Show().covering->place;
  EXPECT_GT(zoomed.width, 2 * width);
  EXPECT_NEAR(viewer_->state().PointerInShownImage().x, pixel.x, 1e-9);
  EXPECT_NEAR(viewer_->state().PointerInShownImage().y, pixel.y, 1e-9);
  Do("down left 10.5 20.5\nmove 30.5 25.5\nup left 30.5 25.5");
  EXPECT_NEAR(viewer_->state().PointerInShownImage().x, pixel.x, 1e-9)
      << "what was taken hold of stays under the pointer";
  EXPECT_NEAR(viewer_->state().PointerInShownImage().y, pixel.y, 1e-9);
  Do("click right 30.5 25.5");
  EXPECT_EQ(StateLine("pixel"), "10 20");
  EXPECT_TRUE(IsCameraOf(before));
  Do("scroll 1000 30 20\nscroll -1000 30 20");
  EXPECT_NEAR(viewer_->Show().covering->place.width, 0.1 * width, 1e-9);
}

TEST_F(ViewerTest, TheSliderShowsPreviewOrReferenceBesideTheImage) {
  Do("key S\nwait trace\nkey I\ndown left 64 20\nmove 50 20\nmove 16 20\nup left 16 20");
  EXPECT_EQ(viewer_->Show().split, 16);
  EXPECT_FALSE(viewer_->Show().beside);
  Do("down left 40 20 Shift\nmove 48 20\nup left 48 20");
  EXPECT_EQ(viewer_->Show().split, 48);
  Do("key R");
  ASSERT_TRUE(viewer_->Show().beside);
  EXPECT_EQ(viewer_->Show().beside->image, viewer_->Traced().Reference());
  // The preview beside it is of the image's camera, wherever the viewer's own is by then.
  Do("key Escape");
  const auto eye = viewer_->Show().seen_from.eye;
  Do("key Pad7");
  EXPECT_NE(viewer_->Show().seen_from.eye, eye);
  Do("key I");
  EXPECT_EQ(viewer_->Show().seen_from.eye, eye);
}

TEST_F(ViewerTest, TheSidesOfTheSliderHaveNames) {
  const auto is_named = [&](const std::string& name) {
    const auto labels = viewer_->Show().labels;
    return std::ranges::count(labels, name, &Label::text) == 1;
  };
  Do("resize 400 300\nkey S\nwait trace\nkey I\ntick 10");
  EXPECT_FALSE(is_named("image")) << "there is one side";
  Do("drag left 399 100 200 100 Shift");
  EXPECT_TRUE(is_named("image") && is_named("preview"));
  Do("key R");
  EXPECT_TRUE(is_named("image") && is_named("reference"));
}

TEST_F(ViewerTest, LargePixelsShowTheirValues) {
  Do("resize 400 300\nkey S\nwait trace\nkey I\nscroll 10 200 150\ntick 10");
  EXPECT_TRUE(viewer_->Show().labels.empty()) << "they have no room";
  Do("scroll 10 200 150\ntick 10\nmove 200 150");
  const auto labels = viewer_->Show().labels;
  ASSERT_FALSE(labels.empty());
  const auto x = static_cast<int>(viewer_->state().PointerInShownImage().x),
             y = static_cast<int>(viewer_->state().PointerInShownImage().y);
  const R2::Color value = viewer_->Traced().Trace()->frame().At(x, y);
  // The three that are nearest to the middle of that pixel, from the top.
  const PixelBox place = viewer_->Show().covering->place;
  const double side = place.width / 400;
  std::string told;
  for (const Label& label : labels)
    if (std::floor((label.x + 4 - place.left) / side) == x && std::floor((label.y + 8 - place.bottom) / side) == y)
      told += label.text + " ";
  EXPECT_EQ(told, Fixed(value.r, 2) + " " + Fixed(value.g, 2) + " " + Fixed(value.b, 2) + " ");
}

}  // namespace
}  // namespace ray
