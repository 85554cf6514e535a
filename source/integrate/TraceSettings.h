#pragma once

#include <cstdint>

namespace ray {

/// The course's recursion, and where it ends.
struct TraceSettings {
  std::int64_t max_depth = 3;   // bounces after the camera ray, >= 0; beyond most_bounces it is most_bounces
  double min_luminance = 0.01;  // a child ray is traced when its weight's luminance is at least this and above 0
  int shadow_samples = 16;      // rays to each light that has an area, >= 1
  bool shadows = true;
};

/// Hard limits that keep mirrors facing each other, at any max_depth, from running forever. Rays beyond are counted as
/// cut.
inline constexpr int most_bounces = 1000;        // one after another
inline constexpr int most_descendants = 10'000;  // of one camera ray, shadow rays not counted

}  // namespace ray
