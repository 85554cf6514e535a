#pragma once

/// What tests allow for where a sanitizer was compiled into them and into the programs that they run, by make asan and
/// make tsan.
namespace project {

// g++ defines macros, clang has features.
#if defined(__has_feature)
#define RAYTESTS_HAS_FEATURE(feature) __has_feature(feature)
#else
#define RAYTESTS_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || RAYTESTS_HAS_FEATURE(address_sanitizer)
#define RAYTESTS_ADDRESS_SANITIZER
inline constexpr bool has_address_sanitizer = true;
#else
inline constexpr bool has_address_sanitizer = false;
#endif
#if defined(__SANITIZE_THREAD__) || RAYTESTS_HAS_FEATURE(thread_sanitizer)
inline constexpr bool has_thread_sanitizer = true;
#else
inline constexpr bool has_thread_sanitizer = false;
#endif
#undef RAYTESTS_HAS_FEATURE

/// Sanitizers make a program several times slower; limits of time are multiplied by this.
inline constexpr int patience = has_address_sanitizer || has_thread_sanitizer ? 10 : 1;

}  // namespace project

/// First lines of tests that a sanitizer makes impossible: they are skipped, and the summary of the tests says why.
#define NEEDS_NO_SANITIZER(reason) \
  if (project::has_address_sanitizer || project::has_thread_sanitizer) GTEST_SKIP() << "with a sanitizer, " reason
#define NEEDS_NO_THREAD_SANITIZER(reason) \
  if (project::has_thread_sanitizer) GTEST_SKIP() << "with ThreadSanitizer, " reason
