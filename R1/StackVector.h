#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <type_traits>

namespace R1 {

/// A vector of plain values that uses no heap for up to `most_inside` of them, for functions called for every ray.
template <typename T, std::size_t most_inside>
class StackVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  StackVector() = default;
  StackVector(const StackVector&) = delete;

  void push_back(const T& value) {
    if (size_ == room_) [[unlikely]]
      Reserve(2 * room_);
    std::construct_at(values_ + size_++, value);
  }
  /// Sets the contents to `count` copies of `value`.
  void assign(std::size_t count, const T& value) {
    if (count > room_) [[unlikely]]
      Reserve(count);
    for (size_ = 0; size_ < count; ++size_) std::construct_at(values_ + size_, value);
  }
  /// Drops all values from `count` on.
  void truncate(std::size_t count) { size_ = count; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  T& back() { return values_[size_ - 1]; }
  T* begin() { return values_; }
  T* end() { return values_ + size_; }
  const T* begin() const { return values_; }
  const T* end() const { return values_ + size_; }

 private:
  void Reserve(std::size_t room) {
    std::unique_ptr<std::byte[]> wider(new std::byte[room * sizeof(T)]);
    std::memcpy(wider.get(), values_, size_ * sizeof(T));
    outside_ = std::move(wider);
    values_ = reinterpret_cast<T*>(outside_.get());
    room_ = room;
  }

  alignas(T) std::byte inside_[most_inside * sizeof(T)];
  std::unique_ptr<std::byte[]> outside_;
  T* values_ = reinterpret_cast<T*>(inside_);
  std::size_t size_ = 0, room_ = most_inside;
};

}  // namespace R1
