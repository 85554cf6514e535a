#include "source/render/Flare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "R1/Elementary.h"
#include "source/render/SceneFeatures.h"

namespace ray {
namespace {

// Lengths are fractions of the image's height.
constexpr double glow_radius = 0.3, glow_core = 0.02, streak_length = 0.25, streak_width = 0.004;
constexpr int streaks = 6;

/// A disc on the line through the light source and the middle of the image.
struct Ghost {
  double place;  // 1: the source, 0: the middle, -1: opposite the source
  double radius;
  R2::Color color;  // multiplies the arriving light
};
constexpr std::array ghosts{Ghost{0.55, 0.035, {0.05, 0.04, 0.02}},  Ghost{0.25, 0.015, {0.06, 0.07, 0.04}},
                            Ghost{-0.25, 0.05, {0.02, 0.05, 0.03}},  Ghost{-0.5, 0.025, {0.04, 0.04, 0.08}},
                            Ghost{-0.8, 0.09, {0.03, 0.02, 0.04}},   Ghost{-1.15, 0.04, {0.06, 0.03, 0.02}},
                            Ghost{-1.5, 0.14, {0.015, 0.02, 0.035}}};

/// A light source as the camera sees it.
struct Glare {
  R2::Point place;  // in pixels
  R2::Color light;  // arriving light
};

/// Returns the place of a direction in the image, in pixels; std::nullopt if it is outside.
std::optional<R2::Point> PlaceOf(const R3::Vector& direction, const Camera& camera, const RenderSettings& settings) {
  const double depth = Dot(direction, camera.towards);
  if (!(depth > 0)) return {};
  const double half_width = camera.HalfWidth(), half_height = camera.HalfHeight(settings.width, settings.height);
  const double across = Dot(direction, camera.right) / depth / half_width - camera.shift.x;
  const double upward = (Dot(direction, camera.up) / depth - camera.shift.y * half_width) / half_height;
  if (!(std::abs(across) < 1 && std::abs(upward) < 1)) return {};
  return R2::Point{(across + 1) / 2 * settings.width, (upward + 1) / 2 * settings.height};
}

/// Returns point number `i` of `count` points that fill the unit disc evenly.
///   source   Vogel, A better way to construct the sunflower head (1979)
R2::Point OnDisc(int i, int count) {
  const double radius = std::sqrt((i + 0.5) / count);
  const double turns = i * (2 - std::numbers::phi);
  const auto [sine, cosine] = R1::SinCosTurns(turns - std::floor(turns));
  return {radius * cosine, radius * sine};
}

class Flare {
 public:
  Flare(const World& world, const Accelerator& accelerator, const Camera& camera, const RenderSettings& settings)
      : accelerator_(accelerator), camera_(camera), settings_(settings), height_(settings.height) {
    for (const Light* light : ShiningLights(world, settings))
      if (const auto glare = GlareOf(*light)) glares_.push_back(*glare);
  }

  void AddTo(R2::Image& image, const PixelRectangle& region) const {
    for (const Glare& glare : glares_) {
      AddWithin(image, region, glare.place, glow_radius, [&](const R2::Vector& from, double share) {
        return (Glow(share) + Streaks(from, share)) * glare.light;
      });
      for (const Ghost& ghost : ghosts) {
        const R2::Point middle{settings_.width / 2.0, settings_.height / 2.0};
        const R2::Point place{middle.x + ghost.place * (glare.place.x - middle.x),
                              middle.y + ghost.place * (glare.place.y - middle.y)};
        AddWithin(image, region, place, ghost.radius, [&](const R2::Vector&, double share) {
          const double edge = std::min(1.0, 8 * (1 - share));  // the edge is an eighth of the radius wide
          return (0.6 + 0.4 * share * share) * edge * ghost.color * glare.light;
        });
      }
    }
  }

 private:
  std::optional<Glare> GlareOf(const Light& light) {
    constexpr int rays = 64;
    R2::Color sum;
    double across = 0, upward = 0, weight = 0;
    for (int i = 0; i < rays; ++i) {
      const R2::Point on_disc = OnDisc(i, rays);
      const R2::Point on_lamp{(i + 0.5) / rays, Radical(i)};
      const auto sample = light.Illuminate(camera_.eye, on_lamp);
      const auto place = sample ? PlaceOf(sample->to_light, camera_, settings_) : std::nullopt;
      if (!place || IsHidden(*sample, on_disc)) continue;
      const double luminance = Luminance(sample->irradiance);
      sum += sample->irradiance;
      across += luminance * place->x, upward += luminance * place->y;
      weight += luminance;
    }
    if (!(weight > 0)) return {};
    return Glare{{across / weight, upward / weight}, settings_.flare / rays * sum};
  }

  /// Returns element `i` of the van der Corput sequence, the second coordinate on area lights.
  static double Radical(int i) {
    double value = 0;
    for (double digit = 0.5; i > 0; i /= 2, digit /= 2) value += (i % 2) * digit;
    return value;
  }

  /// Traces a shadow ray that starts next to the eye, up to the radius of the light's glow away.
  bool IsHidden(const LightSample& sample, const R2::Point& on_disc) {
    const double width = glow_core * camera_.HalfHeight(settings_.width, settings_.height) *
                         (sample.is_infinite ? 1 : Length(sample.to_light));
    const R3::Vector aside = width * (on_disc.x * camera_.right + on_disc.y * camera_.up);
    R3::Ray ray{camera_.eye + aside, sample.to_light};
    if (!sample.is_infinite) ray.direction = ray.direction - aside, ray.t_max = 1;
    return accelerator_.IsOccluded(ray, workspace_);
  }

  static double Glow(double share) {
    const double in_cores = share * glow_radius / glow_core, fading = (1 - share) * (1 - share);
    return fading / (1 + in_cores * in_cores);
  }

  double Streaks(const R2::Vector& from, double share) const {
    double sum = 0;
    const double length = share * glow_radius / streak_length;
    if (!(length < 1)) return 0;
    for (int i = 0; i < streaks; ++i) {
      const auto [sine, cosine] = R1::SinCosTurns((i + 0.25) / streaks);
      const double along = (from.x * cosine + from.y * sine) / height_;
      const double across = (from.x * sine - from.y * cosine) / height_ / streak_width;
      if (along > 0) sum += 0.5 * (1 - length) * (1 - length) / (1 + across * across);
    }
    return sum;
  }

  /// Adds `light_at`, a function of the way from a place and of the fraction of a radius, at the middle of each pixel.
  template <class LightAt>
  void AddWithin(R2::Image& image, const PixelRectangle& region, const R2::Point& place, double radius,
                 const LightAt& light) const {
    const double reach = radius * height_;
    const auto pixel = [](double x) { return static_cast<int>(std::clamp(std::floor(x), -1e9, 1e9)); };
    const PixelRectangle around = Common(region, {pixel(place.x - reach), pixel(place.y - reach),
                                                  pixel(place.x + reach) + 1, pixel(place.y + reach) + 1});
    for (int y = around.y0; y < around.y1; ++y)
      for (int x = around.x0; x < around.x1; ++x) {
        const R2::Vector from{x + 0.5 - place.x, y + 0.5 - place.y};
        const double share = std::sqrt(from.x * from.x + from.y * from.y) / reach;
        if (!(share < 1)) continue;
        const int column = x - region.x0, row = y - region.y0;
        image.Store(column, row, image.At(column, row) + light(from, share));
      }
  }

  const Accelerator& accelerator_;
  const Camera& camera_;
  const RenderSettings& settings_;
  double height_;
  Workspace workspace_;
  std::vector<Glare> glares_;
};

}  // namespace

void AddFlare(const World& world, const Accelerator& accelerator, const Camera& camera, const RenderSettings& settings,
              R2::Image& image) {
  Flare(world, accelerator, camera, settings).AddTo(image, RegionOf(settings));
}

R2::Image FlareAlone(const World& world, const Accelerator& accelerator, const RenderSettings& settings) {
  const PixelRectangle region = RegionOf(settings);
  R2::Image image(region.Width(), region.Height());
  const Camera camera = CameraOf(world, settings);
  if (HasFlare(camera, settings)) AddFlare(world, accelerator, camera, settings, image);
  return image;
}

}  // namespace ray
