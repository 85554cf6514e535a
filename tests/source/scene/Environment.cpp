#include "source/scene/Environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "R1/Elementary.h"
#include "R3/Warp.h"
#include "source/sample/Random.h"
#include "tests/ChiSquare.h"
#include "tests/Folder.h"
#include "tests/R2/Filled.h"

namespace {

using R2::Filled;
using ray::Environment;
using ray::EnvironmentLayout;
using ray::LightSamples;
constexpr double pi = std::numbers::pi;
constexpr double last = 1 - 0x1p-53;

R2::Point Random(std::uint64_t i) {
  const ray::RandomKey key = ray::RandomKey(11).Child(i);
  return {key.Child(0).Number(), key.Child(1).Number()};
}

R2::Image RandomImage(int width, int height) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const ray::RandomKey key = ray::RandomKey(5).Child(static_cast<std::uint64_t>(y * width + x));
      const auto channel = [&](std::uint64_t i) { return std::pow(key.Child(i).Number(), 4); };
      if ((x + y) % 7 != 0) image.Set(x, y, {channel(0), channel(1), channel(2)});  // and some texels black
    }
  return image;
}

// Returns the direction of a point in a latitude-longitude map, in shares of its width and height: the layout as
// documented.
R3::Vector Direction(double u, double v) {
  const double longitude = 2 * pi * (u - 0.5), latitude = pi * (v - 0.5);
  return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), -std::cos(latitude) * std::cos(longitude)};
}

const R2::Color right{1, 0, 0}, left{0, 1, 1}, up{0, 1, 0}, down{1, 0, 1}, back{0, 0, 1}, ahead{1, 1, 0};

void ExpectTheSixColors(const Environment& environment) {
  for (const double length : {1.0, 1e-300, 1e300}) {
    EXPECT_EQ(environment.Radiance({length, 0, 0}), right);
    EXPECT_EQ(environment.Radiance({-length, 0, 0}), left);
    EXPECT_EQ(environment.Radiance({0, length, 0}), up);
    EXPECT_EQ(environment.Radiance({0, -length, 0}), down);
    EXPECT_EQ(environment.Radiance({0, 0, length}), back);
    EXPECT_EQ(environment.Radiance({0, 0, -length}), ahead);
    EXPECT_EQ(environment.Radiance({-0.0, -0.0, length}), back);
  }
}

// Fills a rectangle of pixels, in shares of the image, with a color that stands for a name.
void Fill(R2::Image& image, double x0, double y0, double x1, double y1, const R2::Color& color) {
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const double px = (x + 0.5) / image.Width(), py = (y + 0.5) / image.Height();
      if (px > x0 && px < x1 && py > y0 && py < y1) image.Set(x, y, color);
    }
}

TEST(Environment, LatitudeAndLongitudeAreWhereDocumented) {
  R2::Image image(16, 8);
  Fill(image, 0, 0, 1, 1, back);
  Fill(image, 0.125, 0, 0.375, 1, left);
  Fill(image, 0.375, 0, 0.625, 1, ahead);
  Fill(image, 0.625, 0, 0.875, 1, right);
  Fill(image, 0, 0, 1, 0.25, down);
  Fill(image, 0, 0.75, 1, 1, up);
  const Environment environment(image);
  EXPECT_EQ(environment.Layout(), EnvironmentLayout::latitude_longitude);
  ExpectTheSixColors(environment);
}

TEST(Environment, LatitudeLongitudeTexelsAreFoundInTheirDirections) {
  const R2::Image image = RandomImage(32, 16);
  const Environment environment(image);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x)
      for (const double shift : {0.01, 0.5, 0.99})
        EXPECT_EQ(environment.Radiance(Direction((x + shift) / 32, (y + shift) / 16)), image.At(x, y)) << x << " " << y;
}

// Most texels are found by an approximate arctangent, the others by an exact one.
TEST(Environment, TheTexelIsThatOfExactArctangentsForAnyDirection) {
  constexpr int height = 512;
  R2::Image map(2 * height, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x) map.Set(x, y, {static_cast<double>(x), static_cast<double>(y), 0});
  const Environment environment(map);
  const auto expect = [&](const R3::Vector& given) {
    const R3::Vector d = R3::Unit(given);
    const double u = R1::Atan2(d.x, -d.z) / (2 * pi) + 0.5,
                 v = R1::Atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z)) / pi + 0.5;
    const R2::Color texel = environment.Radiance(given);
    EXPECT_EQ(texel.r, std::min(2 * height - 1, static_cast<int>(u * 2 * height))) << given.x << ' ' << given.y;
    EXPECT_EQ(texel.g, std::min(height - 1, static_cast<int>(v * height))) << given.x << ' ' << given.y;
  };
  const ray::RandomKey key(8);
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const auto random = [&](std::uint64_t k) { return key.Child(i).Child(k).Number(); };
    R3::Vector d{2 * random(0) - 1, 2 * random(1) - 1, 2 * random(2) - 1};
    if (i % 3 == 1) {  // within about 1e-8 of an edge between columns
      const double angle = 2 * pi * (std::floor(random(3) * 2 * height) / (2 * height) - 0.5) + 2e-8 * d.y;
      d.x = std::sin(angle), d.z = -std::cos(angle);
    }
    expect(i % 3 == 2 ? std::exp2(600 * d.z) * d : d);
  }
}

TEST(Environment, AProbeIsWhereDocumented) {
  // Half of the way to the rim is at a right angle to -z.
  R2::Image image(200, 200);
  Fill(image, 0, 0, 1, 1, back);
  Fill(image, 0.15, 0.3, 0.35, 0.7, left);
  Fill(image, 0.65, 0.3, 0.85, 0.7, right);
  Fill(image, 0.3, 0.65, 0.7, 0.85, up);
  Fill(image, 0.3, 0.15, 0.7, 0.35, down);
  Fill(image, 0.35, 0.35, 0.65, 0.65, ahead);
  const Environment environment(image);
  EXPECT_EQ(environment.Layout(), EnvironmentLayout::angular_probe);
  ExpectTheSixColors(environment);
}

TEST(Environment, AnglesInAProbeGrowEvenlyFromTheMiddle) {
  // A ramp of r over the share of the angle from -z: the map must reproduce it within its texel and the probe's pixel.
  R2::Image image(400, 400);
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 400; ++x) image.Set(x, y, {std::hypot((x + 0.5) / 200 - 1, (y + 0.5) / 200 - 1), 1, 1});
  const Environment environment(image);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const R3::Vector d = R3::SampleUniformSphere(Random(i));
    EXPECT_NEAR(environment.Radiance(d).r, std::acos(-d.z) / pi, 1.5 / 200);
  }
}

TEST(Environment, CrossesAreWhereDocumented) {
  R2::Image upright(12, 16);
  Fill(upright, 0, 0.5, 1.0 / 3, 0.75, left);
  Fill(upright, 1.0 / 3, 0.5, 2.0 / 3, 0.75, ahead);
  Fill(upright, 2.0 / 3, 0.5, 1, 0.75, right);
  Fill(upright, 1.0 / 3, 0.75, 2.0 / 3, 1, up);
  Fill(upright, 1.0 / 3, 0.25, 2.0 / 3, 0.5, down);
  Fill(upright, 1.0 / 3, 0, 2.0 / 3, 0.25, back);
  R2::Image lying(16, 12);
  Fill(lying, 0, 1.0 / 3, 0.25, 2.0 / 3, left);
  Fill(lying, 0.25, 1.0 / 3, 0.5, 2.0 / 3, ahead);
  Fill(lying, 0.5, 1.0 / 3, 0.75, 2.0 / 3, right);
  Fill(lying, 0.75, 1.0 / 3, 1, 2.0 / 3, back);
  Fill(lying, 0.25, 2.0 / 3, 0.5, 1, up);
  Fill(lying, 0.25, 0, 0.5, 1.0 / 3, down);
  for (const R2::Image& image : {upright, lying}) {
    const Environment environment(image);
    EXPECT_EQ(environment.Layout(), EnvironmentLayout::cross);
    ExpectTheSixColors(environment);
    EXPECT_EQ(environment.Radiance({0.7, 0.7, -1}), ahead);
    EXPECT_EQ(environment.Radiance({1, -0.7, 0.7}), right);
    EXPECT_EQ(environment.Radiance({-1, 0.7, 0.7}), left);
  }
}

// Returns the color that a cross must show in a direction so that nothing jumps where faces meet: the direction itself.
R2::Image DirectionsOnACross(bool is_upright, int size) {
  R2::Image image = is_upright ? R2::Image(3 * size, 4 * size) : R2::Image(4 * size, 3 * size);
  const int bottom = is_upright ? 1 : 0;
  const auto paint = [&](int column, int row, const auto& direction) {
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const R3::Vector d = Unit(direction(2 * (x + 0.5) / size - 1, 2 * (y + 0.5) / size - 1));
        image.Set(column * size + x, row * size + y, {1 + d.x, 1 + d.y, 1 + d.z});
      }
  };
  // Unfolded from -z ahead: each face is rotated about the edge that it shares with its neighbor.
  paint(1, bottom + 1, [](double s, double t) { return R3::Vector{s, t, -1}; });
  paint(2, bottom + 1, [](double s, double t) { return R3::Vector{1, t, s}; });
  paint(0, bottom + 1, [](double s, double t) { return R3::Vector{-1, t, -s}; });
  paint(1, bottom + 2, [](double s, double t) { return R3::Vector{s, 1, t}; });
  paint(1, bottom, [](double s, double t) { return R3::Vector{s, -1, -t}; });
  if (is_upright)
    paint(1, 0, [](double s, double t) { return R3::Vector{s, -t, 1}; });
  else
    paint(3, bottom + 1, [](double s, double t) { return R3::Vector{-s, t, 1}; });
  return image;
}

TEST(Environment, FacesOfACrossMeetAtTheirEdges) {
  for (const bool is_upright : {true, false}) {
    const Environment environment(DirectionsOnACross(is_upright, 128));
    for (std::uint64_t i = 0; i < 10'000; ++i) {
      const R3::Vector d = R3::SampleUniformSphere(Random(i));
      const R2::Color c = environment.Radiance(d);
      // Off by half a pixel of the face and half a texel of the map.
      ASSERT_NEAR(Length(R3::Vector{c.r - 1, c.g - 1, c.b - 1} - d), 0, 0.02) << d.x << " " << d.y << " " << d.z;
    }
  }
}

TEST(Environment, DrawsDirectionsByTheirDensity) {
  constexpr int columns = 16, rows = 8, parts = 2;  // cells are quarters of texels, of equal solid angle
  const Environment environment(RandomImage(columns, rows));
  std::vector<double> counts(columns * rows * parts * parts), shares(counts.size());
  const auto sine = [&](double row) { return -std::cos(pi * row / rows); };
  double all = 0;
  for (int y = 0; y < rows; ++y)
    for (int part = 0; part < parts; ++part) {
      const double height = (sine(y + 1) - sine(y)) / parts, middle = sine(y) + (part + 0.5) * height;
      for (int x = 0; x < columns * parts; ++x) {
        const double share =
            environment.SeenTowards(Direction((x + 0.5) / (columns * parts), std::asin(middle) / pi + 0.5)).pdf *
            height * 2 * pi / (columns * parts);
        shares[static_cast<std::size_t>((y * parts + part) * columns * parts + x)] = share;
        all += share;
      }
    }
  EXPECT_NEAR(all, 1, 1e-12);
  for (std::uint64_t i = 0; i < 1'000'000; ++i) {
    const R3::Vector d = environment.Draw(Random(i)).direction;
    const int x =
        std::min(static_cast<int>((std::atan2(d.x, -d.z) / (2 * pi) + 0.5) * columns * parts), columns * parts - 1);
    const int y = std::min(static_cast<int>((std::asin(d.y) / pi + 0.5) * rows), rows - 1);
    const int part = std::min(static_cast<int>((d.y - sine(y)) / (sine(y + 1) - sine(y)) * parts), parts - 1);
    ++counts[static_cast<std::size_t>((y * parts + part) * columns * parts + x)];
  }
  EXPECT_LT(chi_square::OverQuantile(counts, shares, 0.01), 1);
}

TEST(Environment, TheDensityIsLuminanceOverItsIntegralInEveryLayout) {
  for (const R2::Image& image :
       {RandomImage(32, 16), RandomImage(40, 40), RandomImage(9, 12), RandomImage(12, 9), RandomImage(2, 1)}) {
    const Environment environment(image);
    // Both integrals by the midpoint rule on the finest of these maps, 256 x 128, or a multiple of its texels.
    double pdf = 0, luminance = 0;
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 256; ++x) {
        const R3::Vector d = Direction((x + 0.5) / 256, (y + 0.5) / 128);
        const double solid_angle = 2 * pi / 256 * (std::cos(pi * y / 128) - std::cos(pi * (y + 1) / 128));
        pdf += solid_angle * environment.SeenTowards(d).pdf;
        luminance += solid_angle * Luminance(environment.Radiance(d));
      }
    EXPECT_NEAR(pdf, 1, 1e-9);
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const R3::Vector d = R3::SampleUniformSphere(Random(i));
      EXPECT_NEAR(environment.SeenTowards(d).pdf, Luminance(environment.Radiance(d)) / luminance, 1e-12);
    }
  }
}

TEST(Environment, ADrawnDirectionHasTheRadianceThatArrivesFromIt) {
  for (const R2::Image& image : {RandomImage(64, 32), RandomImage(40, 40), RandomImage(30, 40)}) {
    const Environment environment(image);
    const auto expect_agreement = [&](const R2::Point& u) {
      const Environment::Sample sample = environment.Draw(u);
      ASSERT_NEAR(Length(sample.direction), 1, 1e-14);
      ASSERT_EQ(environment.Radiance(sample.direction), sample.radiance) << u.x << " " << u.y;
      ASSERT_EQ(environment.SeenTowards(sample.direction).pdf, sample.pdf) << u.x << " " << u.y;
      ASSERT_GT(sample.pdf, 0);
      ASSERT_GT(Luminance(sample.radiance), 0);
    };
    for (std::uint64_t i = 0; i < 100'000; ++i) expect_agreement(Random(i));
    for (const double x : {0.0, 0.25, 0.5, last, 1.0})
      for (const double y : {0.0, 0.25, 0.5, last, 1.0}) expect_agreement({x, y});
  }
}

TEST(Environment, BatchedDrawsEqualSingleOnesBitForBit) {
  for (const R2::Image& image : {RandomImage(64, 32), RandomImage(2, 1), RandomImage(40, 40), R2::Image(8, 4)}) {
    const Environment environment(image);
    LightSamples samples;
    LightSamples::Each pdfs;
    const double edges[] = {0, 0x1p-30, 0.25, 0.5, last, 1};
    for (std::uint64_t round = 0; round < 1000; ++round) {
      samples.count = 1 + round % LightSamples::most;
      for (std::uint32_t i = 0; i < samples.count; ++i) {
        R2::Point u = Random(round * LightSamples::most + i);
        if (round == 35) u = {edges[i % 6], edges[i / 6]};
        samples.random.Set(i, u);
      }
      environment.DrawEach(samples, pdfs);
      for (std::uint32_t i = 0; i < samples.count; ++i) {
        const Environment::Sample alone = environment.Draw(samples.random[i]);
        ASSERT_EQ(samples.to_light[i], alone.direction);
        ASSERT_EQ(samples.color[i], alone.radiance / alone.pdf);
        ASSERT_EQ(pdfs[i], alone.pdf);
      }
    }
  }
}

TEST(Environment, BatchedLookupsEqualSingleOnesBitForBit) {
  const Environment environment(RandomImage(512, 256));
  std::vector<R3::Vector> directions;
  for (std::uint64_t i = 0; i < 20'000; ++i)
    directions.push_back(std::ldexp(1, static_cast<int>(i % 400) - 200) * R3::SampleUniformSphere(Random(i)));
  const double ends[] = {0, -0.0, 1, -1, 1e-300, -1e300, 0x1p-1074, 1 + 0x1p-52};  // seams, poles, out of range
  for (const double x : ends)
    for (const double y : ends)
      for (const double z : ends) directions.push_back({x, y, z});
  LightSamples seen;
  LightSamples::Each pdfs;
  for (std::size_t first = 0; first < directions.size(); first += seen.count) {
    seen.count = static_cast<std::uint32_t>(std::min<std::size_t>(LightSamples::most, directions.size() - first));
    for (std::uint32_t i = 0; i < seen.count; ++i) seen.Set(i, directions[first + i], {});
    environment.SeeEach(seen, pdfs);
    for (std::uint32_t i = 0; i < seen.count; ++i) {
      const R3::Vector& d = directions[first + i];
      const Environment::Seen alone = environment.SeenTowards(d);
      ASSERT_EQ(seen.color[i], alone.radiance) << d.x << " " << d.y << " " << d.z;
      ASSERT_EQ(pdfs[i], alone.pdf);
    }
  }
}

TEST(Environment, AnEvenMapIsIntegratedWithoutAnyError) {
  const R2::Color color{0.5, 2, 0.25};
  for (const R2::Image& image : {Filled(64, 32, color), Filled(50, 50, color), Filled(30, 40, color)}) {
    const Environment environment(image);
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const Environment::Sample sample = environment.Draw(Random(i));
      EXPECT_NEAR(sample.radiance.g / sample.pdf, 4 * pi * 2, 1e-10);
    }
  }
}

TEST(Environment, AverageOverDrawsIsTheIntegralOfEachChannel) {
  // Light from above on a level plane has a closed form: a sum over texels of the mean of y, half the difference of
  // squares of sines.
  const R2::Image image = RandomImage(32, 16);
  const Environment environment(image);
  R2::Color truth, sum, squares;
  for (int y = 8; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      const double low = -std::cos(pi * y / 16), high = -std::cos(pi * (y + 1) / 16);
      truth += 2 * pi / 32 * (high * high - low * low) / 2 * image.At(x, y);
    }
  constexpr int count = 200'000;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Environment::Sample sample = environment.Draw(Random(i));
    const R2::Color estimate = std::max(0.0, sample.direction.y) / sample.pdf * sample.radiance;
    sum += estimate, squares += estimate * estimate;
  }
  for (const auto channel : {&R2::Color::r, &R2::Color::g, &R2::Color::b}) {
    const double mean = sum.*channel / count;
    const double error = std::sqrt((squares.*channel / count - mean * mean) / count);
    EXPECT_NEAR(mean, truth.*channel, 4 * error);
  }
}

TEST(Environment, ASmallSunIsHitByNearlyAllDraws) {
  R2::Image image = Filled(256, 128, {0.01, 0.01, 0.01});
  for (const int y : {100, 101})
    for (const int x : {40, 41}) image.Set(x, y, {1e6, 9e5, 8e5});
  const Environment environment(image);
  int hits = 0;
  for (std::uint64_t i = 0; i < 10'000; ++i) hits += environment.Draw(Random(i)).radiance.r > 1;
  EXPECT_GT(hits, 9990);
}

TEST(Environment, ABlackOneIsDrawnEvenlyAndReportsIt) {
  for (const R2::Image& image : {R2::Image(8, 4), R2::Image(4, 4)}) {
    const Environment environment(image);
    EXPECT_TRUE(environment.IsBlack());
    for (std::uint64_t i = 0; i < 100; ++i) EXPECT_NEAR(environment.Draw(Random(i)).pdf, R3::uniform_sphere_pdf, 1e-12);
  }
  EXPECT_FALSE(Environment(RandomImage(8, 4)).IsBlack());
}

TEST(Environment, HugeAndTinyValuesNeitherOverflowNorVanish) {
  constexpr double huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
  for (const double value : {huge, tiny})
    for (const R2::Image& image : {Filled(64, 32, {value, value, value}), Filled(9, 12, {value, value, value})}) {
      const Environment environment(image);
      const Environment::Sample sample = environment.Draw({0.3, 0.6});
      EXPECT_EQ(sample.radiance.g, value);
      EXPECT_NEAR(sample.pdf, R3::uniform_sphere_pdf, 1e-12);
    }
}

TEST(Environment, ASingleBrightPixelAlwaysReachesTheMap) {
  const auto expect_kept = [](int width, int height, int x, int y) {
    R2::Image image(width, height);
    image.Set(x, y, {1, 1, 1});
    EXPECT_FALSE(Environment(image).IsBlack()) << width << " x " << height << ": " << x << " " << y;
  };
  for (std::uint64_t i = 0; i < 40; ++i) {
    const R2::Point u = Random(i), on_disc = R3::SampleUniformDiskConcentric(u);
    expect_kept(128, 128, static_cast<int>(64 + 0.8 * 64 * on_disc.x), static_cast<int>(64 + 0.8 * 64 * on_disc.y));
    const int x = static_cast<int>(64 * u.x), y = static_cast<int>(64 * u.y), face = static_cast<int>(i % 4);
    expect_kept(192, 256, 64 + x, 64 * face + y);
    expect_kept(256, 192, 64 * face + x, 64 + y);
  }
}

std::string ErrorOf(const R2::Image& image) {
  return project::MessageOf<std::invalid_argument>([&] { const Environment environment(image); });
}

TEST(Environment, OtherShapesAreRefusedWithTheSupportedOnes) {
  EXPECT_EQ(
      ErrorOf(R2::Image(5, 7)),
      "an environment map must be 2:1 (latitude-longitude), 1:1 (angular probe), or 3:4 or 4:3 (cross of six cube "
      "faces), got 5 x 7");
  EXPECT_NE(ErrorOf(R2::Image()), "");
}

TEST(Environment, InvalidLightValuesAreRefusedWithTheirPixel) {
  R2::Image image = Filled(8, 4, {1, 1, 1});
  image.Set(6, 1, {0.5, -2, 0});
  EXPECT_EQ(ErrorOf(image),
            "radiance must be finite and not negative, but pixel 6 1 (from the left, from the bottom) is 0.5 -2 0");
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    R2::Image other = Filled(6, 8, {1, 1, 1});
    other.Set(0, 0, {1, 1, bad});  // also where a cross has no face
    EXPECT_NE(ErrorOf(other), "");
  }
}

}  // namespace
