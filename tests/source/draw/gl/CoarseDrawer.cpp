#include "source/draw/gl/CoarseDrawer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "R2/ImageFile.h"
#include "source/draw/gl/Drawer.h"
#include "source/view/Viewer.h"
#include "tests/Project.h"
#include "tests/source/draw/gl/WithPainter.h"
#include "tests/source/view/Witness.h"

namespace {

class CoarseDrawing : public ray::testing::WithPainter {
 protected:
  /// Returns the first frame of a viewer of that scene, with that pixel step.
  R2::Image Shown(const std::string& scene, int step) {
    ray::Witness host;
    ray::ViewerSettings settings;
    settings.scene = project::Root() / "scenes" / scene;
    settings.render.width = 97, settings.render.height = 61;
    settings.render.srgb = true;
    ray::Viewer viewer(
        settings, std::make_shared<const ray::LoadedScene>(settings.scene, settings.parse, settings.accelerator), host);
    viewer.Handle(ray::KeyEvent{ray::Key::l, {}, true});  // lines
    viewer.WaitForFaces();
    ray::FrameState shown = viewer.Show();
    shown.panels.reset();  // labels
    shown.detail.pixel_step = step;
    ray::Drawer drawer(*painter);
    drawer.Draw(shown);
    return painter->canvas.Read();
  }
};

double MeanDifference(const R2::Image& a, const R2::Image& b) {
  double sum = 0;
  for (int y = 0; y < a.Height(); ++y)
    for (int x = 0; x < a.Width(); ++x) {
      const R2::Color off = a.At(x, y) - b.At(x, y);
      sum += (std::abs(off.r) + std::abs(off.g) + std::abs(off.b)) / 3;
    }
  return sum / (a.Width() * a.Height());
}

TEST_P(CoarseDrawing, OfPixelsOneByOneIsTheDrawingItself) {
  painter->canvas.Begin(40, 30, {0.2, 0.4, 0.6});
  const R2::Image plain = painter->canvas.Read();
  painter->canvas.Fill({});
  painter->coarse.Draw(1, [&] { painter->canvas.Fill({0.2, 0.4, 0.6}); });
  EXPECT_TRUE(painter->canvas.Read() == plain);
}

TEST_P(CoarseDrawing, LooksLikeTheDrawingInFull) {
  for (const char* scene : {"hello.scn", "environment.scn", "refraction.scn"}) {
    const R2::Image full = Shown(scene, 1);
    const double half = MeanDifference(Shown(scene, 2), full), eighth = MeanDifference(Shown(scene, 8), full);
    EXPECT_GT(half, 0) << scene << ": nothing was drawn in fewer pixels";
    EXPECT_LT(half, eighth) << scene;
    EXPECT_LT(eighth, 0.15) << scene;
  }
}

TEST_P(CoarseDrawing, StaysInItsViewportAndClip) {
  painter->canvas.Begin(40, 30, {1, 0, 0});
  painter->canvas.SetViewport(10, 5, 20, 20);
  painter->canvas.Clip(10, 5, 10, 20);
  painter->coarse.Draw(4, [&] { painter->canvas.Fill({0, 1, 0}); });
  const R2::Image drawn = painter->canvas.Read();
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const bool is_inside = x >= 10 && x < 20 && y >= 5 && y < 25;
      ASSERT_EQ(drawn.At(x, y), (is_inside ? R2::Color{0, 1, 0} : R2::Color{1, 0, 0})) << x << ' ' << y;
    }
}

TEST_P(CoarseDrawing, HidesLinesBehindIt) {
  const ray::ClipMatrix as_it_is{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  ray::PreviewScene wall;
  for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
    wall.surfaces.vertices.push_back({{x, y, 0}, {0, 0, -32767, 0}});
  wall.surfaces.indices = {0, 1, 2, 0, 2, 3};
  ray::SurfaceMaterial blue;
  blue.emission = {0, 0, 1};
  wall.surfaces.batches = {{blue, 0, 6, false}};
  const auto surfaces = painter->surfaces.Upload(wall);
  for (const auto& [depth, is_seen] : {std::pair{-0.5F, true}, {0.5F, false}}) {
    painter->canvas.Begin(32, 32, {});
    painter->coarse.Draw(2, [&] {
      painter->canvas.Fill({});
      painter->surfaces.Draw(*surfaces, as_it_is, {{0, 0, -4}, {}, {}}, false);
    });
    const ray::Lines across{{{-1, 0, depth}, {255, 0, 0, 255}}, {{1, 0, depth}, {255, 0, 0, 255}}};
    painter->lists.Draw(*painter->lists.Upload(across), as_it_is, 3, 0);
    EXPECT_EQ(painter->canvas.Read().At(16, 16), (is_seen ? R2::Color{1, 0, 0} : R2::Color{0, 0, 1})) << depth;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CoarseDrawing, testing::ValuesIn(ray::OffscreenContextKinds()), ray::testing::KindOf);

}  // namespace
