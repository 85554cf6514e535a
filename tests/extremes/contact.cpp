// Surfaces that touch: rays that start, end and pass where surfaces meet. If this fails, light leaks through the edges
// of rooms, lamps in ceilings are dark, and what stands on a floor hides it.

#include <gtest/gtest.h>

#include "source/integrate/shading/ShadingPoint.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"
#include "tests/Room.h"

namespace ray {
namespace {

/// A scene with the files that it names, in a folder of its own.
Scene FromFiles(const std::string& text, const std::vector<std::pair<std::string, std::string>>& files) {
  const project::Folder folder;
  for (const auto& [name, content] : files) folder.Write(name, content);
  return Parse(folder.Write("scene.scn", text), {}).scene;
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

/// A room, in which one way to find hits is tried.
struct RoomStage {
  RoomStage(Draw& draw, int number, const R3::Matrix& frame)
      : kind(Room::kinds[static_cast<std::size_t>(number) % Room::kinds.size()]),
        room(draw, kind, frame),
        stage(FromFiles(room.text, {{"room.off", room.mesh}})) {
    const auto ways = accelerators::EveryWay();
    const auto& way = ways[static_cast<std::size_t>(number) % ways.size()];
    accelerator = FindAcceleratorKind(way.settings.name)->Make(stage.world, way.settings);
    what = way.name + ": " + kind + " " + std::to_string(number);
  }

  std::string kind, what;
  Room room;
  project::Stage stage;
  std::unique_ptr<const Accelerator> accelerator;
  Workspace workspace;
};

/// Follows a path from inside the room, aimed at its seams; false if it leaves.
bool StaysInside(RoomStage& r, Draw& draw, bool at_seam, std::uint64_t& rays) {
  constexpr int bounces = 8;
  R3::Ray ray{.origin = r.room.Inside()};
  ray.direction = Unit((at_seam ? r.room.OnSeam() : r.room.OnWall()) - ray.origin);
  ShadingPoint p({}, PathState{}, {});
  for (int bounce = 0; bounce <= bounces; ++bounce) {
    ++rays;
    const auto hit = r.accelerator->Intersect(ray, r.workspace);
    if (!hit) {
      std::printf("%s: bounce %d %s\n%s", r.what.c_str(), bounce, oracle::Hex(ray).c_str(), r.room.text.c_str());
      return false;
    }
    p = ShadingPointAt(r.stage.world, ray, {}, *hit);
    const R3::Vector mirrored = ray.direction - 2 * Dot(p.N, ray.direction) * p.N;
    R3::Vector aimed = Unit(r.room.OnSeam() - p.free_point);
    if (!(Dot(aimed, p.N) > 0) || r.room.IsAlongWall(p.free_point, aimed)) aimed = Scattered(draw, p);
    const int how = draw.Whole(0, 2);
    ray = SpawnRay(p, how == 0 ? mirrored : how == 1 ? aimed : Scattered(draw, p));
  }
  return true;
}

void ExpectNoLeaks(int rooms, int paths, R3::Matrix (*frame_of)(Draw&, int)) {
  std::uint64_t rays = 0, leaks = 0;
  for (int number = 0; number < rooms; ++number) {
    Draw draw(static_cast<std::uint64_t>(number) + 7000);
    RoomStage r(draw, number, frame_of(draw, number / static_cast<int>(Room::kinds.size())));
    for (int i = 0; i < paths; ++i) leaks += !StaysInside(r, draw, i % 3 > 0, rays);
  }
  EXPECT_EQ(leaks, 0u) << "of " << rays;
  std::printf("%llu rays, %llu leaks\n", static_cast<unsigned long long>(rays), static_cast<unsigned long long>(leaks));
}

TEST(Extremes, M1_NoPathLeavesAClosedRoom) { ExpectNoLeaks(Count(48, 1000), Count(1500, 12'500), Frame); }

// Coordinates there are 2^-13 apart.
TEST(Extremes, M8_NoPathLeavesARoomFarAway) {
  ExpectNoLeaks(Count(24, 240), Count(500, 5000), [](Draw& draw, int) {
    R3::Matrix frame;
    const double scale = std::exp2(draw.Whole(2, 12));
    for (auto& row : frame.m) {
      for (std::size_t j = 0; j < 3; ++j) row[j] *= scale;
      row[3] = std::round(1e12 * draw.Between(-1, 1));
    }
    return frame;
  });
}

// Nothing is between two places of a convex room, wherever on its walls and seams they are.
TEST(Extremes, M2_NoShadowRayInAConvexRoomIsBlocked) {
  std::uint64_t rays = 0, blocked = 0;
  for (int number = 0; number < Count(48, 1000); ++number) {
    Draw draw(static_cast<std::uint64_t>(number) + 7200);
    RoomStage r(draw, number, Frame(draw, number / static_cast<int>(Room::kinds.size())));
    if (r.kind == "concave") continue;
    for (int i = 0; i < Count(1500, 16'000); ++i) {
      R3::Ray ray{.origin = r.room.Inside()};
      ray.direction = Unit((i % 3 > 0 ? r.room.OnSeam() : r.room.OnWall()) - ray.origin);
      const auto hit = r.accelerator->Intersect(ray, r.workspace);
      ASSERT_TRUE(hit) << r.what;
      const ShadingPoint p = ShadingPointAt(r.stage.world, ray, {}, *hit);
      const R3::Point lamp = i % 4 == 0 ? r.room.Inside() : i % 4 == 1 ? r.room.OnWall() : r.room.OnSeam();
      const R3::Vector to_light = lamp - p.free_point;
      if (!(Dot(p.N, to_light) > 0) || r.room.IsAlongWall(p.free_point, to_light)) continue;
      ++rays;
      const R3::Ray shadow = ShadowRay(p, {.to_light = to_light, .is_infinite = false});
      if (!r.accelerator->IsOccluded(shadow, r.workspace)) continue;
      if (++blocked < 4) std::printf("%s: %s\n%s", r.what.c_str(), oracle::Hex(shadow).c_str(), r.room.text.c_str());
    }
  }
  EXPECT_EQ(blocked, 0u) << "of " << rays;
  std::printf("%llu shadow rays, %llu blocked\n", static_cast<unsigned long long>(rays),
              static_cast<unsigned long long>(blocked));
}

}  // namespace
}  // namespace ray
