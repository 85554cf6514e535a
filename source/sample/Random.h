#pragma once

#include <cstdint>

#include "R2/Point.h"

namespace ray {

inline constexpr double below_one = 1 - 0x1p-53;  // the largest random number, below 1

/// A key for stateless random numbers: a number is a function of where it is used. A key stands for one use (seed,
/// pixel, sample, bounce, light ...) and is hashed from the key of the enclosing one.
class RandomKey {
 public:
  // Mixed twice: with one mix, child b of seed a would equal child a of seed b, and child a of seed a would be the same
  // for all.
  explicit RandomKey(std::uint64_t seed) : bits_(Mix(Mix(seed + golden) + golden)) {}

  /// Returns the child key with number `which`.
  RandomKey Child(std::uint64_t which) const { return RandomKey(Raw{}, Mix(bits_ ^ Mix(which + golden))); }

  std::uint64_t Bits() const { return bits_; }
  /// Returns the key with the given bits.
  static RandomKey FromBits(std::uint64_t bits) { return {Raw{}, bits}; }
  /// Returns a number uniform in [0, 1): 53 random bits.
  double Number() const { return static_cast<double>(bits_ >> 11) * 0x1p-53; }

 private:
  struct Raw {};
  RandomKey(Raw, std::uint64_t bits) : bits_(bits) {}

  static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 / the golden ratio

  /// Applies a bijection of 64 bits in which every output bit depends on every input bit.
  /// Source: Stafford, Better bit mixing (2011), variant 13, as used by Steele, Lea, Flood, Fast splittable
  /// pseudorandom number generators (2014).
  static constexpr std::uint64_t Mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t bits_;
};

/// A shuffle of 0 ... count - 1, chosen by the key.
///   source   Kensler, Correlated multi-jittered sampling (2013): a bijection of the next power of two, walked along
///            its cycle until it lands inside the range
class Shuffle {
 public:
  Shuffle(std::uint32_t count, const RandomKey& key);
  /// Returns the new position of `index`; index < count.
  std::uint32_t operator()(std::uint32_t index) const;

 private:
  std::uint32_t count_, mask_;
  int half_;
  std::uint64_t salts_[2];
};

/// A set of `count` points in [0, 1)^2 that are stratified over the unit square. The square is divided into rows, as
/// many as the root of `count`, with heights proportional to their numbers of points, and each row into cells of equal
/// width; every cell contains one random point. All cells have area 1 / count for any count, so averages are unbiased.
/// The key shuffles the order of the cells, so that two sets with different keys are paired at random.
///   source   Cook, Porter, Carpenter, Distributed ray tracing (1984), jittering
class Stratified {
 public:
  Stratified(std::uint32_t count, const RandomKey& key);
  R2::Point operator[](std::uint32_t index) const;

 private:
  template <typename Whole>
  R2::Point InCell(Whole cell, std::uint32_t index) const;

  std::uint32_t count_, rows_;
  RandomKey jitter_;
  Shuffle shuffle_;
};

}  // namespace ray
