#include "source/sample/PointBatch.h"

#include <gtest/gtest.h>

#include <vector>

namespace ray {
namespace {

/// Returns paths of different pixels and samples.
std::vector<SampleIndex> SomePaths(std::uint32_t count, int camera_dimensions) {
  std::vector<SampleIndex> paths;
  for (std::uint32_t i = 0; i < count; ++i)
    paths.push_back({RandomKey(i / 3), i % 2 == 0 ? i : 0xfffffff0u + i, camera_dimensions});
  return paths;
}

const std::array all_kinds{SamplerKind::sobol, SamplerKind::random, SamplerKind::stratified, SamplerKind::grid,
                           SamplerKind::rotated_grid};

TEST(PointBatch, EqualThePointsOfEachPath) {
  for (const SamplerKind kind : all_kinds)
    for (const int camera_dimensions : {0, 5})
      for (const std::uint32_t count : {0u, 1u, 7u, 64u}) {
        const auto paths = SomePaths(count, camera_dimensions);
        PointBatch<2> points;
        GetBatch(paths, 11, kind, 16, points);
        for (std::uint32_t i = 0; i < count; ++i) {
          const R2::Point alone = paths[i].PointsFor(11, kind, 16).Get2D(paths[i].sample);
          EXPECT_EQ(points.Get2D(i), alone) << sampler_names[static_cast<std::size_t>(kind)] << ", path " << i;
        }
      }
}

template <std::size_t size>
void ExpectPointsOfTheirOwn() {
  for (const SamplerKind kind : all_kinds) {
    const auto paths = SomePaths(61, 3);
    PointBatch<size> points;
    GetSeparateBatch(paths, 1, kind, 16, points);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const auto alone = Points(kind, paths[i].key.Child(1), 16).Get<size>(paths[i].sample);
      for (std::size_t c = 0; c < size; ++c)
        EXPECT_EQ(points.coordinates[c][i], alone[c])
            << sampler_names[static_cast<std::size_t>(kind)] << ", path " << i << ", " << c << " of " << size;
    }
  }
}

TEST(PointBatch, WithTwoToFiveCoordinatesAlsoEqualThem) {
  ExpectPointsOfTheirOwn<2>();
  ExpectPointsOfTheirOwn<3>();
  ExpectPointsOfTheirOwn<4>();
  ExpectPointsOfTheirOwn<5>();
}

}  // namespace
}  // namespace ray
