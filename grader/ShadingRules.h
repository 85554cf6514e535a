#pragma once

namespace ray::grade {

/// What a student's program does differently from the surface equation. The defaults are the equation.
struct ShadingRules {
  enum class Normal { exact, by_matrix, untransformed, inward, not_facing, flat, not_normalized };
  enum class Cosine { clamped, absolute, none };
  enum class Shadow { exact, beyond_light, of_next_light };
  enum class Lights { all, first, last };

  Normal normal = Normal::exact;
  Cosine cosine = Cosine::clamped;
  Shadow shadow = Shadow::exact;
  Lights lights = Lights::all;
  bool half_vector = false;          // (N.H)^n instead of (V.R)^n
  bool highlight_in_shadow = false;  // added whether or not the light is seen
  bool always_leaves_glass = false;  // the index of refraction is that of leaving, or of entering, on both sides
  bool leaving_is_entering = false;

  friend bool operator==(const ShadingRules&, const ShadingRules&) = default;
};

}  // namespace ray::grade
