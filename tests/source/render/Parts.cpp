// An image rendered in parts is the image rendered at once, to the last bit.
#include "source/render/Parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/text/Words.h"
#include "tests/Project.h"

namespace ray {
namespace {

const char* const identity = "test";

/// A scene and options as they are typed.
struct Case {
  const char *scene, *words;
};

const Case cases[] = {
    {"hello", ""},
    {"hello", "-samples 5 -seed 7"},
    {"hello", "-samples 8 -mode path -crop 5 3 31 27"},
    {"area_light", "-samples 4 -mode path"},
    {"area_light", "-samples 4 -sampler stratified -shadow_samples 3"},
    {"area_light", "-samples 32 -mode path -denoise"},
    {"area_light", "-samples 64 -mode path -error 9"},
    {"area_light", "-mode path -error 5 -adaptive off"},
    {"area_light", "-samples 64 -mode path -error 3% -filter lanczos -denoise"},
    {"many_lights", "-samples 6 -mode path -filter lanczos"},
    {"lens", "-samples 9 -filter mitchell"},
    {"lens", "-samples 4 -aperture 0.2 -focus 4 -mode path -clamp samples"},
    {"motion", "-samples 7 -filter gaussian -motion 0.1 0 0"},
    {"camera_motion", "-samples 16 -sampler grid"},
    {"glass", "-samples 3 -fresnel -max_depth 6 -mode path -roulette on"},
    {"csg", "-samples 4 -adaptive neighbors"},
    {"environment", "-samples 4 -mode path -strategy light"},
    {"bezier", "-samples 2 -outline 1.5 -mode toon"},
    {"depth", "-mode zbuffer"},
    {"emission", "-samples 70 -mode path"},
    {"hierarchy", "-samples 4 -mode heat"},
    {"implicit", "-samples 4 -filter mitchell -glossy"},
    {"indirect", "-samples 6 -mode path -share on -crop 5 3 31 27 -filter mitchell"},
    {"indirect", "-samples 5 -mode path -share on -clamp samples"},
    {"indirect", "-samples 64 -mode path -share on -error 9 -denoise"},
};

RenderSettings SettingsOf(const Scene& scene, const std::string& more) {
  std::vector<std::string> words{"a.scn", "b.pfm", "-width", "40", "-height", "30"};
  for (const std::string& word : SplitWords(more)) words.push_back(word);
  RenderSettings settings = WithSettingsOf(scene, ReadCommandLine(Program::raypro, words)).render;
  settings.shares_light = settings.share == Sharing::on;
  return settings;
}

/// Several machines, each with its own instruction set, that render one image.
class Machines {
 public:
  Machines(const project::Stage& stage, const RenderSettings& settings, int parts)
      : stage_(stage), settings_(settings), of_(parts), film_(EmptyFilmOf(settings)) {
    for (const std::string& name : InstructionSets()) {
      AcceleratorSettings how{"bvh"};
      how.instruction_set = name;
      accelerators_.push_back(FindAcceleratorKind("bvh")->Make(stage.world, how));
    }
  }

  /// Renders all rounds, and returns the assembled image.
  RenderResult Render() {
    RenderState plan = FirstRound(settings_, film_);
    while (true) {
      RenderRound(plan);
      RenderState joined = Joined(plan);
      EXPECT_EQ(MissingParts(joined, settings_, parts_), std::vector<int>{});
      if (IsOfOneRound(settings_, film_)) return Assembled(std::move(joined));
      auto next = NextRound(stage_.world, *accelerators_[0], settings_, RenderState(joined));
      if (!next) return Assembled(std::move(joined));
      plan = WithoutSamples(std::move(*next), film_);
    }
  }

 private:
  /// Renders a round of every part, in random order.
  void RenderRound(const RenderState& plan) {
    std::vector<int> order;
    for (int i = 1; i <= of_; ++i) order.push_back(i);
    std::ranges::shuffle(order, random_);
    for (const int index : order) RenderOne(plan, {index, of_});
  }

  void RenderOne(const RenderState& plan, const ImagePart& part) {
    RenderSettings settings = settings_;
    settings.part = part;
    settings.threads = 1 + part.index % 2;
    RenderMonitor monitor;
    monitor.resume = [&](const Film& film) {
      RenderState state = plan;
      if (const auto earlier = files_.find(part.index); earlier != files_.end())
        Join(state, DecodedState(earlier->second, identity, film), part.index);
      return state;
    };
    monitor.save = [&](const RenderState& state) {
      files_[part.index] = Encoded(ForPartFile(RenderState(state)), identity);
    };
    const auto& accelerator = accelerators_[static_cast<std::size_t>(part.index) % accelerators_.size()];
    EXPECT_TRUE(RenderPart(stage_.world, *accelerator, settings, monitor));
  }

  void Join(RenderState& whole, RenderState&& part, int index) const {
    whole.rays += part.rays;
    TakeBlocks(whole, std::move(part), index, parts_);
  }

  RenderState Joined(const RenderState& plan) const {
    RenderState state = plan;
    for (const auto& [index, bytes] : files_) {
      RenderState part = DecodedState(bytes, identity, film_);
      CheckPart(part, index, parts_);
      CheckState(part, film_, settings_);
      Join(state, std::move(part), index);
    }
    return state;
  }

  RenderResult Assembled(RenderState&& joined) const {
    RenderMonitor monitor;
    monitor.resume = [&](const Film&) { return std::move(joined); };
    return ray::Render(stage_.world, *accelerators_.back(), settings_, monitor);
  }

  const project::Stage& stage_;
  const RenderSettings& settings_;
  const int of_;
  const Film film_;
  const std::vector<int> parts_ = PartsOfBlocks(film_, of_);
  std::vector<std::unique_ptr<const Accelerator>> accelerators_;
  std::map<int, std::vector<unsigned char>> files_;
  std::minstd_rand random_{static_cast<unsigned>(of_)};
};

std::vector<std::uint64_t> RaysOf(const RenderResult& result) {
  std::vector<std::uint64_t> rays{result.rays.cut, result.rays.throughput_cut, result.rays.caustics};
  for (const RayCounts::Kind& kind : result.rays.kinds) rays.push_back(kind.rays);
  return rays;
}

void ExpectSame(const RenderResult& whole, const RenderResult& assembled) {
  EXPECT_TRUE(whole.image == assembled.image);
  EXPECT_EQ(RaysOf(whole), RaysOf(assembled));
  EXPECT_EQ(whole.block_samples, assembled.block_samples);
  EXPECT_EQ(whole.stop, assembled.stop);
  EXPECT_EQ(whole.share_cut, assembled.share_cut);
  ASSERT_EQ(whole.error.has_value(), assembled.error.has_value());
  if (!whole.error) return;
  EXPECT_EQ(whole.error->estimate, assembled.error->estimate);
  EXPECT_EQ(whole.error->low, assembled.error->low);
  EXPECT_EQ(whole.error->high, assembled.error->high);
  EXPECT_EQ(whole.error->freedom, assembled.error->freedom);
}

TEST(Parts, InAnyNumberAndOrderMakeTheSameImage) {
  for (const auto& [name, words] : cases) {
    const project::Stage stage(project::Root() / "scenes" / (std::string(name) + ".scn"));
    const RenderSettings settings = SettingsOf(*stage.scene, words);
    const RenderResult whole = project::Render(stage, settings, {"bvh"});
    for (const int n : {1, 2, 5, 64}) {
      SCOPED_TRACE(std::string(name) + " " + words + ", parts: " + std::to_string(n));
      ExpectSame(whole, Machines(stage, settings, n).Render());
    }
  }
}

Film FilmOf(int width, int height) { return Film(width, height, {0, 0, width, height}, FilterKind::box); }

TEST(Parts, HaveEveryBlockOnceAndAsManyEach) {
  for (const auto& [width, height] : {std::pair{8, 8}, {272, 272}, {640, 480}, {1000, 17}, {40, 30}}) {
    const Film film = FilmOf(width, height);
    for (const int of : {1, 2, 3, 7, 12, 64, 1000}) {
      std::vector<int> count(static_cast<std::size_t>(of), 0);
      for (const int part : PartsOfBlocks(film, of)) ++count.at(static_cast<std::size_t>(part - 1));
      const auto [least, most] = std::ranges::minmax(count);
      EXPECT_LE(most - least, 1) << width << "x" << height << " in " << of;
    }
  }
}

// Expensive blocks are close together: a part with many neighbors would take far longer than others.
TEST(Parts, OfASquareAnywhereEachHasAboutItsShare) {
  const Film film = FilmOf(640, 480);
  for (const int of : {2, 4, 8, 16}) {
    const std::vector<int> parts = PartsOfBlocks(film, of);
    constexpr int side = 16;  // blocks
    for (int row = 0; row + side <= 60; row += 11)
      for (int column = 0; column + side <= film.Columns(); column += 13) {
        std::map<int, int> count;
        for (int i = 0; i < side * side; ++i)
          ++count[parts[static_cast<std::size_t>((row + i / side) * film.Columns() + column + i % side)]];
        for (int part = 1; part <= of; ++part)
          EXPECT_NEAR(count[part], side * side / of, 0.3 * side * side / of + 2)
              << of << " at " << row << "," << column;
      }
  }
}

RenderState StateOf(const project::Stage& stage, RenderSettings settings, const ImagePart& part) {
  settings.part = part;
  RenderState kept;
  RenderMonitor monitor;
  monitor.resume = [&](const Film& film) { return FirstRound(settings, film); };
  monitor.save = [&](const RenderState& state) { kept = state; };
  const auto accelerator = FindAcceleratorKind("bvh")->Make(stage.world, {});
  RenderPart(stage.world, *accelerator, settings, monitor);
  return kept;
}

TEST(Parts, WithForeignBlocksOrDifferingSumsAreDetected) {
  const project::Stage stage(project::Root() / "scenes" / "hello.scn");
  RenderSettings settings = SettingsOf(*stage.scene, "-samples 4");
  const Film film = EmptyFilmOf(settings);
  RenderState state = StateOf(stage, settings, {2, 3});
  EXPECT_NO_THROW(CheckPart(state, 2, PartsOfBlocks(film, 3)));
  EXPECT_THROW(CheckPart(state, 1, PartsOfBlocks(film, 3)), CheckpointError);
  EXPECT_THROW(CheckPart(state, 2, PartsOfBlocks(film, 4)), CheckpointError);
  RenderState other = state;
  EXPECT_TRUE(Agree(state, other));
  for (Film::Block& block : other.blocks)
    if (block.Samples() > 0) {
      block.sums[1].Sums()[3].color.g = std::nextafter(block.sums[1].Sums()[3].color.g, 2);
      break;
    }
  EXPECT_FALSE(Agree(state, other));
}

TEST(Parts, OfAnImageAreTheSameBytesHoweverManyThreads) {
  const project::Stage stage(project::Root() / "scenes" / "area_light.scn");
  RenderSettings settings = SettingsOf(*stage.scene, "-samples 4 -mode path");
  settings.threads = 1;
  const auto first = Encoded(ForPartFile(StateOf(stage, settings, {1, 3})), identity);
  settings.threads = 2;
  EXPECT_TRUE(first == Encoded(ForPartFile(StateOf(stage, settings, {1, 3})), identity));
}

}  // namespace
}  // namespace ray
