#include "source/integrate/PathFront.h"

#include <algorithm>

#include "R3/Numeric.h"
#include "R3/Warp.h"
#include "source/integrate/MisWeight.h"
#include "source/integrate/RussianRoulette.h"
#include "source/integrate/shading/PhongColumns.h"

namespace ray {
namespace {

using Each = LightSamples::Each;

/// Computes cosines of N and the way to the light.
R3_VECTORIZED
void MakeCosines(const R1::Columns<R3::Vector>& normals, const LightSamples& samples, Each& cosines) {
  for (std::uint32_t i = 0; i < samples.count; ++i) cosines[i] = Dot(normals[i], BranchlessUnit(samples.to_light[i]));
}

}  // namespace

void PathFront::MakeColumns(const MaterialTraitsOf& traits, const TraceSettings& settings) {
  const auto count = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const ShadingPoint& p = points[i];
    indices[i] = p.path.index;
    normals.Set(i, p.N);
    kd.Set(i, p.kd);
    throughputs.Set(i, p.path.throughput);
    clearances[i] = p.departure.clearance;
    const bool is_diffuse = traits[*p.material].is_diffuse;
    diffuse_flags[i] = is_diffuse ? 1 : 0;
    if (is_diffuse) continue;
    others.push_back(i);
    bsdfs.emplace_back(p, settings);
  }
}

void PathFront::MakeColumnsOfHighlights(const MaterialTraitsOf& traits) {
  has_highlights = false, exponent_bits = 0;
  others_by_phong.clear();
  const auto count = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const Material& m = *points[i].material;
    const MaterialTraits& t = traits[m];
    has_highlights |= t.has_highlight;
    wo.Set(i, points[i].wo);
    ks.Set(i, m.ks);
    exponents[i] = t.exponent;
    exponent_bits |= t.exponent;
    if (!t.is_in_columns) others_by_phong.push_back(i);
  }
}

R3_VECTORIZED
void PathFront::ReflectDiffusely(double most_weight, const Each& pdfs, LightSamples& samples) const {
  alignas(64) Each cosines;
  MakeCosines(normals, samples, cosines);
  R1::Columns<R2::Color> colors;  // separate arrays, which obviously do not overlap
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const double cosine_pdf = R3::CosineHemispherePdf(cosines[i]);
    const double weight = 1 - std::min(most_weight, MisWeight(cosine_pdf, pdfs[i]));
    const R2::Color color = samples.color[i], eval = cosine_pdf * kd[i];
    const double cosine_if_sampled = pdfs[i] > 0 ? cosines[i] : 0;
    const R2::Color reflected = Chosen(cosine_if_sampled > 0, weight * eval * color, {});
    colors.Set(i, Chosen(diffuse_flags[i] > 0, reflected, color));
  }
  for (std::uint32_t i = 0; i < samples.count; ++i) samples.color.Set(i, colors[i]);
}

R3_VECTORIZED
PathFront::Scattered PathFront::ScatterDiffusely(double least_survival, const PointBatch<4>& random) const {
  Scattered scattered;
  const auto& [u, v, of_lobe, choices] = random.coordinates;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) scattered.directions.Set(i, DiffuseDirection(normals[i], {u[i], v[i]}));
  for (std::size_t i = 0; i < count; ++i) {
    const double pdf = R3::CosineHemispherePdf(Dot(normals[i], scattered.directions[i]));
    const R2::Color throughput = throughputs[i] * (pdf * kd[i]) / pdf;
    const double survival = std::max(least_survival, SurvivalProbability(throughput));
    // Nested, since g++ does not vectorize several conditions in one.
    const double if_above = pdf > 0 ? survival : 0, if_reflected = Luminance(kd[i]) > 0 ? if_above : 0;
    const bool continues = choices[i] < (diffuse_flags[i] > 0 ? if_reflected : 0);
    scattered.pdfs[i] = pdf;
    scattered.throughputs.Set(i, Chosen(continues, throughput / survival, {}));
  }
  return scattered;
}

}  // namespace ray
