// Renders that are broken off and gone on with, and checkpoints that are not what they should be.

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <limits>
#include <random>

#include "source/render/RenderState.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"

namespace {

ray::RenderSettings Everything() {
  ray::RenderSettings settings = project::Sized(40, 27);
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
      monitor.resume = [&](const ray::Film& film) {
        ray::RenderState state = ray::DecodedState(ray::Encoded(*kept, "x"), "x", film);
        ray::CheckState(state, film, settings);  // takes whatever a render kept
        return state;
      };
    monitor.save = [&](const ray::RenderState& state) { kept = state; };
    settings.threads = std::uniform_int_distribution(1, 3)(random);
    auto result = ray::Render(stage.world, *accelerator, settings, monitor);
    if (result.IsComplete()) return result;
    ++breaks;
  }
}

TEST(Extremes, J3_AImageMadeInPiecesIsThatOfOneRun) {
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

TEST_F(Checkpoints, L9_OfAnotherImageAreRefusedNamingTheDifference) {
  try {
    ray::DecodedState(bytes_, "version 1\nscene abc\n-seed 7\n", film_);
    FAIL();
  } catch (const ray::CheckpointError& error) {
    EXPECT_STREQ(error.what(), "the checkpoint was made with -seed 0");
  }
  const auto refusal = [&](const std::string& theirs, const std::string& ours) -> std::string {
    try {
      ray::DecodedState(ray::Encoded(ray::DecodedState(bytes_, identity_, film_), theirs), ours, film_);
      return "accepted";
    } catch (const ray::CheckpointError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal("version 1\n-fresnel \n-seed 1\n", "version 1\n-fresnel on\n-seed 2\n"),
            "the checkpoint was made without -fresnel");
  EXPECT_EQ(refusal("version 1\n-fresnel on\n", "version 1\n-fresnel \n"), "the checkpoint was made with -fresnel on");
  const ray::Film larger(24, 9, {0, 0, 24, 9}, ray::FilterKind::mitchell);
  EXPECT_THROW(ray::DecodedState(bytes_, identity_, larger), ray::CheckpointError);
}

/// The state of a render that is stopped at a tile, after that many passes that sampled every pixel.
ray::RenderState StateOfHello(const ray::RenderSettings& settings, int whole_passes, int tile) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  const auto accelerator = ray::FindAcceleratorKind("auto")->Make(stage.world, {});
  std::atomic<bool> stop = false;
  std::atomic<int> passes = 0, tiles = 0;
  ray::RenderState kept;
  ray::RenderMonitor monitor;
  monitor.stop = &stop;
  monitor.pass_done = [&](const R2::Image&, std::uint32_t) { ++passes; };
  monitor.tile_done = [&](const ray::RenderProgress&) {
    if (passes == whole_passes) stop = ++tiles == tile;
  };
  monitor.save = [&](const ray::RenderState& state) { kept = state; };
  ray::Render(stage.world, *accelerator, settings, monitor);
  return kept;
}

// Whoever can write a file can write its checksum: a block that asked for 4e9 samples was once given them.
TEST(Extremes, L9_ACheckpointWithNumbersThatNoRenderKeepsIsRefused) {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  using State = ray::RenderState;
  const std::function<void(State&)> edits[] = {
      [](State& s) { s.schedule.targets.samples[3] = 4'000'000'000; },
      [](State& s) { s.schedule.targets.samples[3] = 0; },
      [](State& s) { s.schedule.end = 4'000'000'000; },
      [](State& s) { s.schedule.end = 0; },
      [](State& s) {
        s.passes.push_back({1u << 31, 1, 1, {}});
      },
      [](State& s) { s.schedule.targets.places.assign(s.blocks.size(), 65); },
      [](State& s) { s.differences.squares.assign(s.blocks.size(), -1); },
      [](State& s) { s.blocks[0].first_samples.resize(1); },
      [](State& s) {
        s.passes.push_back({1, nan, 1, {}});
      },
      [](State& s) {
        s.passes.push_back({1, 1, -1, {}});
      },
      [](State& s) {
        s.passes.push_back(
            {1, 1, 1, ray::ErrorEstimate{.unit = static_cast<ray::ErrorUnit>(77), .worst_block_at = {}}});
      },
      [](State& s) { s.blocks[0].samples[0] = s.blocks[0].samples[1] = 1u << 31; },
      [](State& s) { s.blocks[0].samples[0] += 1; },
      [](State& s) { s.blocks[0].sums[0].Sums()[5].weight = nan; },
      [](State& s) { s.blocks[0].sums[0].Sums()[5].weight = std::numeric_limits<double>::infinity(); },
  };
  for (const ray::FilterKind filter : {ray::FilterKind::box, ray::FilterKind::mitchell})
    for (const bool by_error : {false, true}) {
      ray::RenderSettings settings = project::Sized(48);
      settings.tile_size = 8;
      settings.samples = 64;
      settings.threads = 1;
      settings.filter = filter;
      if (by_error) settings.budget.error = ray::ErrorTarget{0.1, ray::ErrorUnit::display};
      const State kept = StateOfHello(settings, by_error ? 4 : 1, 20);  // of 36 tiles
      const ray::Film film = ray::EmptyFilmOf(settings);
      ASSERT_NO_THROW(ray::CheckState(kept, film, settings));
      ASSERT_NE(kept.blocks.front().Samples(), kept.blocks.back().Samples());
      for (std::size_t i = 0; i < std::size(edits); ++i) {
        State edited = kept;
        edits[i](edited);
        EXPECT_THROW(ray::CheckState(edited, film, settings), ray::CheckpointError) << "edit " << i << by_error;
      }
    }
}

}  // namespace
