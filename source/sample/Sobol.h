#pragma once

#include <array>
#include <cstdint>

namespace ray {

[[gnu::always_inline]] constexpr std::uint32_t ReversedBits(std::uint32_t bits) {
  bits = __builtin_bswap32(bits);
  bits = ((bits & 0x0f0f0f0f) << 4) | ((bits >> 4) & 0x0f0f0f0f);
  bits = ((bits & 0x33333333) << 2) | ((bits >> 2) & 0x33333333);
  return ((bits & 0x55555555) << 1) | ((bits >> 1) & 0x55555555);
}

/// Applies Owen's permutation to the fraction b / 2^32: flips every bit or not, as a random function of the bits ABOVE
/// it. `reversed` is b with its bits reversed, so that a carry, which only runs upwards, runs from the bits above to
/// the bits below; the result is also reversed.
///   source   the hash is Vegdahl's, Owen scrambling based on hashing, improved (2021); its multipliers are even where
///            a product is folded in and odd where one replaces, without which bits would flip themselves
[[gnu::always_inline]] inline std::uint32_t OwenReversed(std::uint32_t reversed, std::uint32_t seed) {
  std::uint32_t bits = reversed;
  bits ^= bits * 0x3d20adea;
  bits += seed;
  bits *= (seed >> 16) | 1;
  bits ^= bits * 0x05526c56;
  bits ^= bits * 0x53a22864;
  return bits;
}

/// The contribution of each byte of an index to a dimension.
using SobolTable = std::array<std::array<std::uint32_t, 256>, 4>;
extern const std::array<SobolTable, 6> sobol_tables;  // of dimensions 2 to 7
inline constexpr int first_sobol_table = 2;

/// Multiplies by Pascal's triangle modulo 2, the Kronecker power of (1 0; 1 1), one step per factor.
[[gnu::always_inline]] constexpr std::uint32_t PascalOf(std::uint32_t bits) {
  bits ^= (bits & 0xaaaaaaaa) >> 1;
  bits ^= (bits & 0xcccccccc) >> 2;
  bits ^= (bits & 0xf0f0f0f0) >> 4;
  bits ^= (bits & 0xff00ff00) >> 8;
  bits ^= (bits & 0xffff0000) >> 16;
  return bits;
}

/// Returns a coordinate of the plain sequence, neither shuffled nor scrambled: a fraction in units of 2^-32, with its
/// bits reversed.
[[gnu::always_inline]] inline std::uint32_t ReversedSobolBits(std::uint32_t index, int dimension) {
  if (dimension == 0) return index;
  if (dimension == 1) return PascalOf(index);
  const SobolTable& table = sobol_tables[static_cast<std::size_t>(dimension - first_sobol_table)];
  return table[0][index & 0xff] ^ table[1][(index >> 8) & 0xff] ^ table[2][(index >> 16) & 0xff] ^
         table[3][index >> 24];
}

/// Returns the number in the sequence of point `index` after the shuffle by `order`.
[[gnu::always_inline]] inline std::uint32_t ShuffledIndex(std::uint32_t index, std::uint32_t order) {
  return ReversedBits(OwenReversed(ReversedBits(index), order));
}

/// A point of the first dimensions of Sobol's sequence, shuffled and scrambled: among any 2^k points that start at a
/// multiple of 2^k, each pair of the first two dimensions has one point in every box of area 2^-k whose sides are
/// powers of two, and further dimensions are nearly as well stratified together. Two sequences with different seeds are
/// paired at random.
///   accuracy   coordinates are multiples of 2^-32, so the sequence repeats after 2^32 points
///   source     Sobol', On the distribution of points in a cube (1967), with the direction numbers of Joe and Kuo,
///              Constructing Sobol sequences with better two-dimensional projections (2008); scrambled after Owen,
///              Randomly permuted (t,m,s)-nets (1995), by hashing as Laine and Karras, Stratified sampling for
///              stochastic transparency (2011), and Burley, Practical hash-based Owen scrambling (2020)
class Sobol {
 public:
  static constexpr int dimensions = 8;

  /// Makes point `index` of the sequence shuffled by `order`; scrambling takes one seed per coordinate.
  [[gnu::always_inline]] Sobol(std::uint32_t index, std::uint32_t order) : index_(ShuffledIndex(index, order)) {}
  /// Returns a coordinate in [0, 1); dimension 0 to dimensions - 1.
  [[gnu::always_inline]] double Coordinate(int dimension, std::uint32_t seed) const {
    return ReversedBits(OwenReversed(ReversedSobolBits(index_, dimension), seed)) * 0x1p-32;
  }

 private:
  std::uint32_t index_;  // in the unshuffled sequence
};

}  // namespace ray
