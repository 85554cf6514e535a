#include "source/integrate/shading/PhongColumns.h"

#include "R3/Numeric.h"
#include "R3/Vector.h"

namespace ray {
namespace {

struct PhongSurface {
  R3::Vector N, wo;
  R2::Color kd, ks;
  R2::Color shown{1, 1, 1};  // from a specular map
};

/// The exponent of a single surface. Computes powers like R1::WholePower, bit for bit.
struct OneExponent {
  std::uint64_t exponent;

  [[gnu::always_inline]] void Raise(std::uint32_t count, double* __restrict cosines, double* __restrict powers) const {
    for (std::uint64_t rest = exponent; rest != 0; rest >>= 1) {
      if (rest & 1)
        for (std::uint32_t i = 0; i < count; ++i) powers[i] *= cosines[i];
      if (rest > 1)
        for (std::uint32_t i = 0; i < count; ++i) cosines[i] *= cosines[i];
    }
  }
};

/// One exponent per sample. Computes powers like R1::WholePower, bit for bit.
struct ExponentPerSample {
  const std::uint64_t* exponents;
  std::uint64_t bits;  // set in any of them

  [[gnu::always_inline]] void Raise(std::uint32_t count, double* __restrict cosines, double* __restrict powers) const {
    for (int bit = 0; bits >> bit != 0; ++bit)
      for (std::uint32_t i = 0; i < count; ++i) {
        powers[i] *= exponents[i] >> bit & 1 ? cosines[i] : 1;
        cosines[i] *= cosines[i];
      }
  }
};

/// Replaces the color of each sample by the weight times PhongReflection, bit for bit.
///   surface_of   returns the surface of a sample, by its number
template <typename SurfaceOf, typename Exponents>
[[gnu::always_inline]] inline void ReflectEach(const SurfaceOf& surface_of, const Exponents& exponents,
                                               bool has_highlights, double weight, LightSamples& __restrict samples) {
  const std::uint32_t count = samples.count;
  const double most = has_highlights ? 1 : 0;
  alignas(64) LightSamples::Each cosine, mirrored, lobe;
  for (std::uint32_t i = 0; i < count; ++i) {
    const PhongSurface s = surface_of(i);
    const R3::Vector L = BranchlessUnit(samples.to_light[i]);
    // A black surface reflects nothing of infinite light: the product would be NaN.
    const R2::Color both = s.kd + s.ks;
    cosine[i] = both.r + both.g + both.b > 0 ? Dot(s.N, L) : 0;
    mirrored[i] = LobeCosine(s.wo, s.N, L);
    lobe[i] = mirrored[i] > 0 ? most : 0;
  }
  exponents.Raise(count, mirrored, lobe);
  for (std::uint32_t i = 0; i < count; ++i) {
    const PhongSurface s = surface_of(i);
    samples.color.Set(i, weight * PhongSum(cosine[i], s.kd, s.shown * (s.ks * lobe[i]), samples.color[i]));
  }
}

R3_VECTORIZED
void ReflectOfOne(const ShadingPoint& p, const R2::Color& shown, double weight, LightSamples& samples) {
  const PhongSurface surface{p.N, p.wo, p.kd, p.material->ks, shown};
  const bool has_highlight = !IsBlack(surface.ks);
  const std::uint64_t exponent = has_highlight ? static_cast<std::uint64_t>(p.material->n) : 0;
  ReflectEach([=](std::uint32_t) { return surface; }, OneExponent{exponent}, has_highlight, weight, samples);
}

}  // namespace

MaterialTraits::MaterialTraits(const Material& m)
    : is_diffuse(IsDiffuse(m)),
      is_in_columns(IsInPhongColumns(m) && !m.specular_map),
      has_highlight(!IsBlack(m.ks)),
      exponent(is_in_columns && has_highlight ? static_cast<std::uint64_t>(m.n) : 0) {}

R3_VECTORIZED
void ReflectByPhong(const PhongColumns& surfaces, LightSamples& samples) {
  const auto surface_of = [&](std::uint32_t i) {
    return PhongSurface{surfaces.N[i], surfaces.wo[i], surfaces.kd[i], surfaces.ks[i]};
  };
  ReflectEach(surface_of, ExponentPerSample{surfaces.exponents, surfaces.exponent_bits}, surfaces.has_highlights, 1,
              samples);
}

void ReflectByPhong(const ShadingPoint& p, double weight, LightSamples& samples) {
  if (IsInPhongColumns(*p.material)) return ReflectOfOne(p, p.Shown(), weight, samples);
  for (std::uint32_t i = 0; i < samples.count; ++i)
    samples.color.Set(i, weight * PhongReflection(p, Unit(samples.to_light[i]), samples.color[i]));
}

}  // namespace ray
