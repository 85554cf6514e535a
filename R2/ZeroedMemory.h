#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

namespace R2 {

/// An allocator of numbers that start as 0 without being written. The system supplies large zeroed memory page by page,
/// to whichever thread touches a page first; a loop over 800 MB would make one thread wait for all of it. Containers
/// that shrink and grow again find their old values there.
template <typename T>
struct ZeroedMemory {
  using value_type = T;

  ZeroedMemory() = default;
  template <typename U>
  ZeroedMemory(const ZeroedMemory<U>&) {}

  T* allocate(std::size_t count) {
    void* memory = std::calloc(count, sizeof(T));  // rejects products that overflow
    if (!memory) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  /// Leaves default-initialized elements as they are: the memory is zeroed.
  template <typename U>
  void construct(U*) {}
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const ZeroedMemory&, const ZeroedMemory&) { return true; }
};

}  // namespace R2
