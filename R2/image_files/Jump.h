#pragma once

#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

/// How libjpeg and libpng report errors: they call back and never expect a return. An exception must not pass
/// through their C frames, so they are left by longjmp, and the exception is thrown on our side.
namespace R2 {

/// Where to continue after an error, and the library's message.
struct Jump {
  std::jmp_buf place;
  char message[256] = "";

  /// For the library's error callback. Nothing between here and Completes may have a destructor.
  [[noreturn]] void Leave(const char* why) {
    std::strncpy(message, why, sizeof(message) - 1);
    std::longjmp(place, 1);
  }
};

/// Whether `call`, which may only call the library, ran to its end. A jump skips destructors; `call` itself has
/// none, and must not make objects that do.
template <typename Call>
bool Completes(Jump& jump, const Call& call) {
  static_assert(std::is_trivially_destructible_v<Call>);
  if (setjmp(jump.place)) return false;
  call();
  return true;
}

/// Adds bytes at the end, for callbacks that a C library calls. False when memory ran out, since bad_alloc must not
/// reach the library either.
inline bool Append(std::vector<unsigned char>& bytes, const unsigned char* more, std::size_t count) noexcept {
  try {
    bytes.insert(bytes.end(), more, more + count);
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace R2
