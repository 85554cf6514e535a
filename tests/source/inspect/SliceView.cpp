// A cut that is drawn with the wrong scale, or filled where nothing is, would be believed.

#include "source/inspect/SliceView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "R3/ShapeKind.h"
#include "tests/Accelerators.h"
#include "tests/Draw.h"
#include "tests/Project.h"

namespace {

/// A shape, cut and seen in a drawing of 400 x 300 pixels.
struct Seen {
  Seen(std::shared_ptr<const R3::Shape> shape, ray::SlicePlane plane, const R3::Point& through)
      : stage(SceneWith(std::move(shape))),
        accelerator(ray::FindAcceleratorKind("bvh")->Make(stage.world, {})),
        cut(ray::CutOf(stage.world, *accelerator, ray::AxisSlice(plane, through, stage.scene->root.bounds), 400)),
        view(ray::SliceView::Of(cut.slice, stage.scene->root.bounds, {400, 300})) {}

  static ray::Scene SceneWith(std::shared_ptr<const R3::Shape> shape) {
    ray::Scene scene;
    scene.root.children.push_back(accelerators::Leaf(std::move(shape)));
    SetBounds(scene.root);
    return scene;
  }
  /// The area of the filling, in the slice's units.
  double Area() const {
    const ray::Lines lines = CutFilling(cut, stage.world, view);
    double area = 0;
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
      EXPECT_EQ(lines[i].at[1], lines[i + 1].at[1]);
      EXPECT_LE(lines[i].at[0], lines[i + 1].at[0]);
      area += static_cast<double>(lines[i + 1].at[0] - lines[i].at[0]) * view.size.width / 2 * view.pixel * view.pixel;
    }
    return area;
  }

  project::Stage stage;
  std::unique_ptr<const ray::Accelerator> accelerator;
  ray::SceneCut cut;
  ray::SliceView view;
};

// Sums over rows of pixels: as exact as a row is narrow, here to a part in a hundred.
constexpr double share = 0.01;

TEST(CutFilling, OfSpheresAndToriIsDisksAndRings) {
  constexpr double pi = std::numbers::pi;
  const Seen sphere(R3::MakeShape("sphere", {5, 2, 3, 1.5}), ray::SlicePlane::xz, {0, 2.9, 0});
  const double disk = pi * (1.5 * 1.5 - 0.9 * 0.9);
  EXPECT_NEAR(sphere.Area(), disk, share * disk);
  const Seen ring(R3::MakeShape("torus", {0, 0, 0, 1, 0.25}), ray::SlicePlane::xz, {0, 0, 0});
  const double of_ring = pi * (1.25 * 1.25 - 0.75 * 0.75);
  EXPECT_NEAR(ring.Area(), of_ring, share * of_ring);
  const Seen disks(R3::MakeShape("torus", {0, 0, 0, 1, 0.25}), ray::SlicePlane::xy, {0, 0, 0});
  EXPECT_NEAR(disks.Area(), 2 * pi * 0.25 * 0.25, share * 2 * pi * 0.25 * 0.25);
}

TEST(CutFilling, IsAsStrongInLinesThatLieOverEachOther) {
  const Seen sphere(R3::MakeShape("sphere", {0, 0, 0, 1}), ray::SlicePlane::xz, {0, 0, 0});
  const auto behind = [&](int line_width) {
    const ray::Lines lines = CutFilling(sphere.cut, sphere.stage.world, sphere.view, line_width);
    return std::pow(1 - lines.at(0).color[3] / 255.0, line_width);  // what is seen of the ground
  };
  EXPECT_GT(behind(1), 0.5);
  for (const int line_width : {2, 3}) EXPECT_NEAR(behind(line_width), behind(1), 0.01) << line_width;
}

TEST(CutFilling, IsOfClosedMeshesAndNotOfSheets) {
  const auto box = R3::MakeShape("box", {-1, -1, -1, 1, 1, 1})->Tessellate(8);
  EXPECT_NEAR(Seen(std::make_shared<R3::Mesh>(box), ray::SlicePlane::xz, {0, 0.3, 0}).Area(), 4, 4 * share);
  const Seen sheet(R3::MakeShape("tri", {-1, -1, 0, 1, -1, 0.5, 0, 1, 0}), ray::SlicePlane::xz, {0, 0, 0});
  EXPECT_FALSE(sheet.cut.pieces.empty());
  EXPECT_EQ(sheet.Area(), 0);
}

TEST(SliceView, HoldsTheSceneAndIsFilledInOneDirection) {
  Draw draw(71);
  for (int i = 0; i < 1000; ++i) {
    const double size = draw.Scale(-6, 6);
    const R3::Point low{size * draw.Between(-9, 9), size * draw.Between(-9, 9), size * draw.Between(-9, 9)};
    const R3::Box box{low, low + size * R3::Vector{draw.Between(0.1, 5), draw.Between(0.1, 5), draw.Between(0.1, 5)}};
    const ray::DrawingSize drawing{draw.Whole(1, 2000), draw.Whole(1, 2000)};
    const ray::Slice slice = ray::AxisSlice(ray::SlicePlane::yz, box.Center(), box);
    const ray::SliceView view = ray::SliceView::Of(slice, box, drawing);
    double most = 0;
    for (int c = 0; c < 8; ++c)
      for (const float x : view.At(slice.Project(box.Corner(c)))) most = std::max(most, std::abs(double(x)));
    EXPECT_LT(most, 1);
    EXPECT_GT(most, 0.95);
    const R2::Point p{draw.Between(0, drawing.width), draw.Between(0, drawing.height)};
    EXPECT_NEAR(view.Pixel(view.InSlice(p)).x, p.x, 1e-6);
    EXPECT_NEAR(view.Pixel(view.InSlice(p)).y, p.y, 1e-6);
  }
}

TEST(SliceView, NumbersStandWhereTheySay) {
  const ray::SliceView view{{3, -7}, 0.01, {640, 480}};
  const ray::SliceAxes axes = ray::AxesOf(view, {{"x", "z"}, {1, -6}, "the origin"}, ray::LetterSize{});
  int across = 0, upward = 0;
  for (const ray::Label& label : axes.labels) {
    char* end = nullptr;
    const double number = std::strtod(label.text.c_str(), &end);
    if (*end || label.y > 20 * (label.x > 10)) {
      if (*end || label.x > 10) continue;  // a name, or the scale
      ++upward;
      EXPECT_NEAR(view.Pixel({0, number - 6}).y, label.y + 8, 0.01) << label.text;
    } else {
      ++across;
      EXPECT_NEAR(view.Pixel({number + 1, 0}).x, label.x + 4 * double(label.text.size()), 0.01) << label.text;
    }
  }
  EXPECT_GE(across, 4);
  EXPECT_GE(upward, 4);
}

TEST(SliceView, FarFromTheOriginNumbersStillDifferAndEnd) {
  for (const double far : {1e6, 1e12, 1e17, -1e300}) {
    const ray::SliceAxes axes =
        ray::AxesOf({{0, 0}, 0.01, {640, 480}}, {{"x", "z"}, {far, far}, "the origin"}, ray::LetterSize{});
    EXPECT_LT(axes.lines.size(), 500u);
    if (std::abs(far) > 1e12) continue;  // no doubles are so near to each other
    std::map<double, int> across;
    for (const ray::Label& label : axes.labels)
      if (label.y < 10 && label.text[0] != 'x') {
        EXPECT_EQ(++across[std::stod(label.text)], 1) << label.text;
      }
    EXPECT_GE(across.size(), far > 1e6 ? 1u : 3u);
  }
}

// "1.2e+02" stood for 120 and for 150.
TEST(SliceView, NumbersAreNeverPowersAndNeverAlike) {
  for (const double pixel : {1e-12, 1e-6, 1e-3, 0.01, 0.4, 1.0, 30.0, 1e3, 1e7, 1e12}) {
    const ray::SliceAxes axes =
        ray::AxesOf({{0, 0}, pixel, {640, 480}}, {{"x", "z"}, {0, 0}, "the origin"}, ray::LetterSize{});
    std::map<std::string, int> across;
    for (const ray::Label& label : axes.labels) {
      EXPECT_EQ(label.text.find('e'), std::string::npos) << label.text;
      EXPECT_LE(label.text.size(), 12u) << label.text;
      if (label.y < 10) ++across[label.text];
    }
    EXPECT_GE(across.size(), 4u) << pixel;
    for (const auto& [text, times] : across) EXPECT_EQ(times, 1) << text;
  }
}

TEST(SliceView, TicksTakeTheFinestStepOfOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(ray::TickStep(10, 10), 1);
  EXPECT_DOUBLE_EQ(ray::TickStep(10, 9), 2);
  EXPECT_DOUBLE_EQ(ray::TickStep(10, 4), 5);
  EXPECT_DOUBLE_EQ(ray::TickStep(10, 1), 10);
  EXPECT_DOUBLE_EQ(ray::TickStep(3e-7, 5), 1e-7);
}

}  // namespace
