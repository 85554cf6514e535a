#pragma once

#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

/// Error handling for libjpeg and libpng, whose error callbacks must not return. Exceptions must not pass through their
/// C frames, so longjmp leaves those frames, and our side throws the exception.
namespace R2 {

/// The point where execution continues after an error, and the library's message.
struct Jump {
  std::jmp_buf place;
  char message[256] = "";

  /// Called from the library's error callback. No object with a destructor may live between here and Completes.
  [[noreturn]] void Leave(const char* why) {
    std::strncpy(message, why, sizeof(message) - 1);
    std::longjmp(place, 1);
  }
};

/// Returns true if `call`, which may only call the library, ran to its end. A jump skips destructors, so `call` must
/// neither have one nor create objects that do.
template <typename Call>
bool Completes(Jump& jump, const Call& call) {
  static_assert(std::is_trivially_destructible_v<Call>);
  if (setjmp(jump.place)) return false;
  call();
  return true;
}

/// Appends bytes, for callbacks from a C library. Returns false if memory ran out, since bad_alloc must not reach the
/// library either.
inline bool Append(std::vector<unsigned char>& bytes, const unsigned char* more, std::size_t count) noexcept {
  try {
    bytes.insert(bytes.end(), more, more + count);
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace R2
