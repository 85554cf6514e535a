#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ray {

/// A reader of binary numbers with a given byte order from a file in memory.
class Bytes {
 public:
  Bytes(std::string_view bytes, std::size_t offset, std::endian order)
      : bytes_(bytes), offset_(offset), is_swapped_(order != std::endian::native) {}

  std::size_t Offset() const { return offset_; }
  std::size_t Left() const { return bytes_.size() - offset_; }

  /// Reads a number; Left() must be at least sizeof(T).
  template <class T>
  T Next() {
    static_assert(std::is_arithmetic_v<T>);
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + offset_, sizeof(T));
    offset_ += sizeof(T);
    if (is_swapped_)
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    return std::bit_cast<T>(raw);
  }

  void Skip(std::size_t count) { offset_ += count; }

 private:
  std::string_view bytes_;
  std::size_t offset_;
  bool is_swapped_;
};

}  // namespace ray
