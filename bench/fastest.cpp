// How many frames a second a moving camera gets in the room of 5 x 5 x 5, through the Render that raypro calls.
//
//     make bench && build/bench/fastest [scene=scenes/room.scn] [size=512] [frames=60] [threads=2] [simd=avx2]
//
// The eye goes once around a small circle. Prints milliseconds of the frame that took least, of the median and of the
// slowest, and the CPU milliseconds of all threads together, least and mean: what the cores did, whoever else uses
// them. The first frame, from the scene's own camera, is rendered by $RAYPRO (build/raypro) as well, and must be the
// same bytes; else the status is 1.

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/parse/Parse.h"
#include "source/render/Render.h"

namespace {

using Bytes = std::vector<unsigned char>;
using Options = std::map<std::string, std::string>;

struct Frame {
  double seconds = 0, cpu_seconds = 0;
};

double CpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Bytes PpmOf(const R2::Image& image) { return R2::FormatForName("frame.ppm")->encode(image, {}, {}); }

Bytes PpmOfRaypro(const Options& options) {
  const char* const named = std::getenv("RAYPRO");
  const std::string program = named ? named : "build/raypro", size = options.at("size");
  const auto file = std::filesystem::temp_directory_path() / ("fastest" + std::to_string(std::time(nullptr)) + ".ppm");
  const std::string command = "'" + program + "' '" + options.at("scene") + "' '" + file.string() + "' -quiet -width " +
                              size + " -height " + size + " -simd " + options.at("simd");
  if (std::system(command.c_str()) != 0) return {};
  std::ifstream in(file, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(file);
  return bytes;
}

/// The camera at `turn` of the circle, from 0 to 1; at 0 it stays where it is.
ray::Camera Moved(ray::Camera camera, double turn) {
  constexpr double radius = 0.4;
  const double angle = 2 * std::numbers::pi * turn;
  camera.eye = camera.eye + radius * (std::sin(angle) * camera.right + 0.5 * (std::cos(angle) - 1) * camera.towards);
  return camera;
}

void PrintFrames(std::vector<Frame> frames) {
  double cpu_sum = 0, cpu_least = frames[0].cpu_seconds;
  for (const Frame& frame : frames) cpu_sum += frame.cpu_seconds, cpu_least = std::min(cpu_least, frame.cpu_seconds);
  std::ranges::sort(frames, {}, &Frame::seconds);
  const double least = frames.front().seconds, median = frames[frames.size() / 2].seconds;
  std::printf(
      "least %.2f ms (%.1f frames/s), median %.2f ms (%.1f), slowest %.2f ms; CPU least %.2f ms, mean %.2f ms\n",
      1e3 * least, 1 / least, 1e3 * median, 1 / median, 1e3 * frames.back().seconds, 1e3 * cpu_least,
      1e3 * cpu_sum / static_cast<double>(frames.size()));
}

int Run(const Options& options) {
  const ray::ParsedScene parsed = ray::Parse(options.at("scene"), {});
  const ray::World world(parsed.scene);
  ray::AcceleratorSettings how;
  how.instruction_set = options.at("simd");
  const auto accelerator = ray::FindAcceleratorKind(how.name)->Make(world, how);
  ray::RenderSettings settings;
  settings.width = settings.height = std::stoi(options.at("size"));
  settings.threads = std::stoi(options.at("threads"));
  const int count = std::stoi(options.at("frames"));
  std::vector<Frame> frames;
  bool is_same = false;
  std::uint64_t rays = 0;
  for (int i = 0; i < count; ++i) {
    settings.view = Moved(parsed.scene.camera, static_cast<double>(i) / count);
    const auto start = std::chrono::steady_clock::now();
    const double cpu_start = CpuSeconds();
    const Bytes bytes = PpmOf(ray::Render(world, *accelerator, settings).image);
    frames.push_back(
        {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), CpuSeconds() - cpu_start});
    if (i == 0) is_same = bytes == PpmOfRaypro(options);
  }
  rays = ray::Render(world, *accelerator, settings).rays.Total();
  std::printf("%s %dx%d, %d threads, %s: %.0f rays a frame\n", options.at("scene").c_str(), settings.width,
              settings.height, settings.threads, how.instruction_set.c_str(), static_cast<double>(rays));
  PrintFrames(frames);
  std::printf("first frame: %s\n", is_same ? "the same bytes as raypro's" : "DIFFERS from raypro's");
  return is_same ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  // Films of frame after frame keep their memory: to get its pages anew took a fourteenth of the time.
  mallopt(M_MMAP_THRESHOLD, 1 << 30), mallopt(M_TRIM_THRESHOLD, 1 << 30);
  RenderOptions options{
      {"scene", "scenes/room.scn"}, {"size", "512"}, {"frames", "60"}, {"threads", "2"}, {"simd", "best"}};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto equals = word.find('=');
    if (equals == std::string::npos || !options.count(word.substr(0, equals))) {
      std::fprintf(stderr, "fastest: unknown option %s\n", argv[i]);
      return 1;
    }
    options[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return Run(options);
}
