#pragma once

#include "bench/TradeSampling.h"
#include "source/film/Film.h"
#include "source/film/error/ImageError.h"
#include "tests/Named.h"

/// What a picture says of its own error, what it does about it, and what that costs.
namespace trade {

// Intervals come from the spread between blocks of 8x8 pixels, so a picture must have many: 144.
inline const std::string larger = "@96";
inline constexpr double unreachable = 1e-9;  // as an error target: two streams to the last sample

inline ray::ErrorMeasure MeasureOf(ray::ErrorUnit unit) { return {.unit = unit}; }

inline double TrueError(Lab& lab, const std::string& scene, const R2::Image& picture, ray::ErrorUnit unit) {
  const References& r = lab.ReferencesOf(scene);
  return ray::TrueError(picture, r[0], &r[1], MeasureOf(unit));
}

/// The settings of a render of that many samples in two streams.
inline ray::RenderSettings InTwoStreams(ray::RenderSettings settings, int samples,
                                        ray::ErrorUnit unit = ray::ErrorUnit::linear) {
  settings.samples = samples;
  settings.budget.error = ray::ErrorTarget{unreachable, unit};
  settings.budget.adaptive = ray::Adaptive::off;
  return settings;
}

inline double Share(int part, int all) {
  return all > 0 ? static_cast<double>(part) / all : std::numeric_limits<double>::quiet_NaN();
}

/// Claimed errors of single pictures beside their true ones.
inline void Claims(Lab& lab, Table& table) {
  const bool quick = lab.wishes().quick;
  const std::vector<std::string> scenes =
      lab.Scenes({"box1", "box5", "dof", "pixel", "disc", "sky", "flat", "depth", "lights64"});
  const std::vector<int> counts = quick ? std::vector<int>{16, 64} : std::vector<int>{16, 32, 64, 256};
  auto rows = table.Rows("unit,scene,sampler,samples,claimed,low,high,true");
  for (const auto unit : {ray::ErrorUnit::display, ray::ErrorUnit::linear}) {
    const std::string in = std::string("in ") + ray::ErrorUnitName(unit);
    int all = 0, close = 0, inside = 0;
    std::vector<double> ratios;
    for (const std::string& name : scenes) {
      const std::string scene = name + larger;
      std::vector<double> of_scene;
      for (const char* sampler : ray::sampler_names)
        for (const int samples : counts) {
          ray::RenderSettings settings = InTwoStreams(lab.At(scene).subject.settings, samples, unit);
          settings.trace.sampler = project::Named{sampler};
          settings.seed = static_cast<std::uint64_t>(7000 + all);
          settings.budget.confidence = 0.99;
          const ray::RenderResult result = Lab::Take(lab.At(scene), settings).result;
          const double truth = TrueError(lab, scene, result.image, unit);
          const ray::ErrorEstimate& e = *result.error;
          rows << ray::ErrorUnitName(unit) << ',' << scene << ',' << sampler << ',' << samples << ',' << e.estimate
               << ',' << e.low << ',' << e.high << ',' << truth << std::endl;
          const double ratio = e.estimate / truth;
          of_scene.push_back(ratio);
          ++all;
          close += ratio >= 0.9 && ratio <= 1.1;
          inside += truth >= e.low && truth <= e.high;
        }
      table.PrintError(in + ", " + scene + ": claimed / true, median", Median(of_scene));
      table.PrintError(in + ", " + scene + ": claimed / true, least", Quantile(of_scene, 0));
      table.PrintError(in + ", " + scene + ": claimed / true, most", Quantile(of_scene, 1));
      ratios.insert(ratios.end(), of_scene.begin(), of_scene.end());
    }
    table.PrintError(in + ": renders", all);
    table.PrintError(in + ": claimed / true, median", Median(ratios));
    table.Add(in + ": share with claimed / true in 0.9 .. 1.1", Share(close, all), AtLeast(0.9));
    table.Add(in + ": share with the truth in the 99 % interval", Share(inside, all), AtLeast(0.95));
  }
}

/// Renders that stop by their error. Those that the first pass satisfied could not have stopped earlier, so that they
/// count for nothing but the bound.
inline void Targets(Lab& lab, Table& table) {
  const std::vector<std::string> scenes = lab.Scenes({"box1", "dof", "pixel", "disc", "sky", "flat", "depth"});
  auto rows = table.Rows("adaptive,scene,target,seed,samples,claimed,high,true");
  int bounds = 0, broken = 0;
  for (const char* adaptive : {"auto", "off"}) {
    int all = 0, reached = 0, beyond_first = 0, thrifty = 0;
    std::vector<double> shares;
    for (const std::string& name : scenes)
      for (const double target : {4.0, 2.0, 1.0})
        for (int seed = 0; seed < lab.Seeds(4); ++seed) {
          const std::string scene = name + larger;
          ray::RenderSettings settings = lab.At(scene).subject.settings;
          settings.budget.error = ray::ErrorTarget{target, ray::ErrorUnit::display};
          settings.budget.adaptive = project::Named{adaptive};
          settings.seed = static_cast<std::uint64_t>(8000 + all);
          const ray::RenderResult result = Lab::Take(lab.At(scene), settings).result;
          const double truth = TrueError(lab, scene, result.image, ray::ErrorUnit::display);
          rows << adaptive << ',' << scene << ',' << target << ',' << settings.seed << ',' << result.samples.mean << ','
               << result.error->estimate << ',' << result.error->high << ',' << truth << std::endl;
          ++all;
          ++bounds;
          reached += truth <= target;
          broken += truth > result.error->high;
          if (result.passes.size() < 2) continue;
          ++beyond_first;
          thrifty += truth >= target / 1.6;
          shares.push_back(truth / target);
        }
    const std::string what = std::string("adaptive ") + adaptive;
    table.PrintError(what + ": renders", all);
    table.Add(what + ": share with true error <= target", Share(reached, all), AtLeast(0.95));
    table.PrintError(what + ": renders that went beyond the first pass", beyond_first);
    table.PrintError(what + ": their true error / target, median", Median(shares));
    table.PrintError(what + ": their true error / target, tenth from below", Quantile(shares, 0.1));
    table.Add(what + ": share of them with true error >= target / 1.6", Share(thrifty, beyond_first), AtLeast(0.95));
  }
  table.Add("share with true error above the claimed upper bound", Share(broken, bounds), AtMost(0.02));
}

struct Adaptive {
  std::vector<double> squares, squares_of_uniform, means;
  double samples = 0;
};

/// Pictures whose tiles stop by themselves at `target`, and such of as many samples that do not.
inline Adaptive TakeAdaptive(Lab& lab, const std::string& scene, const ray::ErrorTarget& target, int seeds) {
  const auto square = [&](const R2::Image& picture) {
    const References& r = lab.ReferencesOf(scene);
    if (target.unit == ray::ErrorUnit::linear) return R2::ProductMse(picture, r[0], r[1]);
    const auto shown = [](const R2::Image& image) { return R2::Displayed(image, R2::Display::straight); };
    return R2::ProductMse(shown(picture), shown(r[0]), shown(r[1]));
  };
  Adaptive a;
  for (int seed = 0; seed < seeds; ++seed) {
    ray::RenderSettings settings = lab.At(scene).subject.settings;
    settings.seed = static_cast<std::uint64_t>(6000 + seed);
    settings.budget.error = target;
    settings.budget.adaptive = ray::Adaptive::tile;
    const ray::RenderResult tiles = Lab::Take(lab.At(scene), settings).result;
    a.squares.push_back(square(tiles.image));
    a.means.push_back(ray::MeanOf(tiles.image));
    a.samples += tiles.samples.mean / seeds;
    settings = InTwoStreams(settings, std::max(2, 2 * static_cast<int>(std::lround(tiles.samples.mean / 2))));
    a.squares_of_uniform.push_back(square(Lab::Take(lab.At(scene), settings).result.image));
  }
  return a;
}

inline void AdaptiveTiles(Lab& lab, Table& table) {
  const std::vector<std::string> scenes = lab.Scenes({"box1", "box5", "dof", "pixel", "disc", "sky", "flat", "depth"});
  for (const std::string& scene : scenes)
    for (const auto unit : {ray::ErrorUnit::linear, ray::ErrorUnit::display}) {
      // About what 64 samples give without adaptivity.
      const ray::RenderSettings even = InTwoStreams(lab.At(scene).subject.settings, 64, unit);
      const double target = TrueError(lab, scene, Lab::Take(lab.At(scene), even).result.image, unit);
      const Adaptive a = TakeAdaptive(lab, scene, {target, unit}, lab.Seeds(12));
      const std::string what = scene + ", target " + ray::ErrorText(target, unit) + ": ";
      table.PrintError(what + "samples a pixel", a.samples);
      table.Add(what + "error / uniform's", Root(Mean(a.squares)) / Root(Mean(a.squares_of_uniform)),
                AtMost(scene == "box1" ? 0.5 : 1.05));
      const References& r = lab.ReferencesOf(scene);
      const double truth = (ray::MeanOf(r[0]) + ray::MeanOf(r[1])) / 2, bias = Mean(a.means) - truth;
      table.PrintError(what + "bias of the mean, %", 100 * bias / truth);
      table.PrintError(what + "the same in standard errors", bias / StandardError(a.means));
      table.Add(what + "bias / the larger of 0.1 % and 3 standard errors",
                std::abs(bias) / std::max(0.001 * truth, 3 * StandardError(a.means)), AtMost(1));
    }
  int warned = 0;
  const int seeds = lab.Seeds(8);
  for (int seed = 0; seed < seeds; ++seed) {
    ray::RenderSettings settings = lab.At("sky").subject.settings;
    settings.trace.strategy = ray::LightStrategy::bsdf;
    settings.samples = 512;
    settings.seed = static_cast<std::uint64_t>(seed);
    settings.budget.error = ray::ErrorTarget{0.02, ray::ErrorUnit::linear};
    settings.budget.adaptive = ray::Adaptive::tile;
    warned += Lab::Take(lab.At("sky"), settings).result.has_outliers;
  }
  table.Add("sky by scattering alone: share of renders that warn", Share(warned, seeds), AtLeast(1));
}

/// Seconds of one look at the error of a picture.
inline double SecondsToMeasure(int width, int height) {
  ray::Film film(width, height, {0, 0, width, height}, ray::FilterKind::box);
  for (int i = 0; i < film.Blocks(); ++i)
    for (int part = 0; part < ray::Film::parts; ++part) {
      film[i].sums[part] = film.EmptySums(i);
      film[i].samples[part] = 1;
      const ray::PixelRectangle p = film.PixelsOf(i);
      for (int y = p.y0; y < p.y1; ++y)
        for (int x = p.x0; x < p.x1; ++x)
          film[i].sums[part].Add(x, y, x + 0.5, y + 0.5, {0.1 * part, 0.2, 0.3}, film.filter());
    }
  std::vector<double> seconds;
  for (int i = 0; i < 11; ++i) {
    const double before = CpuSeconds();
    const auto error = ray::MeasureError(film, {});
    seconds.push_back(CpuSeconds() - before + (error ? 0 : std::numeric_limits<double>::infinity()));
  }
  return Median(seconds);
}

inline void CostOfClaims(Lab& lab, Table& table) {
  const bool quick = lab.wishes().quick;
  constexpr int samples = 64, large = 192;
  for (const char* scene : {"box1", "dof"}) {
    ray::RenderSettings plain = lab.At(scene).subject.settings;
    plain.width = plain.height = large;
    plain.samples = samples;
    ray::RenderSettings passes = plain;
    passes.wants_passes = true;
    const std::string what = std::string(scene) + ", 64 samples: ";
    const auto one = SecondsInTurns(lab.At(scene), {plain, passes}, quick ? 3 : 9);
    table.PrintError(what + "time in passes / at one go, one stream", one[1] / one[0]);
    const auto two = SecondsInTurns(lab.At(scene), {plain, InTwoStreams(plain, samples)}, quick ? 3 : 9);
    table.Add(what + "time with an error target / without", two[1] / two[0], AtMost(1.02));
    table.Add(what + "one look at the error / time of the render", SecondsToMeasure(large, large) / one[0],
              AtMost(0.02));
  }
  for (const std::string& scene : lab.Scenes({"box1", "dof", "pixel", "disc", "sky", "depth", "flat"}))
    for (const int n : {16, 64, 256}) {
      const int seeds = lab.Seeds(8);
      std::vector<double> squares;
      for (int i = 0; i < seeds; ++i) {
        ray::RenderSettings settings = InTwoStreams(lab.At(scene).subject.settings, n);
        settings.seed = static_cast<std::uint64_t>(5000 + i);
        squares.push_back(lab.SquaredError(scene, Lab::Take(lab.At(scene), settings).result.image));
      }
      table.Add(scene + ", " + std::to_string(n) + " samples: error of two streams / of one",
                Root(Mean(squares)) / Root(Mean(lab.SquaredErrors(scene, "sobol", n, seeds))), AtMost(1.35));
    }
}

}  // namespace trade
