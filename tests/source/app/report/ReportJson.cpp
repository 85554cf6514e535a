#include "source/app/report/ReportJson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "source/app/options/OptionTable.h"

namespace ray {
namespace {

RunStats ExampleStats() {
  RunStats stats;
  stats.options.files.scene = "in.scn";
  stats.options.files.image = stats.image_file = "out.png";
  stats.options.render.crop = PixelRectangle{1, 2, 3, 4};
  stats.options.render.seed = 18446744073709551615u;
  stats.options.parse.allowed_folders = {"a", "b"};
  stats.command = CommandAsTyped(std::vector<std::string>{"in.scn", "out put.png"});
  for (std::size_t i = 0; i < stats.rays.kinds.size(); ++i) stats.rays.kinds[i].rays = i + 1;
  stats.rays.cut = 5;
  stats.pixels_done = 3;
  stats.pixels_total = 4;
  stats.width = stats.height = 2;
  stats.stop = Stop::request;
  stats.stopped_by = "SIGINT";
  stats.samples.mean = 1;
  return stats;
}

// A program that reads reports must be able to rely on the manual.
TEST(ReportJson, HasTheKeysThatTheManualLists) {
  const auto report = nlohmann::ordered_json::parse(ReportJson(ExampleStats()));
  std::vector<std::string> keys, listed;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  for (const ReportField& field : ReportFields()) listed.emplace_back(field.name);
  EXPECT_EQ(keys, listed);
  EXPECT_EQ(report["rays"]["total"], 1 + 2 + 3 + 4 + 5);  // of every kind, without those that were cut off
  EXPECT_EQ(report["pixels"]["done"], 3);
  EXPECT_EQ(report["stop"]["reason"], "SIGINT");
  EXPECT_EQ(report["command"], "raypro in.scn 'out put.png'");
}

TEST(ReportJson, ContainsEverySettingWithItsType) {
  const auto settings = nlohmann::json::parse(ReportJson(ExampleStats()))["settings"];
  std::size_t count = 0;
  for (const OptionKind& option : OptionTable(Program::raypro)) {
    EXPECT_EQ(settings.contains(option.name), IsSetting(option)) << option.name;
    count += IsSetting(option);
  }
  EXPECT_EQ(settings.size(), count);
  EXPECT_EQ(settings["crop"], (nlohmann::json{1, 2, 3, 4}));
  EXPECT_EQ(settings["seed"], 18446744073709551615u);
  EXPECT_EQ(settings["shadows"], true);
  EXPECT_EQ(settings["min_luminance"], 0.01);
  EXPECT_EQ(settings["allow_path"], (nlohmann::json{"a", "b"}));
}

TEST(ReportJson, SurvivesNamesThatAreNotUtf8) {
  RunStats stats = ExampleStats();
  stats.options.files.scene = "\xff\xfe.scn";
  EXPECT_TRUE(nlohmann::json::accept(ReportJson(stats)));
}

TEST(RunStats, TheImageKeepsItsSettings) {
  auto settings = SettingsInImage(ExampleStats());
  EXPECT_EQ(settings["pixels"], "3 of 4 pixels done");
  EXPECT_EQ(settings["seed"], "18446744073709551615");
  EXPECT_TRUE(settings["command"].starts_with("raypro in.scn out.png -")) << settings["command"];
}

// Users who identify images by checksums, or compare those of two machines, must see no difference.
TEST(RunStats, TheImageHasNoTimeAndNoThreadsByDefault) {
  RunStats stats = ExampleStats();
  const auto once = SettingsInImage(stats);
  stats.seconds.wall = 12;
  stats.threads = stats.options.render.threads = 77;
  stats.options.given.emplace_back("threads");
  EXPECT_EQ(SettingsInImage(stats), once);
  stats.options.keep_times = true;
  auto with_times = SettingsInImage(stats);
  EXPECT_EQ(with_times["seconds"], "12.000");
  EXPECT_EQ(with_times["threads"], "77");
}

TEST(RunStats, TheLastLineOfARunNamesItsImage) {
  RunStats stats = ExampleStats();
  stats.seconds.wall = 2;
  stats.rays[ray::RayKind::camera].rays = 28'399'991;
  EXPECT_EQ(FinalLine(stats), "out.png 2x2 1 spp 2.00 s 14.2 Mrays/s (stopped by SIGINT, 3 of 4 pixels done)\n");
  // A signal may come when every pixel has part of its samples. They are a weight for merging images.
  stats.pixels_done = 4;
  stats.options.render.samples = 1000;
  stats.samples.mean = 5.5;
  EXPECT_EQ(FinalLine(stats),
            "out.png 2x2 5.5 spp 2.00 s 14.2 Mrays/s (stopped by SIGINT, 5.5 of 1000 samples per pixel done)\n");
  EXPECT_EQ(SettingsInImage(stats)["samples"], "5.5");
  for (const Stop stop : {Stop::samples, Stop::time, Stop::error}) {
    stats.stop = stop;
    EXPECT_EQ(FinalLine(stats), "out.png 2x2 1000 spp 2.00 s 14.2 Mrays/s\n");
  }
  stats.options.render.budget.seconds = 2;
  stats.samples.mean = 0.031;
  EXPECT_EQ(FinalLine(stats),
            "out.png 2x2 1 spp at 3.1% of the pixels, the others interpolated, 2.00 s 14.2 Mrays/s\n");
}

}  // namespace
}  // namespace ray
