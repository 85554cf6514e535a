#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "R1/Columns.h"
#include "source/sample/Sampler.h"

namespace ray {

/// One point for each of many paths, from separate sequences. Coordinates are stored as arrays over the paths, so that
/// loops become vector instructions.
template <std::size_t size>
struct PointBatch {
  static constexpr std::size_t most = R1::batch_size;
  alignas(64) std::array<std::array<double, most>, size> coordinates;

  R2::Point Get2D(std::size_t i) const { return {coordinates[0][i], coordinates[1][i]}; }
};

/// Computes the points, bit-identical to `at[i].PointsFor(which, kind, samples).Get<size>(at[i].sample)`, of at most
/// `most` paths with equal camera_dimensions.
void GetBatch(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
              PointBatch<2>& points);
/// Computes points of `Points(kind, at[i].key.Child(which), samples)`, for choices that are not stratified together
/// with the camera's. There are two to five coordinates.
template <std::size_t size>
void GetSeparateBatch(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
                      PointBatch<size>& points);

}  // namespace ray
