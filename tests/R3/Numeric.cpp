#include "R3/Numeric.h"

#include <gtest/gtest.h>

#include "R1/DoubleDouble.h"
#include "R3/Numeric.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

TEST(DifferenceOfProducts, IsWithinOneAndAHalfUlpsDespiteCancellation) {
  Draw draw(901);
  for (int i = 0; i < 200'000; ++i) {
    const double a = draw.Between(-1, 1), b = draw.Between(-1, 1), c = a * (1 + draw.Whole(-2, 2) * 0x1p-52);
    const double d = b * (1 + draw.Whole(-2, 2) * 0x1p-52);
    const Quad truth = Quad(a) * Quad(b) - Quad(c) * Quad(d);
    const double got = R3::DifferenceOfProducts(a, b, c, d);
    EXPECT_LE(oracle::Double(oracle::Abs(Quad(got) - truth)),
              3 * R3::unit_roundoff * oracle::Double(oracle::Abs(truth)));
    EXPECT_EQ(got > 0, truth > 0);
    EXPECT_EQ(got < 0, truth < 0);
  }
}

TEST(NextUpAndNextDown, AgreeWithTheLibrary) {
  for (const double x : {0.0, -0.0, 1.0, -1.0, 0x1p-1074, -0x1p-1074, 1e300, -1e300, 0x1p-1022, 0.1}) {
    EXPECT_EQ(R3::NextUp(x), std::nextafter(x, R3::infinity));
    EXPECT_EQ(R3::NextDown(x), std::nextafter(x, -R3::infinity));
  }
  EXPECT_EQ(R3::NextUp(R3::infinity), R3::infinity);
  EXPECT_TRUE(std::isnan(R3::NextUp(std::nan(""))));
}

TEST(DoubleDouble, SumsProductsAndQuotientsCarryAHundredBits) {
  Draw draw(902);
  const auto quad = [](const R3::DoubleDouble& w) { return Quad(w.high) + Quad(w.low); };
  const auto random = [&] {
    return R3::DoubleDouble(draw.Between(-1, 1)) + R3::DoubleDouble(draw.Between(-1, 1) * 0x1p-60);
  };
  for (int i = 0; i < 100'000; ++i) {
    const R3::DoubleDouble a = random(), b = random();
    const auto expect = [&](const R3::DoubleDouble& got, Quad truth, Quad magnitude) {
      EXPECT_LE(oracle::Double(oracle::Abs(quad(got) - truth) / magnitude), 0x1p-100);
    };
    expect(a + b, quad(a) + quad(b), oracle::Abs(quad(a)) + oracle::Abs(quad(b)));
    expect(a - b, quad(a) - quad(b), oracle::Abs(quad(a)) + oracle::Abs(quad(b)));
    expect(a * b, quad(a) * quad(b), oracle::Abs(quad(a) * quad(b)));
    expect(a / b, quad(a) / quad(b), oracle::Abs(quad(a) / quad(b)));
  }
}

TEST(Extremes, J5_NeighboringFloatsKeepTheRoundingOfTheirConversion) {
  struct Pair {
    float a, b;
  };
  volatile double x = 0.1, y = 0.7;
  const double in_x = x, in_y = y;
  const Pair p{static_cast<float>(in_x), static_cast<float>(in_y)};
  const double back[2] = {static_cast<double>(p.a), static_cast<double>(p.b)};
  EXPECT_EQ(back[0], 0x1.99999ap-4);
  EXPECT_EQ(back[1], 0x1.666666p-1);
}

TEST(Extremes, J6_ProductsAndSumsAreRoundedSeparatelyAndDenormalsKept) {
  volatile double a = 1 + 0x1p-30, b = 1 - 0x1p-30, c = -1;
  EXPECT_EQ(a * b + c, 0);  // fused, it would be -2^-60
  volatile double tiny = 0x1p-1060;
  EXPECT_NE(tiny / 4, 0);
  volatile double one = 1, ulp = 0x1p-53;
  EXPECT_EQ(one + ulp, 1);  // to nearest, ties to even
  EXPECT_EQ((one + 0x1p-52) + ulp, 1 + 0x1p-51);
  volatile double nan = std::nan("");
  EXPECT_NE(nan, nan);  // no -ffast-math
}

}  // namespace
