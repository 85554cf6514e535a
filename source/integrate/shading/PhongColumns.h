#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "source/integrate/shading/Bsdf.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// Whether PhongColumns know what a material is like; they have no coats.
inline bool IsInPhongColumns(const Material& m) { return m.coat == 0 && (IsBlack(m.ks) || R1::IsWholeExponent(m.n)); }

/// What is asked of the material of each of many points.
struct MaterialTraits {
  bool is_diffuse;         // alone
  bool is_in_columns;      // PhongColumns know all of it
  bool has_highlight;      // by Phong's formula
  std::uint64_t exponent;  // of a highlight in PhongColumns; 0 where there is none

  explicit MaterialTraits(const Material& m);
};
/// The traits of all materials of a scene, found once.
class MaterialTraitsOf {
 public:
  /// `materials` outlive it.
  explicit MaterialTraitsOf(std::span<const Material> materials)
      : first_(materials.data()), traits_(materials.begin(), materials.end()) {}

  /// The traits of one of the materials.
  const MaterialTraits& operator[](const Material& m) const { return traits_[static_cast<std::size_t>(&m - first_)]; }

 private:
  const Material* first_;
  std::vector<MaterialTraits> traits_;
};

/// What Phong's formula asks of many surfaces, none with a coat or a specular map.
struct PhongColumns {
  const R1::Columns<R3::Vector>&N, &wo;
  const R1::Columns<R2::Color>&kd, &ks;
  const std::uint64_t* exponents;  // of those whose ks is not black
  std::uint64_t exponent_bits;     // that any of them has
  bool has_highlights;
};

/// Makes PhongReflection of the color of each sample, one of each surface.
void ReflectByPhong(const PhongColumns& surfaces, LightSamples& samples);
/// Makes of the color of each sample, all seen from one point, the weight times PhongReflection.
void ReflectByPhong(const ShadingPoint& p, double weight, LightSamples& samples);

}  // namespace ray
