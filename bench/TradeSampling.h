#pragma once

#include "bench/TradeLab.h"
#include "tests/Named.h"

/// How fast the error falls: with samples, with the choice of directions and of lights, through filters.
namespace trade {

/// Seconds of CPU that a picture takes with each of two settings, which take turns so that a busy machine slows both;
/// medians. One thread, since waiting threads count as working.
inline std::array<double, 2> SecondsInTurns(const Site& site, std::array<ray::RenderSettings, 2> settings,
                                            int repeats) {
  std::array<std::vector<double>, 2> seconds;
  for (ray::RenderSettings& s : settings) s.threads = 1;
  for (int i = 0; i < repeats; ++i)
    for (std::size_t k = 0; k < 2; ++k) seconds[k].push_back(Lab::Take(site, settings[k]).cpu_seconds);
  return {Median(seconds[0]), Median(seconds[1])};
}

/// Error beside that of the random sampler in the same time, whose error falls with the root of the time.
inline void ErrorAtEqualTime(Lab& lab, Table& table) {
  struct Aim {
    const char* scene;
    double at_64, at_256;
  };
  for (const Aim& aim : {Aim{"box1", 1 / 3.5, 1 / 4.5}, Aim{"disc", 1 / 6.0, 1 / 9.0}, Aim{"light", 1 / 6.0, 1 / 9.0},
                         Aim{"dof", 1 / 2.0, 1 / 2.4}})
    for (const int samples : {64, 256}) {
      const int seeds = lab.Seeds(16);
      const double sobol = Root(Mean(lab.SquaredErrors(aim.scene, "sobol", samples, seeds)));
      const double random = Root(Mean(lab.SquaredErrors(aim.scene, "random", samples, seeds)));
      const Site& site = lab.At(aim.scene);
      std::array<ray::RenderSettings, 2> both{site.subject.settings, site.subject.settings};
      for (ray::RenderSettings& s : both) SetSamples(s, site.subject, samples);
      both[1].trace.sampler = ray::SamplerKind::random;
      const auto seconds = SecondsInTurns(site, both, lab.wishes().quick ? 3 : 7);
      const std::string what = std::string(aim.scene) + ", " + std::to_string(samples) + " samples: ";
      table.PrintError(what + "time of sobol / time of random", seconds[0] / seconds[1]);
      table.Add(what + "error / error of random in equal time", sobol / (random * std::sqrt(seconds[1] / seconds[0])),
                AtMost(samples == 64 ? aim.at_64 : aim.at_256));
    }
}

struct Slope {
  double slope = 0, deviation = 0;
};

/// The slope of log error over log samples, by least squares; its deviation by leaving out one seed after another.
inline Slope SlopeOf(const std::vector<int>& counts, const std::vector<std::vector<double>>& squares) {
  const auto fit = [&](std::size_t without) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      std::vector<double> kept = squares[i];
      if (without < kept.size()) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(without));
      const double x = std::log(counts[i]), y = 0.5 * std::log(Mean(kept));
      sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double n = static_cast<double>(counts.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
  };
  const std::size_t seeds = squares.front().size();
  const double all = fit(seeds);
  double sum = 0;
  for (std::size_t k = 0; k < seeds; ++k) sum += (fit(k) - all) * (fit(k) - all);
  return {all, std::sqrt(sum * static_cast<double>(seeds - 1) / static_cast<double>(seeds))};
}

/// Points spread evenly in the square do no better than -3/4 where an edge runs through it (penumbras of `light`,
/// pixels of `box1`), and up to -3/2 where nothing does.
inline void Slopes(Lab& lab, Table& table) {
  struct Aim {
    const char* scene;
    double most;
  };
  const std::vector<int> counts{16, 32, 64, 128, 256};
  const auto measure = [&](const char* scene, const char* sampler, int seeds) {
    std::vector<std::vector<double>> squares;
    for (const int n : counts) squares.push_back(lab.SquaredErrors(scene, sampler, n, seeds));
    for (auto& of_count : squares) of_count.resize(static_cast<std::size_t>(seeds));
    return SlopeOf(counts, squares);
  };
  for (const Aim& aim :
       {Aim{"box1", -0.74}, Aim{"dof", -0.63}, Aim{"pixel", -0.74}, Aim{"light", -0.9}, Aim{"disc", -0.9}}) {
    const Slope sobol = measure(aim.scene, "sobol", lab.Seeds(8));
    table.Add(std::string(aim.scene) + ": slope, sobol" + Line(" (+- %.3f)", sobol.deviation), sobol.slope,
              AtMost(aim.most));
    const Slope random = measure(aim.scene, "random", lab.Seeds(16));
    // Known no better than to its deviation, where few pixels hold the error.
    const double slack = std::max(0.02, 2 * random.deviation);
    table.Add(std::string(aim.scene) + ": slope, random" + Line(" (+- %.3f)", random.deviation), random.slope,
              {-0.5 - slack, -0.5 + slack});
  }
}

/// How many times smaller the error is than that of `plain`, whose error is taken to fall with the root of its rays.
inline double GainAtEqualRays(Lab& lab, const std::string& scene, const ray::RenderSettings& plain,
                              const ray::RenderSettings& better, int seeds) {
  std::array<std::vector<double>, 2> squares;
  std::array<double, 2> rays{};
  for (std::size_t k = 0; k < 2; ++k)
    for (int i = 0; i < seeds; ++i) {
      ray::RenderSettings settings = k == 0 ? plain : better;
      settings.seed = static_cast<std::uint64_t>(500 + i);
      const Shot shot = Lab::Take(lab.At(scene), settings);
      squares[k].push_back(lab.SquaredError(scene, shot.result.image));
      rays[k] += static_cast<double>(shot.result.rays.Total());
    }
  return Root(Mean(squares[0])) / Root(Mean(squares[1])) * std::sqrt(rays[0] / rays[1]);
}

inline void Sky(Lab& lab, Table& table) {
  ray::RenderSettings uniform = lab.At("sky").subject.settings;
  uniform.samples = 64;
  uniform.trace.strategy = ray::LightStrategy::uniform;
  uniform.trace.sampler = ray::SamplerKind::random;
  const auto gain = [&](const char* strategy, const char* sampler) {
    ray::RenderSettings better = uniform;
    better.trace.strategy = project::Named{strategy};
    better.trace.sampler = project::Named{sampler};
    return GainAtEqualRays(lab, "sky", uniform, better, lab.Seeds(12));
  };
  for (const char* strategy : {"bsdf", "light"})
    for (const char* sampler : {"random", "sobol"})
      table.PrintError(std::string(strategy) + ", " + sampler + ": gain over uniform random", gain(strategy, sampler));
  table.Add("mis, random: gain over uniform random", gain("mis", "random"), AtLeast(25));
  table.PrintError("mis, stratified: gain over uniform random", gain("mis", "stratified"));
  table.Add("mis, sobol: gain over uniform random", gain("mis", "sobol"), AtLeast(60));
}

inline void ManyLights(Lab& lab, Table& table) {
  for (const char* scene : {"lights64", "lights1024"})
    for (const char* sampler : {"random", "sobol"}) {
      ray::RenderSettings uniform = lab.At(scene).subject.settings;
      uniform.samples = 64;
      uniform.trace.sampler = project::Named{sampler};
      ray::RenderSettings by_importance = uniform;
      uniform.trace.strategy = ray::LightStrategy::uniform;
      table.Add(std::string(scene) + ", " + sampler + ": error, evenly / by importance",
                GainAtEqualRays(lab, scene, uniform, by_importance, lab.Seeds(6)), AtLeast(3.5));
    }
}

inline void Filters(Lab& lab, Table& table) {
  for (const char* scene : {"box1", "dof", "pixel", "flat"}) {
    const int seeds = lab.Seeds(6);
    const double box = Root(Mean(lab.SquaredErrors(scene, "sobol", 64, seeds)));
    table.PrintError(std::string(scene) + ", box: error", box);
    for (const char* filter : {"gaussian", "mitchell", "lanczos"})
      table.Add(std::string(scene) + ", " + filter + ": error / error with box",
                Root(Mean(lab.SquaredErrors(scene, "sobol", 64, seeds, filter))) / box, AtMost(1.1));
  }
}

}  // namespace trade
