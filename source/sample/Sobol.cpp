#include "source/sample/Sobol.h"

namespace ray {
namespace {

/// The primitive polynomial over two elements of one dimension, and the first of its odd numbers m.
struct Polynomial {
  int degree;
  std::uint32_t inner;  // the coefficients between the first and the last, which are 1
  std::array<std::uint32_t, 5> m;
};

// Dimensions 0 and 1 need no table. These are 2 to 7.
constexpr std::array<Polynomial, Sobol::dimensions - first_sobol_table> polynomials{{{2, 1, {1, 3}},
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

constexpr SobolTable TableOf(const Polynomial& p) {
  const auto v = Directions(p);
  SobolTable table{};
  for (std::size_t byte = 0; byte < 4; ++byte)
    for (std::size_t value = 1; value < 256; ++value) {
      std::size_t top = 7;
      while (!((value >> top) & 1)) --top;
      table[byte][value] = table[byte][value ^ (std::size_t{1} << top)] ^ ReversedBits(v[8 * byte + top]);
    }
  return table;
}

}  // namespace

constinit const std::array<SobolTable, 6> sobol_tables{TableOf(polynomials[0]), TableOf(polynomials[1]),
                                                       TableOf(polynomials[2]), TableOf(polynomials[3]),
                                                       TableOf(polynomials[4]), TableOf(polynomials[5])};

}  // namespace ray
