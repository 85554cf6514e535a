#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "source/integrate/shading/Bsdf.h"
#include "source/scene/LightSamples.h"

namespace ray {

/// Returns true if PhongColumns can represent a material, which must have no coat.
inline bool IsInPhongColumns(const Material& m) { return m.coat == 0 && (IsBlack(m.ks) || R1::IsWholeExponent(m.n)); }

/// The properties of a material that loops over many points need.
struct MaterialTraits {
  bool is_diffuse;         // and nothing else
  bool is_in_columns;      // PhongColumns can represent it
  bool has_highlight;      // of Phong's formula
  std::uint64_t exponent;  // of a highlight in PhongColumns; 0 if there is none

  explicit MaterialTraits(const Material& m);
};
/// The traits of all materials of a scene, found once.
class MaterialTraitsOf {
 public:
  /// `materials` must outlive it.
  explicit MaterialTraitsOf(std::span<const Material> materials)
      : first_(materials.data()), traits_(materials.begin(), materials.end()) {}

  /// Returns the traits of one of the materials.
  const MaterialTraits& operator[](const Material& m) const { return traits_[static_cast<std::size_t>(&m - first_)]; }

 private:
  const Material* first_;
  std::vector<MaterialTraits> traits_;
};

/// The inputs of Phong's formula for many surfaces, none with a coat or a specular map.
struct PhongColumns {
  const R1::Columns<R3::Vector>&N, &wo;
  const R1::Columns<R2::Color>&kd, &ks;
  const std::uint64_t* exponents;  // of surfaces whose ks is not black
  std::uint64_t exponent_bits;     // set in any exponent
  bool has_highlights;
};

/// Replaces the color of each sample by PhongReflection, one of each surface.
void ReflectByPhong(const PhongColumns& surfaces, LightSamples& samples);
/// Replaces the color of each sample, all seen from one point, by the weight times PhongReflection.
void ReflectByPhong(const ShadingPoint& p, double weight, LightSamples& samples);

}  // namespace ray
