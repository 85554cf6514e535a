#include "source/render/SharingGain.h"

#include <gtest/gtest.h>

#include "source/render/PixelTrace.h"
#include "tests/Project.h"

namespace ray {
namespace {

RenderSettings PathsOf(int width, int height, int samples) {
  RenderSettings settings = project::Sized(width, height);
  settings.mode = RenderMode::path;
  settings.samples = samples;
  return settings;
}

struct Prepared : project::Stage {
  explicit Prepared(const char* file)
      : Stage(project::Root() / file), accelerator(FindAcceleratorKind("bvh")->Make(world, {})) {}
  bool Shares(const RenderSettings& settings) const { return SharesLight(world, *accelerator, settings); }
  std::unique_ptr<const Accelerator> accelerator;
};

TEST(SharingGain, RoomsGainAndOpenPlacesLose) {
  const Prepared room("bench/scenes/room.scn"), open("bench/scenes/balls.scn");
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    RenderSettings settings = PathsOf(128, 96, 16);
    settings.trace.max_depth = 6, settings.seed = seed;
    EXPECT_GT(SharingGain(room.world, *room.accelerator, settings), 2.7) << seed;
    EXPECT_LT(SharingGain(open.world, *open.accelerator, settings), 1) << seed;
    EXPECT_TRUE(room.Shares(settings));
    EXPECT_FALSE(open.Shares(settings));
    settings.share = Sharing::off;
    EXPECT_FALSE(room.Shares(settings));
    settings.share = Sharing::on;
    EXPECT_TRUE(open.Shares(settings));
  }
}

TEST(SharingGain, TheDecisionIsThatOfTheWholeImage) {
  const Prepared room("bench/scenes/room.scn");
  RenderSettings settings = PathsOf(128, 96, 16);
  const double gain = SharingGain(room.world, *room.accelerator, settings);
  settings.crop = PixelRectangle{3, 5, 20, 9};
  EXPECT_EQ(SharingGain(room.world, *room.accelerator, settings), gain);
  settings.samples = 64, settings.threads = 1, settings.tile_size = 8;
  EXPECT_EQ(SharingGain(room.world, *room.accelerator, settings), gain);
}

TEST(SharingGain, IsKnownWhereNothingCanBeShared) {
  RenderSettings settings = PathsOf(64, 64, 16);
  EXPECT_EQ(SharesLight(settings), std::nullopt);
  settings.samples = 1;
  EXPECT_EQ(SharesLight(settings), false);
  settings.budget.error = ErrorTarget{2, ErrorUnit::display};
  EXPECT_EQ(SharesLight(settings), std::nullopt);
  settings.share = Sharing::on;
  EXPECT_EQ(SharesLight(settings), true);
  settings.trace.max_depth = 0;
  EXPECT_EQ(SharesLight(settings), false);
  settings.trace.max_depth = 3, settings.trace.shadows = false;
  EXPECT_EQ(SharesLight(settings), false);
  settings.trace.shadows = true, settings.mode = RenderMode::whitted;
  EXPECT_EQ(SharesLight(settings), false);
}

TEST(SharingGain, ImagesAreTheSameForAnyThreadsTilesAndPauses) {
  const Prepared room("bench/scenes/room.scn");
  RenderSettings settings = PathsOf(72, 40, 12);
  settings.trace.max_depth = 3, settings.shares_light = true;
  const R2::Image image = Render(room.world, *room.accelerator, settings).image;
  settings.threads = 3, settings.tile_size = 8;
  EXPECT_TRUE(Render(room.world, *room.accelerator, settings).image == image);
  settings.tile_size = 0;
  RenderMonitor monitor;
  monitor.save_every = 1e-3;
  int saved = 0;
  monitor.save = [&](const RenderState&) { ++saved; };
  EXPECT_TRUE(Render(room.world, *room.accelerator, settings, monitor).image == image);
  EXPECT_GT(saved, 0);
  settings.shares_light = false;
  EXPECT_FALSE(Render(room.world, *room.accelerator, settings).image == image);
}

TEST(SharingGain, ACropIsAPartOfTheWholeImage) {
  const Prepared room("bench/scenes/room.scn");
  RenderSettings settings = PathsOf(72, 40, 4);
  settings.shares_light = true;
  for (const FilterKind filter : {FilterKind::box, FilterKind::mitchell}) {
    settings.filter = filter, settings.crop.reset();
    const R2::Image whole = Render(room.world, *room.accelerator, settings).image;
    settings.crop = PixelRectangle{29, 7, 35, 12};
    const R2::Image crop = Render(room.world, *room.accelerator, settings).image;
    for (int y = 0; y < crop.Height(); ++y)
      for (int x = 0; x < crop.Width(); ++x) EXPECT_EQ(crop.At(x, y), whole.At(29 + x, 7 + y)) << x << " " << y;
  }
}

TEST(SharingGain, APixelsRaysSayThatTheyAreItsOwn) {
  const Prepared room("bench/scenes/room.scn");
  RenderSettings settings = PathsOf(64, 64, 4);
  EXPECT_EQ(DebugPixel(room.world, *room.accelerator, settings, 3, 4, Digits::five).find("share light"),
            std::string::npos);
  settings.shares_light = true;
  EXPECT_NE(DebugPixel(room.world, *room.accelerator, settings, 3, 4, Digits::five).find("share light"),
            std::string::npos);
}

}  // namespace
}  // namespace ray
