#include "source/sample/PointsOfEach.h"

#include "R3/Numeric.h"

namespace ray {
namespace {

constexpr std::size_t most = PointsOfEach<2>::most;
constexpr std::size_t lanes = 8;  // of 32 bits each, in the widest vectors that are made
static_assert(most % lanes == 0);

/// bits / 2^32, by way of a signed number, for which there is a vector instruction.
inline double Fraction(std::uint32_t bits) {
  return static_cast<double>(static_cast<std::int32_t>(bits ^ 0x80000000)) * 0x1p-32 + 0.5;
}

template <int dimension>
inline void CoordinateOfEach(const std::uint32_t* index, const std::uint32_t* seeds, std::size_t count,
                             double* coordinates) {
  alignas(64) std::uint32_t bits[most];  // a loop of its own, since looking into tables is no vector instruction
  for (std::size_t i = 0; i < count; ++i) bits[i] = ReversedSobolBits(index[i], dimension);
  for (std::size_t i = 0; i < count; ++i) coordinates[i] = Fraction(ReversedBits(OwenReversed(bits[i], seeds[i])));
}

/// Two coordinates, from `first` on, whose seeds are the halves of one key.
template <int first>
inline void PairOfEach(const std::uint32_t* index, const std::uint64_t* keys, std::size_t count, double* x, double* y) {
  alignas(64) std::uint32_t high[most], low[most];
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t seeds = RandomKey::FromBits(keys[i]).Child(first / 2).Bits();
    high[i] = static_cast<std::uint32_t>(seeds >> 32), low[i] = static_cast<std::uint32_t>(seeds);
  }
  CoordinateOfEach<first>(index, high, count, x);
  CoordinateOfEach<first + 1>(index, low, count, y);
}

/// In loops of one kind of number each: 64 bits for keys, 32 for the bits of points.
template <std::size_t size>
inline void SobolOfEach(const SampleIndex* at, std::size_t count, std::uint64_t which, PointsOfEach<size>& points) {
  alignas(64) std::uint64_t keys[most];
  alignas(64) std::uint32_t order[most], index[most];
  for (std::size_t i = 0; i < count; ++i) keys[i] = at[i].key.Bits(), index[i] = at[i].sample;
  // Whole vectors from here on: what is left over would go one by one.
  for (; count % lanes != 0; ++count) keys[count] = index[count] = 0;
  for (std::size_t i = 0; i < count; ++i) {
    keys[i] = RandomKey::FromBits(keys[i]).Child(which).Bits();
    order[i] = static_cast<std::uint32_t>(keys[i] >> 32);
  }
  for (std::size_t i = 0; i < count; ++i) index[i] = ShuffledIndex(index[i], order[i]);
  auto& to = points.coordinates;
  PairOfEach<0>(index, keys, count, to[0].data(), to[1].data());
  if constexpr (size == 4) PairOfEach<2>(index, keys, count, to[2].data(), to[3].data());
}

R3_VECTORIZED
void SobolPairs(const SampleIndex* at, std::size_t count, std::uint64_t which, PointsOfEach<2>& points) {
  SobolOfEach(at, count, which, points);
}

R3_VECTORIZED
void SobolFours(const SampleIndex* at, std::size_t count, std::uint64_t which, PointsOfEach<4>& points) {
  SobolOfEach(at, count, which, points);
}

template <std::size_t size, typename PointsAt>
void OneByOne(std::span<const SampleIndex> at, PointsOfEach<size>& points, const PointsAt& points_at) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::array<double, size> point = points_at(at[i]).template Get<size>(at[i].sample);
    for (std::size_t c = 0; c < size; ++c) points.coordinates[c][i] = point[c];
  }
}

}  // namespace

void GetOfEach(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
               PointsOfEach<2>& points) {
  if (!at.empty() && at[0].camera_dimensions == 0 && UsesSobol(kind))
    return SobolPairs(at.data(), at.size(), which, points);
  OneByOne(at, points, [&](const SampleIndex& index) { return index.PointsFor(which, kind, samples); });
}

void GetOfEachAlone(std::span<const SampleIndex> at, std::uint64_t which, SamplerKind kind, std::uint32_t samples,
                    PointsOfEach<4>& points) {
  if (UsesSobol(kind)) return SobolFours(at.data(), at.size(), which, points);
  OneByOne(at, points, [&](const SampleIndex& index) { return Points(kind, index.key.Child(which), samples); });
}

}  // namespace ray
