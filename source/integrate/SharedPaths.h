#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "source/integrate/Tracer.h"
#include "source/sample/Random.h"

namespace ray {

/// Samples of neighboring pixels that share the light which their paths find beyond two diffuse surfaces.
///
/// The path of sample j scatters at a first surface x_j, in a direction with a cosine density, and reaches a second
/// one, y_j, which sends back the light R_j. Each other x_m of its group might have reached y_j as well. With
///
///     q(m, j) = V(x_m, y_j) max(0, N_m . w) max(0, -n_j . w) / |w|^4,    w = y_j - x_m,
///
/// pi times the density, per area around y_j, of scattering at x_m (N: shading normal, n: the surface's own one, V:
/// visibility), sample m receives, by the balance heuristic,
///
///     sum over j of  kd_m R_j q(m, j) / sum over l of q(l, j).
///
/// The shares of one j add up to 1. All other light remains the path's own: direct light at x, emission at y, rays that
/// escape, other lobes.
///
/// The groups are drawn at random for each sample of the pixels, so that they leave no pattern, and from a large
/// square: sharing evens out the noise within a group's pixels, but hardly that of their mean, so squares of 8 x 8
/// pixels would be visible.
///   source   Bekaert, Sbert, Halton, Accelerating path tracing by re-using paths (2002); Veach, Guibas, Optimally
///            combining sampling techniques for Monte Carlo rendering (1995), for the weights
class SharedPaths {
 public:
  static constexpr int side = 32;                  // of the square, in pixels
  static constexpr std::uint32_t group_size = 32;  // samples, about
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Removes all paths, and draws the groups of `samples` samples.
  void Begin(std::size_t samples, const RandomKey& key);

  /// Adds the surface x of a sample. Its departure must not refer to surfaces that the path has crossed. Returns its
  /// number.
  std::uint32_t AddFirst(const ShadingPoint& x, std::size_t sample);
  /// Adds the surface y that a path reached from a first surface.
  ///   throughput   of the path beyond y, in each channel, > 0
  ///   own          the light that the path has found so far beyond x
  void AddSecond(const ShadingPoint& y, std::uint32_t first, std::uint32_t path, double throughput,
                 const R2::Color& own);
  /// Removes the light R from what the paths added since the last call have found, which is `gathered` by path.
  void TakeLight(std::span<R2::Color> gathered);

  /// Adds to the radiance of each sample the light that its own path has found, as if none were shared.
  void GiveBack(std::span<R2::Color> radiances) const;
  /// Adds to the radiance of each sample its share of the light, of which TakeLight has taken all. Traces a shadow ray
  /// from each first surface to each second one of its group.
  void Distribute(const Tracer& tracer, std::span<R2::Color> radiances, TraceState& state) const;

 private:
  struct First {
    ShadingPoint x;
    std::uint32_t sample;
  };
  struct Second {
    R3::Point y;
    R3::Vector normal;  // n, on the side of the path
    std::uint32_t first, path;
    double throughput;
    R2::Color own, sent;  // sent: R
  };
  struct Group {
    std::vector<std::uint32_t> firsts, seconds;
  };

  std::vector<Group> Groups() const;
  /// Computes q of all pairs in a group, by second surfaces.
  void FindDensities(const Group& group, const Tracer& tracer, std::vector<double>& q, TraceState& state) const;

  std::vector<First> firsts_;
  std::vector<Second> seconds_;
  std::size_t taken_ = 0;                // number of second surfaces whose light is known
  std::vector<std::uint32_t> group_of_;  // by sample
};

}  // namespace ray
