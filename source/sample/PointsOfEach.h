#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "R1/BatchSize.h"
#include "source/sample/Sampler.h"

namespace ray {

/// Points of many paths side by side: one of each, from sequences of their own, a coordinate an array over the paths,
/// so that loops become vector instructions.
template <std::size_t size>
struct PointsOfEach {
  static constexpr std::size_t most = R1::batch_size;
  alignas(64) std::array<std::array<double, most>, size> coordinates;

  R2::Point Get2D(std::size_t i) const { return {coordinates[0][i], coordinates[1][i]}; }
};

/// Bit for bit what `at[i].PointsFor(which, kind, samples).Get<size>(at[i].sample)` gives, of at most `most` paths
/// whose camera_dimensions are alike.
void GetOfEach(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
               PointsOfEach<2>& points);
/// Points of `Points(kind, at[i].key.Child(which), samples)`: choices that none of the camera's are even together
/// with. There are two to five coordinates.
template <std::size_t size>
void GetOfEachAlone(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
                    PointsOfEach<size>& points);

}  // namespace ray
