#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "source/integrate/modes/FirstHit.h"
#include "source/integrate/shading/Bsdf.h"

namespace ray {
namespace {

constexpr R2::Color paper{1, 1, 1}, ink{0, 0, 0};

/// Strokes of one direction.
struct Strokes {
  R2::Vector across;     // unit, from stroke to stroke
  double begins, fills;  // range of darkness in which its strokes grow to full width
};
// The second layer crosses the first in dark places, the others in darker ones.
constexpr double diagonal = std::numbers::sqrt2 / 2;
constexpr std::array layers{Strokes{{diagonal, -diagonal}, 0.08, 0.55}, Strokes{{diagonal, diagonal}, 0.4, 0.8},
                            Strokes{{0, 1}, 0.65, 0.95}, Strokes{{1, 0}, 0.85, 1.2}};
constexpr double full_width = 0.6;  // of a stroke, in spacings

/// Returns true if a place of the image, in spacings of strokes, is inked at this darkness, from 0 to 1. Strokes waver
/// by a ninth of a spacing over about thirteen, each differently, like lines drawn by hand.
bool IsInked(const R2::Point& place, double shade) {
  return std::ranges::any_of(layers, [&](const Strokes& layer) {
    if (!(shade > layer.begins)) return false;
    const double width = full_width * std::min(1.0, (shade - layer.begins) / (layer.fills - layer.begins));
    const double along = layer.across.x * place.y - layer.across.y * place.x;
    const double across = layer.across.x * place.x + layer.across.y * place.y;
    constexpr double reach = 1.0 / 9, rate = 1.0 / 13, from_stroke_to_stroke = 0.37;  // turns
    const double turns = rate * along + from_stroke_to_stroke * std::round(across);
    const double wavering = across + reach * R1::SinCosTurns(turns - std::floor(turns)).sine;
    return std::abs(wavering - std::round(wavering)) < width / 2;
  });
}

/// A drawing in ink: evenly spaced strokes on the image that are wider where less light arrives; in dark places others
/// cross them. The light is that of Phong's model without shadows, with area lights at their middle.
///   source   Winkenbach, Salesin, Computer-generated pen-and-ink illustration (1994), for tone by prioritized strokes;
///            Praun, Hoppe, Webb, Finkelstein, Real-time hatching (2001), for layers that stay when others are added
class Hatching : public FirstHit {
 public:
  Hatching(const World& world, const Accelerator& accelerator, double spacing)
      : FirstHit(world, accelerator), spacing_(spacing) {}

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override {
    FirstHit::Li(samples, radiances, state);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const R2::Point place{samples[i].x / spacing_, samples[i].y / spacing_};
      radiances[i] = IsInked(place, 1 - std::clamp(Luminance(radiances[i]), 0.0, 1.0)) ? ink : paper;
    }
  }

 private:
  R2::Color Seen(const ShadingPoint& p) const override {
    R2::Color sum = p.EmittedAndAmbient(world());
    for (const auto& light : world().scene().lights)
      if (const auto sample = light->Illuminate(p.free_point, {0.5, 0.5})) {
        const R3::Vector L = Unit(sample->to_light);
        sum += (std::max(0.0, Dot(p.N, L)) * p.kd + Highlight(p, L)) * sample->irradiance;
      }
    return sum;
  }
  R2::Color Missed(const R3::Vector&) const override { return paper; }

  double spacing_;  // of strokes, in pixels
};

}  // namespace

extern const IntegratorKind hatching_kind{"a drawing in ink: strokes where less light arrives, crossed in the dark",
                                          [](const World& world, const Accelerator& accelerator,
                                             const TraceSettings& settings) -> std::unique_ptr<const Integrator> {
                                            return std::make_unique<Hatching>(world, accelerator,
                                                                              settings.hatch_spacing);
                                          }};

}  // namespace ray
