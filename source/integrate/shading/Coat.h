#pragma once

namespace ray {

/// A clear coat over a diffuse base, with an index of refraction n relative to 1 outside. It reflects the fraction R(c)
/// of light at an angle of cosine c, and the base under it scatters with the BRDF
///     kd / pi  21/20 (1 - R0) (1 - (1 - c)^5) (1 - (1 - c')^5),      R(c) = R0 + (1 - R0) (1 - c)^5,
/// R0 = ((n - 1) / (n + 1))^2, c' the cosine of the other direction. It is reciprocal, and the factor 21/20 makes a
/// base of kd 1 scatter all light that is not reflected: the integral of (1 - (1 - c')^5) c' over the hemisphere is 20
/// pi / 21.
///   source   Schlick, An inexpensive BRDF model for physically-based rendering (1994), eq. 15, for R;
///            Shirley, Smits, Hu, Lafortune, A practitioners' assessment of light reflection models (1997), section 5.2
class Coat {
 public:
  explicit Coat(double index) : at_normal_((index - 1) / (index + 1) * ((index - 1) / (index + 1))) {}

  /// Returns R for a cosine in [0, 1].
  double Reflectance(double cosine) const { return at_normal_ + (1 - at_normal_) * FifthPower(1 - cosine); }
  /// Returns the factor of kd for light that enters and leaves at these cosines, in [0, 1].
  double DiffuseShare(double in, double out) const {
    return 21.0 / 20 * (1 - at_normal_) * (1 - FifthPower(1 - in)) * (1 - FifthPower(1 - out));
  }

 private:
  static double FifthPower(double x) { return x * x * (x * x) * x; }

  double at_normal_;  // R0
};

}  // namespace ray
