#include "source/sample/PointBatch.h"

#include "R3/Numeric.h"

namespace ray {
namespace {

constexpr std::size_t most = PointBatch<2>::most;
constexpr std::size_t lanes = 8;  // of 32 bits each, in the widest vectors that are compiled
static_assert(most % lanes == 0);

/// Returns bits / 2^32, by way of a signed number, for which a vector instruction exists.
inline double Fraction(std::uint32_t bits) {
  return static_cast<double>(static_cast<std::int32_t>(bits ^ 0x80000000)) * 0x1p-32 + 0.5;
}

inline void CoordinateBatch(int dimension, const std::uint32_t* index, const std::uint32_t* seeds, std::size_t count,
                            double* coordinates) {
  alignas(64) std::uint32_t bits[most];  // a separate loop, since table lookups are not vectorized
  for (std::size_t i = 0; i < count; ++i) bits[i] = ReversedSobolBits(index[i], dimension);
  for (std::size_t i = 0; i < count; ++i) coordinates[i] = Fraction(ReversedBits(OwenReversed(bits[i], seeds[i])));
}

/// Computes coordinates c and c + 1, of dimension `first` and the next; their seeds are the halves of one key.
template <std::size_t c, std::size_t size>
inline void PairBatch(int first, const std::uint32_t* index, const std::uint64_t* keys, std::size_t count,
                      PointBatch<size>& points) {
  alignas(64) std::uint32_t high[most], low[most];
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t seeds = RandomKey::FromBits(keys[i]).Child(c / 2).Bits();
    high[i] = static_cast<std::uint32_t>(seeds >> 32), low[i] = static_cast<std::uint32_t>(seeds);
  }
  CoordinateBatch(first, index, high, count, points.coordinates[c].data());
  if constexpr (c + 1 < size) CoordinateBatch(first + 1, index, low, count, points.coordinates[c + 1].data());
}

/// Computes the points in loops over numbers of one size each: 64 bits for keys, 32 for the bits of points.
///   order_of   the child of a path's key that shuffles its points; `first`: the dimension of their first coordinate
template <std::size_t size>
inline void SobolBatch(const SampleIndex* at, std::size_t count, std::uint64_t which, std::uint64_t order_of, int first,
                       PointBatch<size>& points) {
  alignas(64) std::uint64_t keys[most];
  alignas(64) std::uint32_t order[most], index[most];
  for (std::size_t i = 0; i < count; ++i) keys[i] = at[i].key.Bits(), index[i] = at[i].sample;
  // Padded to whole vectors, since the remainder would be processed one at a time.
  for (; count % lanes != 0; ++count) keys[count] = index[count] = 0;
  for (std::size_t i = 0; i < count; ++i)
    order[i] = static_cast<std::uint32_t>(RandomKey::FromBits(keys[i]).Child(order_of).Bits() >> 32);
  for (std::size_t i = 0; i < count; ++i) keys[i] = RandomKey::FromBits(keys[i]).Child(which).Bits();
  for (std::size_t i = 0; i < count; ++i) index[i] = ShuffledIndex(index[i], order[i]);
  PairBatch<0>(first, index, keys, count, points);
  if constexpr (size > 2) PairBatch<2>(first + 2, index, keys, count, points);
  if constexpr (size > 4) PairBatch<4>(first + 4, index, keys, count, points);
}

template <std::size_t size>
R3_VECTORIZED void SobolAlone(const SampleIndex* at, std::size_t count, std::uint64_t which, PointBatch<size>& points) {
  SobolBatch(at, count, which, which, 0, points);
}
/// Computes further coordinates of the camera's own points, starting at `dimension`.
R3_VECTORIZED
void SobolAfterCamera(const SampleIndex* at, std::size_t count, std::uint64_t which, int dimension,
                      PointBatch<2>& points) {
  SobolBatch(at, count, which, camera_key, dimension, points);
}

template <std::size_t size, typename PointsAt>
void OneAtATime(std::span<const SampleIndex> at, PointBatch<size>& points, const PointsAt& points_at) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::array<double, size> point = points_at(at[i]).template Get<size>(at[i].sample);
    for (std::size_t c = 0; c < size; ++c) points.coordinates[c][i] = point[c];
  }
}

}  // namespace

void GetBatch(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
              PointBatch<2>& points) {
  if (at.empty()) return;
  if (!UsesSobol(kind))
    return OneAtATime(at, points, [&](const SampleIndex& index) { return index.PointsFor(which, kind, samples); });
  const int after_camera = at[0].camera_dimensions;
  if (after_camera == 0) return SobolAlone(at.data(), at.size(), which, points);
  SobolAfterCamera(at.data(), at.size(), which, after_camera, points);
}

template <std::size_t size>
void GetSeparateBatch(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
                      PointBatch<size>& points) {
  if (UsesSobol(kind)) return SobolAlone(at.data(), at.size(), which, points);
  OneAtATime(at, points, [&](const SampleIndex& index) { return Points(kind, index.key.Child(which), samples); });
}
template void GetSeparateBatch(std::span<const SampleIndex>, std::uint64_t, SamplerKind, std::uint32_t, PointBatch<2>&);
template void GetSeparateBatch(std::span<const SampleIndex>, std::uint64_t, SamplerKind, std::uint32_t, PointBatch<3>&);
template void GetSeparateBatch(std::span<const SampleIndex>, std::uint64_t, SamplerKind, std::uint32_t, PointBatch<4>&);
template void GetSeparateBatch(std::span<const SampleIndex>, std::uint64_t, SamplerKind, std::uint32_t, PointBatch<5>&);

}  // namespace ray
