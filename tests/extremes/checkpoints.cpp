// Renders that are broken off and gone on with, and checkpoints that are not what they should be.

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <thread>

#include "source/render/RenderState.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"

namespace {

ray::RenderSettings Everything() {
  ray::RenderSettings settings;
  settings.width = 40;
  settings.height = 27;
  settings.samples = 24;
  settings.mode = ray::RenderMode::path;
  settings.filter = ray::FilterKind::mitchell;
  settings.camera.aperture = 0.05;
  settings.camera.focus = 4;
  settings.camera.motion = {0.05, 0, 0};
  return settings;
}

/// Breaks a render off when a number of tiles is done, then goes on from what it kept, again and again.
ray::RenderResult InPieces(const project::Stage& stage, ray::RenderSettings settings, std::mt19937& random,
                           int& breaks) {
  const auto accelerator = ray::FindAcceleratorKind("auto")->Make(stage.world, {});
  std::optional<ray::RenderState> kept;
  while (true) {
    std::atomic<bool> stop = false;
    std::atomic<int> tiles_left = std::uniform_int_distribution(0, 60)(random);
    ray::RenderMonitor monitor;
    monitor.stop = &stop;
    monitor.tile_done = [&](const ray::RenderProgress&) {
      if (--tiles_left < 0) stop = true;
    };
    if (kept)
      monitor.resume = [&](const ray::Film& film) { return ray::DecodedState(ray::Encoded(*kept, "x"), "x", film); };
    monitor.save = [&](const ray::RenderState& state) { kept = state; };
    settings.threads = std::uniform_int_distribution(1, 3)(random);
    auto result = ray::Render(stage.world, *accelerator, settings, monitor);
    if (result.IsComplete()) return result;
    ++breaks;
  }
}

TEST(Extremes, J3_APictureMadeInPiecesIsThatOfOneRun) {
  std::mt19937 random(3);
  int breaks = 0;
  for (const char* scene : {"hello.scn", "area_light.scn", "motion.scn"}) {
    const project::Stage stage(project::Root() / "scenes" / scene);
    for (const bool by_error : {false, true}) {
      ray::RenderSettings settings = Everything();
      settings.tile_size = 8;
      if (by_error) settings.budget.error = ray::ErrorTarget{6, ray::ErrorUnit::display};
      settings.samples = by_error ? 64 : 24;
      const auto whole = project::Render(stage, settings);
      for (int round = 0; round < 9; ++round) {
        const auto pieces = InPieces(stage, settings, random, breaks);
        EXPECT_TRUE(pieces.image == whole.image) << scene << (by_error ? " by error" : " by samples");
        EXPECT_EQ(pieces.block_samples, whole.block_samples);
      }
    }
  }
  EXPECT_GE(breaks, 50);
}

TEST(Extremes, J3_KeepingStatesOnTheWayChangesNoBit) {
  const project::Stage stage(project::Root() / "scenes" / "area_light.scn");
  const auto accelerator = ray::FindAcceleratorKind("auto")->Make(stage.world, {});
  const ray::RenderSettings settings = Everything();
  int kept = 0;
  ray::RenderMonitor monitor;
  monitor.save = [&](const ray::RenderState&) { ++kept; };
  monitor.save_every = 1e-6;  // each pause is worth a step, however short
  EXPECT_TRUE(ray::Render(stage.world, *accelerator, settings, monitor).image ==
              project::Render(stage, settings).image);
  EXPECT_GT(kept, 0);
}

class Checkpoints : public testing::Test {
 protected:
  void SetUp() override {
    ray::RenderSettings settings = Everything();
    settings.width = settings.height = 9;
    settings.samples = 3;
    const project::Stage stage(project::Root() / "scenes" / "sphere.scn");
    const auto accelerator = ray::FindAcceleratorKind("auto")->Make(stage.world, {});
    std::atomic<bool> stop = false;
    ray::RenderMonitor monitor;
    monitor.stop = &stop;
    monitor.tile_done = [&](const ray::RenderProgress&) { stop = true; };
    monitor.save = [&](const ray::RenderState& state) { bytes_ = ray::Encoded(state, identity_); };
    settings.tile_size = 8;
    settings.threads = 1;
    ray::Render(stage.world, *accelerator, settings, monitor);
    ASSERT_FALSE(bytes_.empty());
  }

  bool IsTaken(std::span<const unsigned char> bytes, const std::string& identity) const {
    try {
      ray::DecodedState(bytes, identity, film_);
      return true;
    } catch (const ray::CheckpointError&) {
      return false;
    }
  }

  const std::string identity_ = "version 1\nscene abc\n-seed 0\n";
  const ray::Film film_{9, 9, {0, 0, 9, 9}, ray::FilterKind::mitchell};
  std::vector<unsigned char> bytes_;
};

TEST_F(Checkpoints, L9_CutAnywhereAreRefused) {
  EXPECT_TRUE(IsTaken(bytes_, identity_));
  for (std::size_t length = 0; length < bytes_.size(); ++length)
    ASSERT_FALSE(IsTaken(std::span(bytes_).first(length), identity_)) << length << " bytes";
}

TEST_F(Checkpoints, L9_WithOneBitChangedAreRefused) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    const int bit = static_cast<int>(i % 8);
    bytes_[i] = static_cast<unsigned char>(bytes_[i] ^ (1 << bit));
    ASSERT_FALSE(IsTaken(bytes_, identity_)) << "byte " << i;
    bytes_[i] = static_cast<unsigned char>(bytes_[i] ^ (1 << bit));
  }
}

TEST_F(Checkpoints, L9_OfAnotherPictureAreRefusedAndTheMessageSaysInWhat) {
  try {
    ray::DecodedState(bytes_, "version 1\nscene abc\n-seed 7\n", film_);
    FAIL();
  } catch (const ray::CheckpointError& error) {
    EXPECT_STREQ(error.what(), "the checkpoint was made with -seed 0");
  }
  const ray::Film larger(24, 9, {0, 0, 24, 9}, ray::FilterKind::mitchell);
  EXPECT_THROW(ray::DecodedState(bytes_, identity_, larger), ray::CheckpointError);
}

}  // namespace
