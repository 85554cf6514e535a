#pragma once

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bench/TradeLab.h"
#include "tests/Named.h"

/// What holds of the program as a whole: it ends in time, and its pictures can be made again.
namespace trade {

/// raypro, told to end after so many seconds, by the clock in its own report.
inline void Time(Lab& lab, Table& table) {
  struct Case {
    const char* name;
    std::string arguments;
  };
  const std::string scenes = (project::Root() / "scenes").string();
  const std::vector<Case> cases{
      {"box1 256x256", scenes + "/indirect.scn OUT.pfm -width 256 -height 256 -max_depth 0 -shadow_samples 1"},
      {"box5 256x256", scenes + "/indirect.scn OUT.png -width 256 -height 256 -mode path -max_depth 4"},
      {"dof 640x480", scenes + "/lens.scn OUT.png -width 640 -height 480 -aperture 0.12 -focus 5 -shadow_samples 1"},
      {"texture 64x64", scenes + "/texture.scn OUT.pfm -width 64 -height 64"},
      {"box1 256x256, mitchell", scenes + "/indirect.scn OUT.exr -width 256 -height 256 -filter mitchell"}};
  std::string folder = (std::filesystem::temp_directory_path() / "trade-XXXXXX").string();
  if (!mkdtemp(folder.data())) throw std::runtime_error("cannot make a folder for pictures");
  for (const Case& c : cases)
    for (const int seconds : {1, 2}) {
      std::vector<double> shares;
      for (int i = 0; i < lab.Seeds(4); ++i) {
        std::string arguments = c.arguments;
        arguments.replace(arguments.find("OUT"), 3, folder + "/picture");
        const std::string command = "'" + lab.wishes().raypro.string() + "' " + arguments + " -time " +
                                    std::to_string(seconds) + "s -quiet -report " + folder + "/report.json -seed " +
                                    std::to_string(i);
        if (std::system(command.c_str()) != 0) throw std::runtime_error("this failed: " + command);
        const double wall = nlohmann::json::parse(std::ifstream(folder + "/report.json")).at("seconds").at("wall");
        shares.push_back(wall / seconds);
      }
      const std::string what = std::string(c.name) + ", " + std::to_string(seconds) + " s: time taken / asked for, ";
      table.Add(what + "least", Quantile(shares, 0), AtLeast(0.9));
      table.Add(what + "most", Quantile(shares, 1), AtMost(1.02));
    }
  std::filesystem::remove_all(folder);
}

/// A scene and settings that use everything at once.
inline Subject Everything() {
  Subject s{.name = "everything",
            .scene = project::FromText(
                std::string(glass_text) + "point_light 2 1 1  -2 2 2  0 0 1\n" + "dir_light 0.2 0.2 0.3  0 -1 -0.3\n" +
                "material 0 0 0  0 0 0  0 0 0  0 0 0  4 3 2  1 1 0\n" + "tri 4  -1 2 -1  0 2 -1  -0.5 2.5 -0.5\n" +
                "material 0 0 0  0.6 0.6 0.6  0.3 0.3 0.3  0 0 0  0 0 0  20 1 "
                "scenes/textures/compass.ppm\nsphere 5  -1.6 0.4 1.6  0.4\n"),
            .settings = {}};
  s.scene.environment = std::make_shared<ray::Environment>(SkyWithSun());
  s.settings.width = 37;
  s.settings.height = 27;
  s.settings.filter = ray::FilterKind::mitchell;
  s.settings.camera = {.motion = {0.1, 0.02, 0}, .aperture = 0.05, .focus = 5};
  s.settings.trace.glossy = s.settings.trace.fresnel = true;
  s.settings.trace.max_depth = 4;
  s.settings.trace.roulette = ray::Roulette::on;
  s.settings.trace.shadow_samples = 2;
  s.settings.seed = 77;
  return s;
}

inline ray::Replay ReplayOf(const ray::RenderResult& result) {
  ray::Replay replay{.two_streams = result.two_streams,
                     .planned_samples = result.planned_samples,
                     .ends = {},
                     .samples = {},
                     .places = {}};
  for (const ray::Pass& pass : result.passes) replay.ends.push_back(pass.end);
  replay.samples = result.block_samples;
  return replay;
}

inline int PixelsApart(const R2::Image& a, const R2::Image& b, int x0 = 0, int y0 = 0) {
  int apart = 0;
  for (int y = 0; y < b.Height(); ++y)
    for (int x = 0; x < b.Width(); ++x) apart += !(a.At(x0 + x, y0 + y) == b.At(x, y));
  return apart;
}

/// Counts of pixels that differ in a bit, which are to be 0.
inline void Determinism(Lab&, Table& table) {
  const Site site(Everything());
  for (const char* mode : {"whitted", "path"})
    for (const char* sampler : ray::sampler_names) {
      ray::RenderSettings settings = site.subject.settings;
      settings.mode = project::Named{mode};
      settings.trace.sampler = project::Named{sampler};
      const std::string name = std::string(mode) + ", " + sampler + ", ";
      const auto image = [&](const ray::RenderSettings& s) { return Lab::Take(site, s).result.image; };
      const auto by_samples = [&](const std::string& what, ray::RenderSettings s) {
        s.threads = 1;
        const R2::Image one = image(s);
        int apart = 0;
        for (const int threads : {2, 7})
          for (const int tile : {0, 8, 32}) {
            s.threads = threads;
            s.tile_size = tile;
            apart += PixelsApart(one, image(s));
          }
        table.Add(name + what + ": threads 1, 2, 7, tiles 0, 8, 32", apart, AtMost(0));
        return one;
      };
      settings.samples = 24;
      const R2::Image whole = by_samples("24 samples", settings);
      ray::RenderSettings part = settings;
      part.crop = ray::PixelRectangle{11, 5, 30, 23};
      table.Add(name + "24 samples: a crop beside the whole", PixelsApart(whole, image(part), 11, 5), AtMost(0));

      ray::RenderSettings to_error = settings;
      to_error.samples = 32;
      to_error.budget.error = ray::ErrorTarget{4, ray::ErrorUnit::display};
      by_samples("error target", to_error);
      const auto replayed = [&](const std::string& what, const ray::RenderSettings& s) {
        const ray::RenderResult first = Lab::Take(site, s).result;
        ray::RenderSettings again = s;
        again.budget = {};
        again.threads = 2;
        again.replay = ReplayOf(first);
        table.PrintError(name + what + ": samples", first.samples.mean);
        table.Add(name + what + ": replayed", PixelsApart(first.image, image(again)), AtMost(0));
      };
      replayed("error target", to_error);
      ray::RenderSettings to_time = settings;
      to_time.samples = 1;
      to_time.budget.seconds = 0.4;
      replayed("time", to_time);
      to_time.budget.error = ray::ErrorTarget{0.01, ray::ErrorUnit::display};
      replayed("time and error", to_time);
    }
}

}  // namespace trade
