#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#include "R1/HugePages.h"

namespace ray {

/// An uninitialized array of many plain values, on huge pages if it fills at least half of one.
template <typename T>
class HugeArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  HugeArray() = default;
  explicit HugeArray(std::size_t size) : size_(size) {
    if (size == 0) return;
    constexpr std::size_t line = 64;
    const std::size_t alignment = Bytes() >= R1::huge_page / 2 ? R1::huge_page : line;
    const std::size_t bytes = (Bytes() + alignment - 1) / alignment * alignment;
    data_.reset(static_cast<T*>(std::aligned_alloc(alignment, bytes)));
    if (!data_) throw std::bad_alloc();
    R1::PreferHugePages(data_.get(), bytes);
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
