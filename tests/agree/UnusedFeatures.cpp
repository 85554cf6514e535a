// Statements without an effect cost nothing: the same features, the same kernel and the same bits as without them.
// Otherwise "aperture 0" would make a scene slower, or noisier.

#include <gtest/gtest.h>

#include "source/render/SceneFeatures.h"
#include "tests/Named.h"
#include "tests/Project.h"

namespace {

ray::RenderSettings Small(const std::string& mode) {
  ray::RenderSettings settings = project::Sized(20, 16);
  settings.samples = 4;
  settings.mode = project::Named{mode};
  settings.trace.shadow_samples = 3;
  return settings;
}

void ExpectAlike(const project::Stage& stated, const ray::RenderSettings& stated_settings, const project::Stage& plain,
                 const ray::RenderSettings& plain_settings, const std::string& what) {
  const ray::SceneFeatures needs = ray::FeaturesOf(stated.world, stated_settings);
  const ray::SceneFeatures plain_needs = ray::FeaturesOf(plain.world, plain_settings);
  EXPECT_EQ(needs.Names(), plain_needs.Names()) << what;
  EXPECT_EQ(ray::KernelName(needs, stated_settings), ray::KernelName(plain_needs, plain_settings)) << what;
  EXPECT_TRUE(project::Render(stated, stated_settings).image == project::Render(plain, plain_settings).image) << what;
}

// Two spheres and a floor. `ball`: the material of one of the spheres from its kd on; `more`: further lines.
std::string Scene(const std::string& ball, const std::string& more, const std::string& light) {
  return "camera 0 1 6  0 -0.15 -1  0 1 0  0.4  0.01 100\n"
         "material 0 0 0  0.6 0.6 0.6  0 0 0  0 0 0  0 0 0  10 1 0\n"
         "material 0.1 0.1 0.1  " +
         ball + "\n" + light + "\n" + more +
         "sphere 1  -0.7 0.5 0  0.6\n"
         "sphere 0  0.8 0.4 0.3  0.5\n"
         "box 0  -4 -0.3 -4  4 0 4\n";
}

const std::string diffuse = "0.7 0.4 0.3  0 0 0  0 0 0  0 0 0  10 1 0";
const std::string area_light = "area_light 3 3 3  0 4 2  0 -1 -0.3  0.8  0 0 0.2";

struct Statement {
  const char* what;
  std::string stated, plain;
};

TEST(UnusedFeatures, StatementsWithoutEffectChangeNeitherKernelsNorBits) {
  const std::string plain = Scene(diffuse, "", area_light);
  const std::string point = Scene(diffuse, "", "point_light 3 3 3  0 4 2  0 0 0.2");
  const Statement statements[] = {
      {"an index of refraction where nothing is clear",
       Scene("0.7 0.4 0.3  0 0 0  0 0 0  0 0 0  10 1.5 0", "", area_light), plain},
      {"an exponent where nothing is specular", Scene("0.7 0.4 0.3  0 0 0  0 0 0  0 0 0  80 1 0", "", area_light),
       plain},
      {"a glass that nothing is made of",
       Scene(diffuse, "material 0 0 0  0 0 0  0.1 0.1 0.1  0.9 0.9 0.9  0 0 0  50 1.5 0\n", area_light), plain},
      {"a black point light", Scene(diffuse, "point_light 0 0 0  1 5 1  1 0 0\n", area_light), plain},
      {"a black area light", Scene(diffuse, "area_light 0 0 0  1 5 1  0 -1 0  2  1 0 0\n", area_light), plain},
      {"a black background", Scene(diffuse, "background 0 0 0\n", area_light), plain},
      {"a black area light beside a point light",
       Scene(diffuse, "area_light 0 0 0  1 5 1  0 -1 0  2  1 0 0\n", "point_light 3 3 3  0 4 2  0 0 0.2"), point},
      {"groups that turn nothing", Scene(diffuse, "begin -1  1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\nend\n", area_light),
       plain},
      {"a motion of an empty group", Scene(diffuse, "begin -1 motion 1 0 0 end\n", area_light), plain},
      {"a motion of groups that are all empty",
       Scene(diffuse, "begin -1 translate 1 2 3 motion 0 1 0 begin -1 begin 1 scale 2 end end end\n", area_light),
       plain},
      {"a motion of what cannot be seen",
       Scene(diffuse, "begin -1 scale 0 motion 1 0 0 sphere 0 0 0 0 1 end\n", area_light), plain},
  };
  for (const Statement& s : statements) {
    const project::Stage stated(project::FromText(s.stated)), without(project::FromText(s.plain));
    for (const char* mode : {"whitted", "path"})
      ExpectAlike(stated, Small(mode), without, Small(mode), std::string(s.what) + ", " + mode);
  }
}

TEST(UnusedFeatures, ABlackEnvironmentIsNone) {
  const project::Stage plain(project::FromText(Scene(diffuse, "", area_light)));
  ray::Scene scene = project::FromText(Scene(diffuse, "", area_light));
  scene.environment = std::make_shared<const ray::Environment>(R2::Image(8, 4));
  const project::Stage stated(std::move(scene));
  for (const char* mode : {"whitted", "path"}) {
    ExpectAlike(stated, Small(mode), plain, Small(mode), mode);
    EXPECT_EQ(project::Render(stated, Small(mode)).rays, project::Render(plain, Small(mode)).rays) << mode;
  }
}

TEST(UnusedFeatures, AnAreaLightWithoutAreaTakesOneShadowRay) {
  const project::Stage stage(project::FromText(Scene(diffuse, "", "area_light 3 3 3  0 4 2  0 -1 -0.3  0  0 0 0.2")));
  const auto needs = ray::FeaturesOf(stage.world, Small("whitted"));
  EXPECT_TRUE(needs.lights);
  EXPECT_FALSE(needs.area_lights);
  for (const char* mode : {"whitted", "path"}) {
    ray::RenderSettings many = Small(mode);
    many.trace.shadow_samples = 64;
    ExpectAlike(stage, many, stage, Small(mode), mode);
    EXPECT_EQ(project::Render(stage, many).rays, project::Render(stage, Small(mode)).rays) << mode;
  }
}

// It once took 16 places at each point and discarded them all.
TEST(UnusedFeatures, ALightThatShinesAwayAddsNeitherRaysNorLight) {
  const project::Stage plain(project::FromText(Scene(diffuse, "", area_light)));
  for (const char* dark : {"area_light 1 1 1  3 -3 2  0 -1 0  .3  1 0 0", "area_light 1 1 1  0 9 0  .1 1 0  2  1 0 0",
                           "sphere_light 1 1 1  0 0 0  100  1 0 0"}) {
    const project::Stage stated(project::FromText(Scene(diffuse, "", area_light + "\n" + dark)));
    const auto image = project::Render(stated, Small("whitted")), without = project::Render(plain, Small("whitted"));
    EXPECT_TRUE(image.image == without.image) << dark;
    EXPECT_EQ(image.rays, without.rays) << dark;
  }
}

TEST(UnusedFeatures, OptionsWithoutEffectChangeNeitherKernelsNorBits) {
  struct Change {
    const char* what;
    void (*make)(ray::RenderSettings&);
  };
  const Change changes[] = {
      {"aperture 0 with a focus",
       [](ray::RenderSettings& s) {
         s.camera.aperture = 0;
         s.camera.focus = 5;
       }},
      {"motion 0 0 -0",
       [](ray::RenderSettings& s) {
         s.camera.motion = {0, 0, -0.0};
       }},
      {"fresnel where nothing is clear", [](ray::RenderSettings& s) { s.trace.fresnel = true; }},
      {"glossy where nothing is specular", [](ray::RenderSettings& s) { s.trace.glossy = true; }},
      {"a confidence without an error to stop at", [](ray::RenderSettings& s) { s.budget.confidence = 0.99; }},
      {"adaptive without an error to stop at", [](ray::RenderSettings& s) { s.budget.adaptive = ray::Adaptive::tile; }},
  };
  const project::Stage stage(project::FromText(Scene(diffuse, "", area_light)));
  for (const Change& change : changes)
    for (const char* mode : {"whitted", "path"}) {
      ray::RenderSettings settings = Small(mode);
      change.make(settings);
      ExpectAlike(stage, settings, stage, Small(mode), std::string(change.what) + ", " + mode);
    }
}

// The reverse, so that the tests above cannot pass because nothing is ever needed.
TEST(UnusedFeatures, OnesWithAnEffectAreRequiredAndVisible) {
  const project::Stage stage(project::FromText(Scene(diffuse, "", area_light)));
  const ray::RenderSettings plain = Small("whitted");
  ray::RenderSettings lens = plain, motion = plain;
  lens.camera.aperture = 0.2;
  lens.camera.focus = 5;
  motion.camera.motion = {0.5, 0, 0};
  EXPECT_TRUE(ray::FeaturesOf(stage.world, lens).lens);
  EXPECT_TRUE(ray::FeaturesOf(stage.world, motion).motion);
  for (const ray::RenderSettings& settings : {lens, motion}) {
    EXPECT_NE(ray::KernelName(ray::FeaturesOf(stage.world, settings), settings),
              ray::KernelName(ray::FeaturesOf(stage.world, plain), plain));
    EXPECT_FALSE(project::Render(stage, settings).image == project::Render(stage, plain).image);
  }
}

}  // namespace
