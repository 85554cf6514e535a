// One-sided surfaces: they exist for rays that arrive at their front, and lamps shine forward.

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "tests/Accelerators.h"
#include "tests/Project.h"

namespace ray {
namespace {

Scene RandomScene(std::uint64_t seed, bool one_sided) {
  Draw draw(seed);
  Scene scene = accelerators::RandomScene(draw, 1);
  scene.materials[0].one_sided = one_sided;
  return scene;
}

/// Returns the first crossing that arrives at a front, among all with two-sided surfaces, found without any structure.
std::optional<WorldHit> FirstFront(const World& both_sides, const R3::Ray& ray) {
  std::optional<WorldHit> first;
  for (std::uint32_t i = 0; i < both_sides.Instances().size(); ++i) {
    const Instance& instance = both_sides.Instances()[i];
    for (int element = 0; element < instance.shape->Elements(); ++element) {
      R3::Ray local = both_sides.Back(instance.frame, ray);
      while (const auto hit = instance.shape->Intersect(local, element)) {
        const WorldHit crossing{*hit, i, element};
        if (Dot(both_sides.At(ray, crossing).normal, ray.direction) < 0) {
          if (!first || crossing.t < first->t) first = crossing;
          break;
        }
        local.t_min = hit->t;
      }
    }
  }
  return first;
}

TEST(OneSided, TheHitIsTheFirstCrossingOfAFront) {
  const auto none = FindAcceleratorKind("none");
  int backs = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const project::Stage both(RandomScene(seed, false)), fronts(RandomScene(seed, true));
    const auto of_both = none->Make(both.world, {}), of_fronts = none->Make(fronts.world, {});
    Workspace workspace;
    Draw draw(seed);
    for (int i = 0; i < 200; ++i) {
      const R3::Box& box = both.scene->root.bounds;
      const R3::Point origin = box.Center() + draw.Between(0.1, 2) * box.Radius() * draw.Direction();
      const R3::Ray ray{origin, box.Center() + 0.5 * box.Radius() * draw.Direction() - origin};
      const auto expected = FirstFront(both.world, ray), hit = of_fronts->Intersect(ray, workspace),
                 with_backs = of_both->Intersect(ray, workspace);
      ASSERT_EQ(hit.has_value(), expected.has_value()) << seed << ' ' << oracle::Hex(ray);
      if (hit) {
        EXPECT_NEAR(hit->t, expected->t, 1e-9 * expected->t) << seed << " " << oracle::Hex(ray);
      }
      backs += with_backs && (!hit || hit->t > with_backs->t);
    }
  }
  EXPECT_GT(backs, 200);  // otherwise nothing was tested
}

TEST(OneSided, EveryAcceleratorFindsTheSame) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const project::Stage stage(RandomScene(seed, true));
    Draw draw(seed);
    accelerators::Compare(stage.world, accelerators::RaysAt(stage.world, draw, 40), accelerators::EveryWay());
  }
}

TEST(OneSided, AnOptionMakesAllButGlassOneSided) {
  const std::string file = testing::TempDir() + "one_sided_" + std::to_string(getpid()) + ".scn";
  std::ofstream(file) << "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0 material 0 0 0 0 0 0 0 0 0 1 1 1 0 0 0 1 1.5 0";
  ParseOptions options;
  options.one_sided = true;
  const Scene scene = Parse(file, options).scene;
  std::filesystem::remove(file);
  EXPECT_TRUE(scene.materials.at(1).one_sided);
  EXPECT_FALSE(scene.materials.at(2).one_sided);
}

/// Two floors, above and below a lamp whose front looks down.
R2::Image LampBetweenFloors(const std::string& lamp, const RenderSettings& settings, bool above) {
  return project::Render(
             project::Stage(project::FromText(
                 "background 0 0 0 ambient 0 0 0 point_light 0 0 0 0 9 0 1 0 0 "
                 "material 0 0 0 .8 .8 .8 0 0 0 0 0 0 0 0 0 1 1 0 material 0 0 0 0 0 0 0 0 0 0 0 0 4 4 4 1 1 0 "
                 "one_sided 1 " +
                 lamp +
                 (above ? " camera look_at 0 4 6 0 3 0 0 1 0 20 quad 0 -2 3 -2 -2 3 2 2 3 2 2 3 -2 "
                        : " camera look_at 0 2 6 0 -2 0 0 1 0 20 quad 0 -2 -2 -2 -2 -2 2 2 -2 2 2 -2 -2 "))),
             settings)
      .image;
}

double Mean(const R2::Image& image) {
  double sum = 0;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) sum += Luminance(image.At(x, y));
  return sum / (image.Width() * image.Height());
}

TEST(OneSided, ALampShinesForwardEquallyByEveryStrategy) {
  RenderSettings settings = project::Sized(16);
  settings.samples = 256;
  settings.trace.max_depth = 1;
  settings.trace.emissive_solids_light = true;
  for (const char* lamp : {"tri 1 -1 0 -1 1 0 -1 0 0 1", "quad 1 -1 0 -1 1 0 -1 1 0 1 -1 0 1", "disc 1 0 0 0 0 -1 0 1",
                           "begin 1 rotate 180 1 0 0 disc -1 0 0 0 0 1 0 1 end"}) {
    settings.mode = RenderMode::whitted;
    EXPECT_GT(Mean(LampBetweenFloors(lamp, settings, false)), 0.1) << lamp;
    EXPECT_EQ(Mean(LampBetweenFloors(lamp, settings, true)), 0) << lamp;
    settings.mode = RenderMode::path;
    settings.trace.strategy = LightStrategy::mis;
    const double mean = Mean(LampBetweenFloors(lamp, settings, false));
    for (const LightStrategy strategy : {LightStrategy::mis, LightStrategy::light, LightStrategy::bsdf}) {
      settings.trace.strategy = strategy;
      EXPECT_NEAR(Mean(LampBetweenFloors(lamp, settings, false)), mean, 0.03 * mean) << lamp << int(strategy);
      EXPECT_EQ(Mean(LampBetweenFloors(lamp, settings, true)), 0) << lamp << int(strategy);
    }
  }
}

TEST(OneSided, AFaceShadowsOnlyPointsThatSeeItsFront) {
  const auto floor_under = [](const std::string& roof) {
    const R2::Image image =
        project::Render(project::Stage(project::FromText(
                            "camera look_at 0 1 3 0 0 0 0 1 0 5 dir_light 1 1 1 0 -1 0 ambient 0 0 0 "
                            "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0 material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0 "
                            "plane 0 0 0 0 0 1 0 " +
                            roof)),
                        project::Sized(9))
            .image;
    return image.At(4, 4).g;
  };
  const std::string front_up = "quad 1 -1 2 -1 -1 2 1 1 2 1 1 2 -1", front_down = "quad 1 -1 2 -1 1 2 -1 1 2 1 -1 2 1";
  EXPECT_EQ(floor_under(front_up), 0);
  EXPECT_GT(floor_under("one_sided 1 " + front_up), 0.9);
  EXPECT_EQ(floor_under("one_sided 1 " + front_down), 0);
}

}  // namespace
}  // namespace ray
