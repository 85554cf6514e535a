#include "source/draw/gl/Painter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "R2/ImageFile.h"
#include "tests/source/draw/gl/WithPainter.h"

namespace {

using ray::ClipMatrix;
using ray::Rgba;
using Look = ray::ImageLook;

constexpr ClipMatrix as_it_is{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
const ray::PreviewView from_front{{0, 0, -4}, {}, {}};
constexpr Rgba white{255, 255, 255, 255}, red{255, 0, 0, 255}, green{0, 255, 0, 255};

Rgba PixelOf(const R2::Image& image, int x, int y) {
  const R2::Color c = image.At(x, y);
  return {R2::ToByte(c.r), R2::ToByte(c.g), R2::ToByte(c.b), 255};
}

/// A material that emits a color, and transmits the rest of alpha.
ray::SurfaceMaterial Shining(const Rgba& color) {
  const double alpha = color[3] / 255.0;
  ray::SurfaceMaterial material;
  material.emission = alpha * R2::Color{color[0] / 255.0, color[1] / 255.0, color[2] / 255.0};
  material.kt = {1 - alpha, 1 - alpha, 1 - alpha};
  return material;
}

std::array<std::int16_t, 4> Packed(float x, float y, float z) {
  const auto channel = [](float c) { return static_cast<std::int16_t>(c * 32767); };
  return {channel(x), channel(y), channel(z), 0};
}

/// A rectangle over the whole view, at a depth in [-1, 1], -1 in front.
ray::PreviewScene Wall(float depth, const Rgba& color) {
  ray::PreviewScene wall;
  for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
    wall.surfaces.vertices.push_back({{x, y, depth}, Packed(0, 0, -1)});
  wall.surfaces.indices = {0, 1, 2, 0, 2, 3};
  wall.surfaces.batches = {{Shining(color), 0, 6, color[3] < 255}};
  return wall;
}

/// A line through the middle, from left to right.
ray::Lines Across(float depth, const Rgba& color) { return {{{-1, 0, depth}, color}, {{1, 0, depth}, color}}; }

/// Draws thousands of triangles and lines through each other, with every feature of the shader.
R2::Image Thicket() {
  std::mt19937 random(1);
  const auto number = [&random] { return static_cast<float>(random()) / 2147483648.0F - 1; };
  const auto color = [&] { return R2::Color{number() / 2 + 0.5, number() / 2 + 0.5, number() / 2 + 0.5}; };
  R2::Image image(16, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) image.Set(x, y, color());
  const auto texture = std::make_shared<const ray::Texture>(ray::Texture{image});
  ray::PreviewScene preview;
  preview.environment = std::make_shared<const ray::Environment>(image);
  preview.around = {0.1, 0.2, 0.3};
  for (int i = 0; i < 5; ++i) preview.lights.lights.push_back({color(), {number(), number(), number()}});
  preview.lights.lights.push_back({color(), {0, 0, -3}, false, {0, 0, 1}, 0.9, 8});
  ray::Surfaces& surfaces = preview.surfaces;
  for (std::uint32_t batch = 0; batch < 8; ++batch) {
    ray::SurfaceMaterial m;
    m.ambient = 0.1 * color(), m.kd = color(), m.ks = color(), m.kr = 0.3 * color(), m.n = 20;
    if (batch % 2) m.texture = texture;
    if (batch >= 6) m.kt = color();
    constexpr std::uint32_t count = 3 * 750;
    surfaces.batches.push_back({m, batch * count, count, batch == 7});
    for (std::uint32_t i = 0; i < count / 3; ++i) {
      const std::array<float, 3> middle{number(), number(), number()};
      for (int k = 0; k < 3; ++k) {
        surfaces.indices.push_back(static_cast<std::uint32_t>(surfaces.vertices.size()));
        surfaces.vertices.push_back(
            {{middle[0] + 0.15F * number(), middle[1] + 0.15F * number(), middle[2] + 0.15F * number()},
             Packed(0.5F * number(), 0.5F * number(), 0.5F)});
        surfaces.uvs.push_back({number(), number()});
      }
    }
  }
  ray::Lines lines;
  for (int i = 0; i < 4000; ++i) {
    const auto byte = [&random] { return static_cast<std::uint8_t>(random() >> 24); };
    lines.push_back({{number(), number(), number()}, {byte(), byte(), byte(), byte()}});
  }
  ray::Painter painter(ray::Canvas::Target::own);
  painter.canvas.Begin(200, 150, {0.1, 0.2, 0.3});
  const auto uploaded = painter.surfaces.Upload(preview);
  const ray::PreviewView view{{0, 0, -4}, {{{-1, -1, 2}, {2, 0, 0}, {0, 2, 0}}}, {1.2, true}};
  painter.surfaces.DrawSky(*uploaded, view);
  painter.surfaces.Draw(*uploaded, as_it_is, view, true);
  painter.lists.Draw(*painter.lists.Upload(lines), as_it_is, 2, 0.3);
  painter.surfaces.DrawEdges(*uploaded, as_it_is, {0, 0, 0, 40});
  return painter.canvas.Read();
}

// Otherwise tests would need a stored image for each kind.
TEST(Drawings, AreTheSameBytesInEveryContextOfOneRenderer) {
  std::map<std::string, std::vector<R2::Image>> images;  // by renderer
  for (const std::string& kind : ray::OffscreenContextKinds()) try {
      const auto context = ray::MakeOffscreenContext(kind);
      images[context->Name().substr(kind.size())].push_back(Thicket());
    } catch (const ray::ContextError&) {
    }
  bool were_compared = false;
  for (const auto& [renderer, same] : images)
    for (std::size_t i = 1; i < same.size(); ++i) {
      were_compared = true;
      EXPECT_TRUE(same[i] == same[0]) << renderer;
    }
  if (!were_compared) GTEST_SKIP() << "no two kinds of context here have the same renderer";
}

class Painter : public ray::testing::WithPainter {};

TEST_P(Painter, BeginsWithTheBackgroundAtAnySize) {
  for (const auto& [width, height] : {std::pair{30, 20}, {7, 50}, {0, 0}, {30, 20}}) {
    painter->canvas.Begin(width, height, {1.0 / 3, 2, -1});
    if (width == 0) continue;  // a window shrunk to nothing
    const R2::Image image = painter->canvas.Read();
    ASSERT_EQ(image.Width(), width);
    ASSERT_EQ(image.Height(), height);
    EXPECT_EQ(PixelOf(image, width - 1, height - 1), (Rgba{85, 255, 0, 255}));
  }
}

TEST_P(Painter, ReadsRowsFromTheBottom) {
  painter->canvas.Begin(8, 8, {});
  painter->canvas.SetViewport(0, 0, 8, 4);
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(0, red)), as_it_is, from_front, false);
  const R2::Image image = painter->canvas.Read();
  EXPECT_EQ(PixelOf(image, 3, 0), red);
  EXPECT_EQ(PixelOf(image, 3, 7), (Rgba{0, 0, 0, 255}));
}

TEST_P(Painter, ClipsToTheViewport) {
  painter->canvas.Begin(20, 20, {});
  painter->canvas.SetViewport(5, 6, 7, 8);
  ClipMatrix doubled = as_it_is;
  doubled[0] = doubled[5] = 2;
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(0, red)), doubled, from_front, false);
  const R2::Image image = painter->canvas.Read();
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      const bool is_inside = x >= 5 && x < 12 && y >= 6 && y < 14;
      EXPECT_EQ(PixelOf(image, x, y), is_inside ? red : (Rgba{0, 0, 0, 255})) << x << ' ' << y;
    }
}

TEST_P(Painter, ShowsTheFrontInAnyOrder) {
  const auto front = painter->surfaces.Upload(Wall(-0.5F, red)), back = painter->surfaces.Upload(Wall(0.5F, green));
  for (bool is_front_first : {true, false}) {
    painter->canvas.Begin(4, 4, {});
    painter->surfaces.Draw(is_front_first ? *front : *back, as_it_is, from_front, false);
    painter->surfaces.Draw(is_front_first ? *back : *front, as_it_is, from_front, false);
    EXPECT_EQ(PixelOf(painter->canvas.Read(), 1, 2), red);
  }
}

TEST_P(Painter, BlendsClearTrianglesAndShowsLaterOnesBehind) {
  painter->canvas.Begin(4, 4, {});
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(-0.5F, {255, 0, 0, 51})), as_it_is, from_front, false);
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 1, 2), (Rgba{51, 0, 0, 255}));
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(0.5F, green)), as_it_is, from_front, false);
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 1, 2), green);
}

// Rays behind an object are of interest; those in front must be distinguishable from them.
TEST_P(Painter, DimsOrOmitsHiddenLines) {
  const auto wall = painter->surfaces.Upload(Wall(0, {0, 0, 255, 255}));
  const auto front = painter->lists.Upload(Across(-0.5F, white)), behind = painter->lists.Upload(Across(0.5F, white));
  const auto at_middle = [&](const ray::GpuLines& lines, double hidden) {
    painter->canvas.Begin(9, 9, {});
    painter->surfaces.Draw(*wall, as_it_is, from_front, false);
    painter->lists.Draw(lines, as_it_is, 1, hidden);
    return PixelOf(painter->canvas.Read(), 4, 4);
  };
  EXPECT_EQ(at_middle(*front, 0), white);
  EXPECT_EQ(at_middle(*front, 0.2), white);
  EXPECT_EQ(at_middle(*behind, 0), (Rgba{0, 0, 255, 255}));
  EXPECT_EQ(at_middle(*behind, 0.2), (Rgba{51, 51, 255, 255}));
  EXPECT_EQ(at_middle(*behind, 1), white);
}

// Distances of a traced image hide lines as surfaces would; where nothing is hit they hide none.
TEST_P(Painter, HidesLinesBehindTheDistancesOfAnImage) {
  const auto clip = ray::Perspective({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 1, 10);
  const ray::PreviewView view{{0, 0, 0}, {{{-1, -1, 1}, {2, 0, 0}, {0, 2, 0}}}, {}};
  const auto line = [](float depth) {
    return ray::Lines{{{-9, 0, depth}, white}, {{9, 0, depth}, white}};
  };
  constexpr double unit = 2;  // of the drawing space
  const auto at_middle = [&](float distance, float depth_of_line) {
    painter->canvas.Begin(9, 9, {});
    const auto distances = painter->images.Make(1, 1);
    painter->images.Update(*distances, 0, 1, std::array{distance, distance, distance});
    painter->images.DrawDepths(*distances, view, clip, unit);
    painter->lists.Draw(*painter->lists.Upload(line(depth_of_line)), clip, 1, 0);
    return PixelOf(painter->canvas.Read(), 4, 4);
  };
  EXPECT_EQ(at_middle(8, 3.9F), white) << "before the surface at 8 / 2";
  EXPECT_EQ(at_middle(8, 4), white) << "on it";
  EXPECT_EQ(at_middle(8, 4.1F), (Rgba{0, 0, 0, 255})) << "behind it";
  EXPECT_EQ(at_middle(0, 9), white) << "nothing is hit";
}

TEST_P(Painter, ShowsLinesThatLieOnTriangles) {
  painter->canvas.Begin(9, 9, {});
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(0, red)), as_it_is, from_front, false);
  painter->lists.Draw(*painter->lists.Upload(Across(0, white)), as_it_is);
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 4, 4), white);
}

TEST_P(Painter, DrawsLinesOfTheRequestedWidth) {
  for (int width : {1, 3, 5}) {
    painter->canvas.Begin(21, 21, {});
    painter->lists.Draw(*painter->lists.Upload(Across(0, white)), as_it_is, width);
    const R2::Image image = painter->canvas.Read();
    int count = 0;
    for (int y = 0; y < 21; ++y) count += PixelOf(image, 10, y) == white;
    EXPECT_EQ(count, width);
  }
}

TEST_P(Painter, DrawsTheEdgesOfTrianglesInOneColor) {
  const auto wall = painter->surfaces.Upload(Wall(0, red));
  painter->canvas.Begin(21, 21, {});
  painter->surfaces.Draw(*wall, as_it_is, from_front, false);
  ClipMatrix smaller = as_it_is;
  smaller[0] = smaller[5] = 0.5;
  painter->surfaces.DrawEdges(*wall, smaller, green);
  const R2::Image image = painter->canvas.Read();
  EXPECT_EQ(PixelOf(image, 10, 10), green) << "the diagonal";
  EXPECT_EQ(PixelOf(image, 8, 12), red) << "between";
  int greens = 0;
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 21; ++x) greens += PixelOf(image, x, y) == green;
  EXPECT_GE(greens, 45);  // four sides of 11 pixels minus corners, and a diagonal
  EXPECT_LE(greens, 60);
}

// Otherwise a dense mesh would be filled with ink.
TEST_P(Painter, DrawsTheEdgesOfSmallTrianglesFaintly) {
  const auto wall = painter->surfaces.Upload(Wall(0, red));
  const auto green_of = [&](double size) {
    painter->canvas.Begin(41, 41, {});
    ClipMatrix smaller = as_it_is;
    smaller[0] = smaller[5] = size;
    painter->surfaces.DrawEdges(*wall, smaller, green);
    return PixelOf(painter->canvas.Read(), 20, 20)[1];
  };
  EXPECT_EQ(green_of(1), 255);
  EXPECT_LT(green_of(0.05), 150);
  EXPECT_GT(green_of(0.05), 50);
}

// Reads back rows from the bottom, r g b, so that the displayed values are known to be the traced ones.
std::vector<float> ReadBack(const ray::GpuImage& image) {
  std::vector<float> rgb(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  glBindTexture(GL_TEXTURE_2D, image.texture.Name());
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT, rgb.data());
  return rgb;
}

TEST_P(Painter, KeepsEveryBitOfAnImage) {
  std::mt19937 random(2);
  std::vector<float> rgb(3 * 13 * 7);
  for (float& channel : rgb)
    channel = std::ldexp(static_cast<float>(random() >> 8), static_cast<int>(random() % 60) - 50);
  const auto uploaded = painter->images.Make(13, 7);
  EXPECT_EQ(ReadBack(*uploaded), std::vector<float>(rgb.size()));
  painter->images.Update(*uploaded, 0, 7, rgb);
  EXPECT_EQ(ReadBack(*uploaded), rgb);
}

TEST_P(Painter, UpdatesTheRowsItIsGivenAndNoOthers) {
  const auto uploaded = painter->images.Make(5, 6);
  std::vector<float> expected(3 * 5 * 6, 0.25F);
  painter->images.Update(*uploaded, 0, 6, expected);
  const std::vector<float> rows(3 * 5 * 2, 0.75F);
  painter->images.Update(*uploaded, 3, 2, rows);
  std::copy(rows.begin(), rows.end(), expected.begin() + 3 * 5 * 3);
  EXPECT_EQ(ReadBack(*uploaded), expected);
}

/// Returns values around every place where a byte gives way to the next, linear or sRGB, and values that are not
/// finite.
std::vector<float> HardChannels() {
  const float infinity = std::numeric_limits<float>::infinity();
  std::vector<float> channels{
      0, -0.0F, -1, 1, 2, 1e30F, infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 1e-30F, 0.0031308F};
  for (int byte = 0; byte <= 255; ++byte)
    for (double edge : {(byte + 0.5) / 255, byte / 255.0, R2::DecodeSrgb((byte + 0.5) / 255)}) {
      float channel = std::nextafter(std::nextafter(static_cast<float>(edge), 0.0F), 0.0F);
      for (int i = 0; i < 5; ++i, channel = std::nextafter(channel, 2.0F)) channels.push_back(channel);
    }
  return channels;
}

TEST_P(Painter, ShowsTheBytesOfAnImageFile) {
  const std::vector<float> channels = HardChannels();
  const int width = 64, height = static_cast<int>((channels.size() + 63) / 64);
  const auto uploaded = painter->images.Make(width, height);
  std::vector<float> rgb(3 * static_cast<std::size_t>(width * height));
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = channels[(i / 3 + i % 3 * 5) % channels.size()];
  painter->images.Update(*uploaded, 0, height, rgb);
  for (bool srgb : {false, true}) {
    painter->canvas.Begin(width + 5, height + 5, {});
    painter->canvas.SetViewport(3, 2, width, height);
    painter->images.Draw(*uploaded, Look{.srgb = srgb});
    const R2::Image image = painter->canvas.Read();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float* c = &rgb[3 * static_cast<std::size_t>(y * width + x)];
        const auto byte = [srgb](float v) { return R2::ToByte(srgb ? R2::EncodeSrgb(double{v}) : double{v}); };
        ASSERT_EQ(PixelOf(image, x + 3, y + 2), (Rgba{byte(c[0]), byte(c[1]), byte(c[2]), 255}))
            << c[0] << ' ' << c[1] << ' ' << c[2] << (srgb ? " in sRGB" : "");
      }
  }
}

TEST_P(Painter, MultipliesAnImageByItsExposure) {
  const auto uploaded = painter->images.Make(1, 1);
  painter->images.Update(*uploaded, 0, 1, std::array{0.125F, 0.25F, 0.75F});
  painter->canvas.Begin(2, 2, {});
  painter->images.Draw(*uploaded, Look{.exposure = 2});
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 0, 0), (Rgba{R2::ToByte(0.25), R2::ToByte(0.5), 255, 255}));
}

TEST_P(Painter, OmitsRowsThatAreNotTracedYet) {
  const auto uploaded = painter->images.Make(4, 4);
  painter->images.Update(*uploaded, 0, 4, std::vector<float>(48, 1.0F));
  for (int rows : {0, 1, 3, 4}) {
    painter->canvas.Begin(4, 4, {});
    painter->images.Draw(*uploaded, Look{.rows = rows});
    const R2::Image image = painter->canvas.Read();
    for (int y = 0; y < 4; ++y) EXPECT_EQ(PixelOf(image, 2, y) == white, y < rows) << rows << ' ' << y;
  }
}

TEST_P(Painter, PutsAnImageUprightOnAQuadBehindNearerObjects) {
  const auto uploaded = painter->images.Make(2, 2);
  painter->images.Update(*uploaded, 0, 2, std::array{1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 1.F, 1.F, 1.F});
  const std::array<std::array<float, 3>, 4> corners{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
  painter->canvas.Begin(10, 10, {});
  painter->images.Draw(*uploaded, corners, as_it_is, Look{});
  const R2::Image image = painter->canvas.Read();
  EXPECT_EQ(PixelOf(image, 1, 1), red);
  EXPECT_EQ(PixelOf(image, 8, 1), green);
  EXPECT_EQ(PixelOf(image, 1, 8), (Rgba{0, 0, 255, 255}));
  EXPECT_EQ(PixelOf(image, 8, 8), white);
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(0.5F, red)), as_it_is, from_front, false);
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 8, 8), white);
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(-0.5F, red)), as_it_is, from_front, false);
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 8, 8), red);
}

TEST_P(Painter, BlendsAnImageAndShowsLaterDrawingBehindIt) {
  const auto uploaded = painter->images.Make(1, 1);
  painter->images.Update(*uploaded, 0, 1, std::array{1.F, 1.F, 1.F});
  const std::array<std::array<float, 3>, 4> corners{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
  painter->canvas.Begin(4, 4, {});
  painter->images.Draw(*uploaded, corners, as_it_is, Look{.alpha = 0.2});
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 1, 1), (Rgba{51, 51, 51, 255}));
  painter->surfaces.Draw(*painter->surfaces.Upload(Wall(0.5F, red)), as_it_is, from_front, false);
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 1, 1), red);
}

TEST_P(Painter, DrawsPanelsPixelByPixelWithinTheirParts) {
  ray::PanelDrawing panels;
  // Full ink, none, and half.
  panels.sheet = std::make_shared<const ray::InkSheet>(ray::InkSheet{3, 1, {255, 0, 128}});
  const auto add = [&](float left, float top, float texel, const Rgba& color) {
    const auto first = static_cast<std::uint32_t>(panels.corners.size());
    for (const auto& [i, j] : {std::pair{0.F, 0.F}, {4.F, 0.F}, {4.F, 4.F}, {0.F, 4.F}})
      panels.corners.push_back({left + i, top + j, (texel + 0.5F) / 3, 0.5F, color});
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) panels.indices.push_back(first + i);
  };
  add(0, 0, 0, green);
  add(4, 0, 1, green);
  add(8, 0, 2, {0, 0, 0, 255});
  add(0, 4, 0, red);
  panels.parts = {{0, 0, 12, 8, 0, 18}, {0, 4, 2, 8, 18, 6}};
  painter->canvas.Begin(12, 8, {1, 1, 1});
  painter->canvas.SetViewport(0, 0, 1, 1);  // which panels ignore
  painter->panels.Draw(panels, painter->canvas);
  const R2::Image image = painter->canvas.Read();
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 8; ++y) {
      const bool is_upper = y >= 4;  // rows are from the bottom
      const Rgba expected = is_upper ? (x < 4 ? green : x < 8 ? white : Rgba{127, 127, 127, 255}) : x < 2 ? red : white;
      EXPECT_EQ(PixelOf(image, x, y), expected) << x << ' ' << y;
    }
}

TEST_P(Painter, DrawsEmptyListsAsNothing) {
  painter->canvas.Begin(4, 4, {1, 1, 1});
  const auto triangles = painter->surfaces.Upload({});
  painter->surfaces.DrawSky(*triangles, from_front);
  painter->surfaces.Draw(*triangles, as_it_is, from_front, false);
  painter->surfaces.DrawEdges(*triangles, as_it_is, red);
  painter->lists.Draw(*painter->lists.Upload(ray::Lines{}), as_it_is, 1, 0.5);
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 0, 0), white);
}

TEST_P(Painter, RejectsImagesThatAreTooLarge) {
  EXPECT_THROW(painter->images.Make(1 << 20, 1), ray::ContextError);
  EXPECT_THROW(painter->canvas.Begin(1, 1 << 20, {}), ray::ContextError);
  painter->canvas.Begin(2, 2, {1, 1, 1});
  EXPECT_EQ(PixelOf(painter->canvas.Read(), 0, 0), white);
}

// A scene may be destroyed after the painter that drew it.
TEST_P(Painter, MayBeDestroyedBeforeItsUploads) {
  const auto triangles = painter->surfaces.Upload(Wall(0, red));
  const auto uploaded = painter->images.Make(2, 2);
  painter.reset();
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Painter);
INSTANTIATE_TEST_SUITE_P(EveryKind, Painter, ::testing::ValuesIn(ray::OffscreenContextKinds()), ray::testing::KindOf);

}  // namespace
