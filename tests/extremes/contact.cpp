// Surfaces that touch: rays that start, end and pass where surfaces meet. If this fails, light leaks through the edges
// of rooms, lamps in ceilings are dark, and what stands on a floor hides it.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "source/integrate/ShadingPoint.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"
#include "tests/Room.h"

namespace ray {
namespace {

/// A scene with the files that it names, in a folder of its own.
Scene FromFiles(const std::string& text, const std::vector<std::pair<std::string, std::string>>& files) {
  const auto folder = std::filesystem::temp_directory_path() / ("raypro-contact-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name, const std::string& content) {
    FILE* out = std::fopen((folder / name).c_str(), "wb");
    std::fwrite(content.data(), 1, content.size(), out);
    std::fclose(out);
  };
  for (const auto& [name, content] : files) write(name, content);
  write("scene.scn", text);
  Scene scene = Parse(folder / "scene.scn", {}).scene;
  std::filesystem::remove_all(folder);
  return scene;
}

/// Where rooms stand: as they are, turned, of any size, far away.
R3::Matrix Frame(Draw& draw, int number) {
  R3::Matrix frame;
  if (number % 4 == 0) return frame;
  if (number % 2 == 1) frame = draw.Rotation();
  const double scale = number % 4 >= 2 ? draw.Scale(-6, 6) : 1;
  const double shift = number % 8 >= 4 ? scale * draw.Scale(0, 9) : 0;
  for (auto& row : frame.m) {
    for (std::size_t j = 0; j < 3; ++j) row[j] *= scale;
    row[3] = shift * draw.Between(-1, 1);
  }
  return frame;
}

R3::Vector Scattered(Draw& draw, const ShadingPoint& p) {
  const R3::Vector d = draw.Direction();
  return Dot(d, p.N) < 0 ? -d : d;
}

TEST(Extremes, M1_NoPathLeavesAClosedRoom) {
  constexpr int bounces = 8;
  std::uint64_t rays = 0, leaks = 0;
  for (int number = 0; number < Count(48, 1000); ++number) {
    Draw draw(static_cast<std::uint64_t>(number) + 7000);
    const std::string kind = Room::kinds[static_cast<std::size_t>(number) % Room::kinds.size()];
    const R3::Matrix frame = Frame(draw, number / static_cast<int>(Room::kinds.size()));
    Room room(draw, kind, frame);
    const project::Stage stage(FromFiles(room.text, {{"room.off", room.mesh}}));
    const auto ways = accelerators::EveryWay();
    const auto& way = ways[static_cast<std::size_t>(number) % ways.size()];
    const auto accelerator = FindAcceleratorKind(way.settings.name)->Make(stage.world, way.settings);
    Workspace workspace;
    std::uint64_t here = 0;
    for (int i = 0; i < Count(1500, 12'500); ++i) {
      R3::Ray ray{.origin = room.Inside()};
      ray.direction = Unit((i % 3 > 0 ? room.OnSeam() : room.OnWall()) - ray.origin);
      ShadingPoint p({}, {});
      for (int bounce = 0; bounce <= bounces; ++bounce) {
        ++rays;
        const auto hit = accelerator->Intersect(ray, workspace);
        if (!hit) {
          if (++here == 1)
            ADD_FAILURE() << way.name << ": " << kind << " " << number << " path " << i << " bounce " << bounce << " "
                          << oracle::Hex(ray) << "\n"
                          << room.text;
          break;
        }
        p = ShadingPointAt(stage.world, {.ray = ray, .index = {}}, *hit);
        const R3::Vector mirrored = ray.direction - 2 * Dot(p.N, ray.direction) * p.N;
        R3::Vector aimed = Unit(room.OnSeam() - p.free_point);
        if (!(Dot(aimed, p.N) > 0) || room.IsAlongWall(p.free_point, aimed)) aimed = Scattered(draw, p);
        const int how = draw.Whole(0, 2);
        ray = SpawnRay(p, how == 0 ? mirrored : how == 1 ? aimed : Scattered(draw, p));
      }
    }
    leaks += here;
  }
  EXPECT_EQ(leaks, 0u) << "of " << rays;
  std::printf("%llu rays, %llu leaks\n", static_cast<unsigned long long>(rays), static_cast<unsigned long long>(leaks));
}

}  // namespace
}  // namespace ray
