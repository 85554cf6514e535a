#pragma once

#include <optional>

#include "R2/Color.h"

namespace ray::grade {

/// Deviations of a student's program from the surface equation. The defaults are the equation.
struct ShadingRules {
  enum class Normal {
    exact,
    by_matrix,
    by_inverse,
    untransformed,
    inward,
    not_facing,
    flat,
    stretched,  // unit before it is transformed
    not_normalized
  };
  enum class Cosine { clamped, absolute, none, squared };
  enum class Shadow { exact, beyond_light, of_next_light };
  enum class Lights { all, first, last };
  enum class Fading { divided, multiplied, of_square };  // by or with ca + la d + qa d^2; d^2 instead of d
  enum class Mirror { exact, opposite, wrong_sign };     // the direction R; -R; d + 2 (d.N) N

  Normal normal = Normal::exact;
  Cosine cosine = Cosine::clamped;
  Shadow shadow = Shadow::exact;
  Lights lights = Lights::all;
  Fading fading = Fading::divided;
  Mirror mirror = Mirror::exact;
  bool spot_is_linear = false;       // a spot light fades with the angle instead of a power of the cosine
  bool half_vector = false;          // (N.H)^n instead of (V.R)^n
  bool highlight_opposite = false;   // (V.-R)^n
  bool highlight_in_shadow = false;  // added even if the light is occluded
  bool highlight_behind = false;     // added where N.L is negative
  bool highlight_by_cosine = false;  // multiplied by N.L
  bool always_leaves_glass = false;  // the index of refraction is that of leaving, or of entering, on both sides
  bool leaving_is_entering = false;
  bool mirror_replaces = false;  // the surface's own color is multiplied by 1 - kr, or by 1 - kt
  bool glass_replaces = false;
  bool behind_the_eye = false;  // camera rays hit what is behind the eye first
  // The background that camera rays see, if it differs from that of other rays.
  std::optional<R2::Color> camera_background;

  friend bool operator==(const ShadingRules&, const ShadingRules&) = default;
};

/// The choice among all hits of a ray, if a program does not choose the nearest one.
struct DepthRules {
  enum class Choice { nearest, first_in_file, last_in_file, by_local_length };

  Choice choice = Choice::nearest;
  bool far_side_of_spheres = false;
  bool glass_casts_no_shadow = false;

  friend bool operator==(const DepthRules&, const DepthRules&) = default;
};

}  // namespace ray::grade
