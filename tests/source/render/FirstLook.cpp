#include "source/render/FirstLook.h"

#include <gtest/gtest.h>


namespace ray {
namespace {

TEST(FirstLook, IsAsFineAsFitsItsTime) {
  constexpr std::int64_t pixels = 512 * 512;
  constexpr double seconds = 0.04;
  EXPECT_EQ(PlacesWithin(seconds, pixels, 0), 1);
  EXPECT_EQ(PlacesWithin(seconds, pixels, std::nan("")), 1);
  EXPECT_EQ(PlacesWithin(seconds, pixels, 1e9), BlockOrder::places);
  for (double rate = 3e3; rate < 1e8; rate *= 1.7) {
    const int places = PlacesWithin(seconds, pixels, rate);
    const auto takes = [&](int of) { return static_cast<double>(pixels) * of / BlockOrder::places / rate; };
    if (places > 1) {
      EXPECT_LE(takes(places), seconds) << rate;
    }
    if (places < BlockOrder::places) {
      EXPECT_GT(takes(4 * places), seconds) << rate;
    }
  }
}

}  // namespace
}  // namespace ray
