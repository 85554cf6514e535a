#include "source/draw/Frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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

TEST(Frame, CopiesRowsFromTheBottomBehindWhatIsThere) {
  Frame frame(2, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 2; ++x) frame.Set(x, y, {10.0 * y + x, 0.5, 0.25});
  std::vector<float> rgb{7};
  frame.Copy(1, 2, rgb);
  EXPECT_EQ(rgb, (std::vector<float>{7, 10, 0.5, 0.25, 11, 0.5, 0.25, 20, 0.5, 0.25, 21, 0.5, 0.25}));
  EXPECT_EQ(frame.At(1, 2), (R2::Color{21, 0.5, 0.25}));
}

TEST(Frame, HoldsWhatNoFloatHoldsAsTheFilmDoes) {
  Frame frame(1, 1);
  frame.Set(0, 0, {std::nan(""), 1e300, -std::numeric_limits<double>::infinity()});
  constexpr double largest = std::numeric_limits<float>::max();
  EXPECT_EQ(frame.At(0, 0), (R2::Color{0, largest, -largest}));
}

// Else the viewer would take a row for new and draw it without its last pixels, until something else touched it.
TEST(Frame, WhoSeesAVersionSeesWhatWasSetBeforeIt) {
  constexpr int width = 16, times = 20'000;
  Frame frame(width, 1);
  std::thread writer([&] {
    for (int i = 1; i <= times; ++i) {
      for (int x = 0; x < width; ++x) frame.Set(x, 0, {1.0 * i, 1.0 * i, 1.0 * i});
      frame.Touch(0);
    }
  });
  int behind = 0;
  for (std::uint32_t seen = 0; seen < times;) {
    seen = frame.Version(0);
    for (int x = 0; x < width; ++x) behind += frame.At(x, 0).b < seen;
  }
  writer.join();
  EXPECT_EQ(behind, 0);
}

}  // namespace
}  // namespace ray
