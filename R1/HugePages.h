#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace R1 {

inline constexpr std::size_t huge_page = std::size_t{1} << 21;  // bytes

/// Requests huge pages for large data. Otherwise rays that jump around in 100 MB miss the translation buffer at every
/// step, which costs a tenth to a quarter of their time. A hint only: it affects nothing but speed, and does nothing on
/// systems without huge pages.
inline void PreferHugePages(const void* data, std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  const auto begin = (reinterpret_cast<std::uintptr_t>(data) + huge_page - 1) / huge_page * huge_page;
  const auto end = (reinterpret_cast<std::uintptr_t>(data) + bytes) / huge_page * huge_page;
  if (begin + huge_page > end) return;
  constexpr int collapse = 25;  // MADV_COLLAPSE of Linux 6.1 also moves existing data
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  madvise(reinterpret_cast<void*>(begin), end - begin, collapse);
#else
  static_cast<void>(data), static_cast<void>(bytes);
#endif
}

/// Reserves room for `size` elements of an array that is still to be filled. Memory on huge pages from the start need
/// not be moved there later.
template <typename Array>
void ReserveOnHugePages(Array& array, std::size_t size) {
  array.reserve(size);
  PreferHugePages(array.data(), array.capacity() * sizeof(typename Array::value_type));
}

}  // namespace R1
