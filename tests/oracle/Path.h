#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "R2/Image.h"
#include "source/accelerate/World.h"

/// Path tracing as a textbook has it: one ray at a time, no light samples, no structure, and nothing of the program but
/// its shapes, which say where a ray hits them and how they face. Read it before source/integrate/Path.h, whose images
/// tests compare with those of this one.
///   source   Kajiya, The rendering equation (1986); Pharr, Jakob, Humphreys, Physically Based Rendering (2023), 13.2
namespace oracle {

class Path {
 public:
  Path(const ray::World& world, unsigned seed) : world_(world), random_(seed) {}

  /// The mean of `samples` paths through random places of each pixel.
  R2::Image Picture(int width, int height, int samples) {
    R2::Image image(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        R2::Color sum;
        for (int i = 0; i < samples; ++i)
          sum += Radiance(world_.scene().camera.Through(x + Uniform(), y + Uniform(), width, height));
        image.Set(x, y, sum / samples);
      }
    return image;
  }

 private:
  struct Surface {
    R3::Point place;
    R3::Vector N;  // unit, on the side that the ray comes from
    bool entering;
    const ray::Material* material;
  };

  R2::Color Radiance(R3::Ray ray) {
    constexpr int most_bounces = 100;
    R2::Color radiance, throughput{1, 1, 1};
    for (int bounce = 0; bounce < most_bounces; ++bounce) {
      const auto surface = Nearest(ray);
      if (!surface) return radiance + throughput * world_.scene().background;
      radiance += throughput * surface->material->emission;
      const auto wi = Scatter(*surface, Unit(ray.direction), throughput);
      if (!wi) break;
      constexpr double off = 1e-9;  // scenes of about 10, whose hits are off by 1e-14
      ray = {surface->place + off * *wi, *wi};
    }
    return radiance;
  }

  std::optional<Surface> Nearest(R3::Ray ray) const {
    std::optional<Surface> nearest;
    for (const ray::Instance& instance : world_.Instances())
      for (int element = 0; element < instance.shape->Elements(); ++element) {
        const R3::Ray local = world_.Back(instance.frame, ray);
        const auto hit = instance.shape->Intersect(local, element);
        if (!hit) continue;
        R3::Intersection at = instance.shape->At(local, *hit, element);
        world_.BringToWorld(instance.frame, 0, at);
        const R3::Vector outward = AsVector(at.normal);
        const bool entering = Dot(outward, ray.direction) < 0;
        nearest = {ray.At(hit->t), entering ? outward : -outward, entering, instance.material};
        ray.t_max = hit->t;
      }
    return nearest;
  }

  /// One of the three lobes with equal chances; nothing where the path ends.
  std::optional<R3::Vector> Scatter(const Surface& s, const R3::Vector& d, R2::Color& throughput) {
    const ray::Material& m = *s.material;
    const double eta = s.entering ? 1 / m.ir : m.ir, cosine = -Dot(d, s.N), fresnel = Fresnel(cosine, eta);
    const auto lobe = static_cast<int>(3 * Uniform());
    throughput = 3 * throughput;
    if (lobe == 0) {
      throughput = throughput * m.kd;
      return Unit(s.N + Direction());
    }
    if (lobe == 1) {
      throughput = throughput * (m.kr + fresnel * m.kt);
      const R3::Vector mirrored = d + 2 * cosine * s.N;
      const R3::Vector wi = m.gloss > 0 ? NearMirrored(mirrored, m.gloss) : mirrored;
      return Dot(wi, s.N) > 0 ? std::optional(wi) : std::nullopt;
    }
    throughput = throughput * (1 - fresnel) * m.kt;
    const double sine_squared = eta * eta * (1 - cosine * cosine);
    if (sine_squared >= 1) return {};
    return eta * d + (eta * cosine - std::sqrt(1 - sine_squared)) * s.N;
  }

  /// The share of unpolarized light that is reflected, by Fresnel's equations.
  static double Fresnel(double cosine, double eta) {
    if (eta == 1) return 0;
    const double sine_squared = eta * eta * (1 - cosine * cosine);
    if (sine_squared >= 1) return 1;
    const double beyond = std::sqrt(1 - sine_squared);
    const double s = (eta * cosine - beyond) / (eta * cosine + beyond),
                 p = (eta * beyond - cosine) / (eta * beyond + cosine);
    return (s * s + p * p) / 2;
  }

  R3::Vector NearMirrored(const R3::Vector& mirrored, double exponent) {
    while (true) {  // by rejection: no formula that the program might share
      const R3::Vector wi = Direction();
      const double cosine = Dot(wi, mirrored);
      if (cosine > 0 && Uniform() < std::pow(cosine, exponent)) return wi;
    }
  }
  R3::Vector Direction() {
    while (true) {
      const R3::Vector v{2 * Uniform() - 1, 2 * Uniform() - 1, 2 * Uniform() - 1};
      const double square = Dot(v, v);
      if (square > 1e-6 && square < 1) return v / std::sqrt(square);
    }
  }
  double Uniform() { return std::generate_canonical<double, 53>(random_); }

  const ray::World& world_;
  std::mt19937_64 random_;
};

}  // namespace oracle
