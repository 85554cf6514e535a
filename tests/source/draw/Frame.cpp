#include "source/draw/Frame.h"

#include <gtest/gtest.h>

#include <thread>

namespace ray {
namespace {

TEST(Frame, IsBlackAndUntouchedAtFirst) {
  const Frame frame(3, 2);
  std::vector<float> rgb;
  frame.Copy(0, 2, rgb);
  EXPECT_EQ(rgb, std::vector<float>(18, 0.0f));
  EXPECT_EQ(frame.Version(0), 0u);
  EXPECT_EQ(frame.Version(1), 0u);
}

TEST(Frame, AppendsRowsFromTheBottom) {
  Frame frame(2, 3);
  R2::Image rows(2, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) rows.Set(x, y, {10.0 * (y + 1) + x, 0.5, 0.25});
  frame.Put(rows, 1);
  std::vector<float> rgb{7};
  frame.Copy(1, 2, rgb);
  EXPECT_EQ(rgb, (std::vector<float>{7, 10, 0.5, 0.25, 11, 0.5, 0.25, 20, 0.5, 0.25, 21, 0.5, 0.25}));
  EXPECT_EQ(frame.At(1, 2), (R2::Color{21, 0.5, 0.25}));
  EXPECT_EQ(frame.Image().At(1, 0), R2::Color());
  EXPECT_EQ(frame.Version(0), 0u);
  EXPECT_EQ(frame.Version(2), 1u);
}

// Otherwise the viewer would take a row as new and draw it without its last pixels, until something else changed it.
TEST(Frame, AVersionIsVisibleAfterItsPixels) {
  constexpr int width = 16, times = 20'000;
  Frame frame(width, 1);
  std::thread writer([&] {
    R2::Image row(width, 1);
    for (int i = 1; i <= times; ++i) {
      for (int x = 0; x < width; ++x) row.Set(x, 0, {1.0 * i, 0, 0});
      frame.Put(row, 0);
    }
  });
  int behind = 0;
  for (std::uint32_t seen = 0; seen < times;) {
    seen = frame.Version(0);
    for (int x = 0; x < width; ++x) behind += frame.At(x, 0).r < seen;
  }
  writer.join();
  EXPECT_EQ(behind, 0);
}

}  // namespace
}  // namespace ray
