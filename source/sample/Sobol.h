#pragma once

#include <array>
#include <cstdint>

namespace ray {

inline std::uint32_t ReversedBits(std::uint32_t bits) {
  bits = __builtin_bswap32(bits);
  bits = ((bits & 0x0f0f0f0f) << 4) | ((bits >> 4) & 0x0f0f0f0f);
  bits = ((bits & 0x33333333) << 2) | ((bits >> 2) & 0x33333333);
  return ((bits & 0x55555555) << 1) | ((bits >> 1) & 0x55555555);
}

/// Owen's permutation of the fractions b / 2^32: every bit is flipped or kept as a random function of the bits ABOVE it
/// says. `reversed` has the bits of b in reverse, so that a carry, which only ever runs upwards, runs from the bits
/// above to the bits below; so has the result.
///   source   the hash is Vegdahl's, Owen scrambling based on hashing, improved (2021); its multipliers are even where
///            a product is folded in and odd where one replaces, without which bits would flip themselves
inline std::uint32_t OwenReversed(std::uint32_t reversed, std::uint32_t seed) {
  std::uint32_t bits = reversed;
  bits ^= bits * 0x3d20adea;
  bits += seed;
  bits *= (seed >> 16) | 1;
  bits ^= bits * 0x05526c56;
  bits ^= bits * 0x53a22864;
  return bits;
}

/// The sequence itself, neither shuffled nor scrambled, in units of 2^-32. `reversed` is ReversedBits(index).
std::uint32_t SobolBits(std::uint32_t index, std::uint32_t reversed, int dimension);

/// The first dimensions of Sobol's sequence, shuffled and scrambled: among any 2^k points that begin at a multiple of
/// 2^k, each pair of the first two dimensions has one point in every box of area 2^-k whose sides are powers of two,
/// and further dimensions are nearly as even together. Two sequences with different seeds are paired at random.
///   accuracy   coordinates are multiples of 2^-32, so the sequence repeats after 2^32 points
///   source     Sobol', On the distribution of points in a cube (1967), with the direction numbers of Joe and Kuo,
///              Constructing Sobol sequences with better two-dimensional projections (2008); scrambled after Owen,
///              Randomly permuted (t,m,s)-nets (1995), by hashing as Laine and Karras, Stratified sampling for
///              stochastic transparency (2011), and Burley, Practical hash-based Owen scrambling (2020)
class Sobol {
 public:
  static constexpr int dimensions = 8;

  /// The point `index` of the sequence whose order `order` shuffles; one seed a coordinate scrambles that.
  Sobol(std::uint32_t index, std::uint32_t order)
      : reversed_(OwenReversed(ReversedBits(index), order)), index_(ReversedBits(reversed_)) {}
  /// In [0, 1); dimension 0 to dimensions - 1.
  double Coordinate(int dimension, std::uint32_t seed) const {
    // Of dimension 0 the bits are those of the index in reverse.
    const std::uint32_t bits = dimension == 0 ? index_ : ReversedBits(SobolBits(index_, reversed_, dimension));
    return ReversedBits(OwenReversed(bits, seed)) * 0x1p-32;
  }

 private:
  std::uint32_t reversed_, index_;  // of the point in the sequence; with its bits in reverse, and as it is
};

}  // namespace ray
