#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace ray {

/// Memory for many plain values, not initialized. Large ones ask for huge pages: a walk through a tree of 60 MB misses
/// the translation buffer at every step otherwise, which costs a tenth to a quarter of its time.
template <typename T>
class HugeArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  HugeArray() = default;
  explicit HugeArray(std::size_t size) : size_(size) {
    if (size == 0) return;
    constexpr std::size_t huge_page = std::size_t{1} << 21, line = 64;
    const std::size_t alignment = Bytes() >= 2 * huge_page ? huge_page : line;
    const std::size_t bytes = (Bytes() + alignment - 1) / alignment * alignment;
    data_.reset(static_cast<T*>(std::aligned_alloc(alignment, bytes)));
    if (!data_) throw std::bad_alloc();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (alignment == huge_page) madvise(data_.get(), bytes, MADV_HUGEPAGE);  // a wish: failing changes nothing
#endif
  }

  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }
  T* Data() { return data_.get(); }
  const T* Data() const { return data_.get(); }
  std::size_t Size() const { return size_; }
  std::size_t Bytes() const { return size_ * sizeof(T); }

 private:
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  std::unique_ptr<T, Free> data_;
  std::size_t size_ = 0;
};

}  // namespace ray
