// I4: what more samples are worth; G5: any number of them has the right mean.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/Draw.h"
#include "tests/Named.h"
#include "tests/extremes/KnownScenes.h"

namespace statistics {
namespace {

using ray::RenderSettings;

/// Half of a disc light behind a straight edge: the edge jumps, and nothing else is to be learned.
project::Stage HalfOfADisc() {
  return StageOf("camera 3 1 0  -3 -1 0  0 1 0  1e-7  0.01 100" + Material(0.5, 0, 0, 0) +
                 "box 0 -40 -1 -40 40 0 40 area_light 1 1 1  0 2 0  0 -1 0  1  1 0 0 tri 0 0 1 -40  0 1 40  -40 1 0");
}

/// kd (h/a)^2 ln(1 + (a/h)^2) of the whole disc, a = 1, h = 2.
const double seen_of_half_a_disc = 0.5 * 4 * std::log(1.25) / 2;

/// The root mean square error of pixels after each number of samples, over some seeds.
std::vector<double> ErrorsAfter(const std::vector<double>& counts, const char* sampler) {
  const project::Stage stage = HalfOfADisc();
  std::vector<double> errors;
  for (const double count : counts) {
    double squares = 0, pixels = 0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(Count(2, 4)); ++seed) {
      RenderSettings settings = Whitted(16, static_cast<int>(count));
      settings.seed = seed;
      settings.trace.sampler = project::Named{sampler};
      const auto image = project::Render(stage, settings).image;
      for (const float channel : image.Channels()) {
        squares += (channel - seen_of_half_a_disc) * (channel - seen_of_half_a_disc);
        ++pixels;
      }
    }
    errors.push_back(std::sqrt(squares / pixels));
  }
  return errors;
}

TEST(Extremes, I4_ErrorsFallAsTheRootOfTheSamplesOrFaster) {
  std::vector<double> counts;
  for (double count = 16; count <= Count(4096, 65536); count *= 2) counts.push_back(count);
  for (const char* sampler : ray::sampler_names) {
    const auto errors = ErrorsAfter(counts, sampler);
    const double slope = statistics::Slope(counts, errors);
    if (sampler == std::string("random")) {
      EXPECT_NEAR(slope, -0.5, 0.03);
    } else {
      EXPECT_LT(slope, -0.65) << sampler;  // a jump in two dimensions allows 3/4
    }
    std::printf("slope of %s: %.3f\n", sampler, slope);
  }
}

TEST(Extremes, G5_StrataOfAnyNumberOfSamplesHaveTheRightMean) {
  const project::Stage stage = HalfOfADisc();
  for (const char* mode : {"whitted", "path"})
    for (const int samples : {1, 2, 3, 5, 7, 13, 50}) {
      RenderSettings settings = Whitted(64, samples);
      settings.mode = project::Named{mode};
      settings.trace.max_depth = 0;
      settings.trace.sampler = ray::SamplerKind::stratified;
      const Mean m = statistics::MeanOverPixels(project::Render(stage, settings).image);
      EXPECT_LT(std::abs(Deviations(m, seen_of_half_a_disc, 1e-6)), 4) << samples << " samples in " << mode;
      EXPECT_LT(m.deviation, 0.02 * seen_of_half_a_disc) << samples << " samples in " << mode;
    }
}

}  // namespace
}  // namespace statistics
