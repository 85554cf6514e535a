#include "source/app/Record.h"

#include "source/app/Words.h"
#include "source/parse/Text.h"

namespace ray {
namespace {

std::string PixelsText(const Record& record) {
  if (record.IsComplete()) return "complete";
  return std::to_string(record.pixels_done) + " of " + std::to_string(record.pixels_total) + " pixels done";
}

double MillionRaysASecond(const Record& record) {
  return record.seconds.wall > 0 ? 1e-6 * static_cast<double>(record.rays.Total()) / record.seconds.wall : 0;
}

std::string Seconds(double seconds) { return Fixed(seconds, 3) + " s"; }

}  // namespace

std::string CommandAsTyped(std::span<const std::string> words) {
  return words.empty() ? "raypro" : "raypro " + ShellLine(words);
}

R2::ImageSettings SettingsInPicture(const Record& record) {
  return {
      {"program", "raypro " RAYPRO_VERSION},
      {"command", record.command},
      {"scene_hash", record.scene.hash},
      {"seed", std::to_string(record.options.render.seed)},
      {"samples", std::to_string(record.options.render.samples)},
      {"accel", record.options.accelerator.name},
      {"seconds", Fixed(record.seconds.wall, 3)},
      {"pixels", PixelsText(record)},
  };
}

std::string FinalLine(const Record& record) {
  return Escaped(record.options.picture) + " " + std::to_string(record.width) + "x" + std::to_string(record.height) +
         " " + std::to_string(record.options.render.samples) + " spp " + Fixed(record.seconds.wall, 2) + " s " +
         Fixed(MillionRaysASecond(record), 1) + " Mrays/s" +
         (record.IsComplete() ? "" : " (stopped by " + record.stop + ", " + PixelsText(record) + ")") + "\n";
}

std::string Statistics(const Record& record) {
  const auto line = [](std::string name, const std::string& value) {
    constexpr std::size_t column_of_values = 18;
    name.resize(column_of_values, ' ');
    return "  " + name + value + "\n";
  };
  const auto count = [&](const char* name, auto number) { return line(name, std::to_string(number)); };
  const auto& [options, command, scene, rays, counts, seconds, peak_memory, threads, width, height, done, total,
               warnings, stop] = record;
  return "scene\n" + line("hash", scene.hash) + count("nodes", scene.nodes) + count("instances", scene.instances) +
         count("primitives", scene.primitives) + count("lights", scene.lights) + "rays\n" +
         count("camera", rays.camera) + count("shadow", rays.shadow) + count("reflection", rays.reflection) +
         count("transmission", rays.transmission) + count("cut", rays.cut) + count("total", rays.Total()) + "tests\n" +
         count("boxes", counts.box_tests) + count("primitives", counts.primitive_tests) +
         count("last hits asked", counts.cache_tests) + count("last hits hit", counts.cache_hits) + "time\n" +
         line("load", Seconds(seconds.load)) + line("build", Seconds(seconds.build)) +
         line("render", Seconds(seconds.render)) + line("write", Seconds(seconds.write)) +
         line("wall", Seconds(seconds.wall)) + line("cpu", Seconds(seconds.cpu)) + "run\n" + count("threads", threads) +
         line("peak memory", Fixed(1e-6 * static_cast<double>(peak_memory), 1) + " MB") +
         line("pixels", std::to_string(done) + " of " + std::to_string(total)) + line("stopped", stop);
}

}  // namespace ray
