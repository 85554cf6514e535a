#include "source/sample/Sobol.h"

namespace ray {
namespace {

/// One dimension's primitive polynomial over two elements and the first of its odd numbers m.
struct Polynomial {
  int degree;
  std::uint32_t inner;  // the coefficients between the first and the last, which are 1
  std::array<std::uint32_t, 5> m;
};

// Dimensions 0 and 1 need no table. These are 2 to 7.
constexpr int first_in_table = 2;
constexpr std::array<Polynomial, Sobol::dimensions - first_in_table> polynomials{{{2, 1, {1, 3}},
                                                                                  {3, 1, {1, 3, 1}},
                                                                                  {3, 2, {1, 1, 1}},
                                                                                  {4, 1, {1, 1, 3, 3}},
                                                                                  {4, 4, {1, 3, 5, 13}},
                                                                                  {5, 2, {1, 1, 5, 5, 17}}}};

constexpr std::array<std::uint32_t, 32> Directions(const Polynomial& p) {
  std::array<std::uint32_t, 32> v{};
  for (int i = 0; i < 32; ++i) {
    if (i < p.degree) {
      v[static_cast<std::size_t>(i)] = p.m[static_cast<std::size_t>(i)] << (31 - i);
      continue;
    }
    const std::uint32_t oldest = v[static_cast<std::size_t>(i - p.degree)];
    std::uint32_t next = oldest ^ (oldest >> p.degree);
    for (int k = 1; k < p.degree; ++k)
      if ((p.inner >> (p.degree - 1 - k)) & 1) next ^= v[static_cast<std::size_t>(i - k)];
    v[static_cast<std::size_t>(i)] = next;
  }
  return v;
}

/// What each byte of an index contributes.
using ByteTable = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr ByteTable TableOf(const Polynomial& p) {
  const auto v = Directions(p);
  ByteTable table{};
  for (std::size_t byte = 0; byte < 4; ++byte)
    for (std::size_t value = 1; value < 256; ++value) {
      std::size_t top = 7;
      while (!((value >> top) & 1)) --top;
      table[byte][value] = table[byte][value ^ (std::size_t{1} << top)] ^ v[8 * byte + top];
    }
  return table;
}

constexpr std::array<ByteTable, polynomials.size()> tables{TableOf(polynomials[0]), TableOf(polynomials[1]),
                                                           TableOf(polynomials[2]), TableOf(polynomials[3]),
                                                           TableOf(polynomials[4]), TableOf(polynomials[5])};

/// Dimension 1 is Pascal's triangle modulo 2, the Kronecker power of (1 1; 0 1): one step a factor.
constexpr std::uint32_t PascalOf(std::uint32_t bits) {
  bits ^= (bits & 0x55555555) << 1;
  bits ^= (bits & 0x33333333) << 2;
  bits ^= (bits & 0x0f0f0f0f) << 4;
  bits ^= (bits & 0x00ff00ff) << 8;
  bits ^= (bits & 0x0000ffff) << 16;
  return bits;
}

}  // namespace

std::uint32_t SobolBits(std::uint32_t index, std::uint32_t reversed, int dimension) {
  if (dimension == 0) return reversed;
  if (dimension == 1) return PascalOf(reversed);
  const ByteTable& table = tables[static_cast<std::size_t>(dimension - first_in_table)];
  return table[0][index & 0xff] ^ table[1][(index >> 8) & 0xff] ^ table[2][(index >> 16) & 0xff] ^
         table[3][index >> 24];
}

}  // namespace ray
