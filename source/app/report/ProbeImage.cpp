#include "source/app/report/ProbeImage.h"

#include <algorithm>
#include <cmath>

#include "source/app/report/Resources.h"
#include "source/render/Render.h"

namespace ray {
namespace {

// Four by four blocks, so that a filter of noise sees about what it would see in the whole image.
constexpr int side = 32;

/// The squares to probe, all of them different; fewer than `most` where the image has no more.
std::vector<PixelRectangle> SquaresOf(const PixelRectangle& image, std::size_t most) {
  const int columns = (image.Width() + side - 1) / side, rows = (image.Height() + side - 1) / side;
  const double step_x = 0.7548776662466927, step_y = 0.5698402909980532;
  std::vector<PixelRectangle> squares;
  const std::size_t tries = 4 * most;  // small images repeat theirs
  for (std::size_t i = 0; i < tries && squares.size() < most; ++i) {
    const auto along = [&](double step, int count) {
      const double at = 0.5 + step * static_cast<double>(i);
      return std::min(static_cast<int>((at - std::floor(at)) * count), count - 1);
    };
    const int x = image.x0 + along(step_x, columns) * side, y = image.y0 + along(step_y, rows) * side;
    const PixelRectangle square = Common(image, {x, y, x + side, y + side});
    if (std::ranges::find(squares, square) == squares.end()) squares.push_back(square);
  }
  return squares;
}

/// Takes all samples, in two streams, and stops for nothing.
RenderSettings ForProbing(RenderSettings settings) {
  const bool is_of_light = settings.budget.error && IsOfLight(settings.budget.error->unit);
  settings.budget = {};
  settings.budget.error = {.value = 0, .unit = is_of_light ? ErrorUnit::linear : ErrorUnit::display};
  settings.budget.adaptive = Adaptive::off;
  settings.replay.reset();
  settings.wants_passes = false;
  settings.threads = 1;
  settings.denoises_beyond_crop = false;
  return settings;
}

}  // namespace

std::vector<ProbedSquare> ProbeImage(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                     double seconds, std::size_t most) {
  RenderSettings part = ForProbing(settings);
  const auto integrator = IntegratorOf(world, accelerator, part);
  const double scale = part.budget.error->unit == ErrorUnit::display ? 255 : 1;
  std::vector<ProbedSquare> probed;
  double taken = 0;
  for (const PixelRectangle& square : SquaresOf(EmptyFilmOf(settings).Region(), most)) {
    if (!probed.empty() && taken > seconds) break;
    part.crop = square;
    const double start = CpuSeconds();
    const RenderResult result = part.denoise ? Render(world, accelerator, part) : Render(world, *integrator, part);
    const double error = result.error ? result.error->estimate / scale : 0;
    probed.push_back({square, CpuSeconds() - start, error * error, MeanOf(result.image)});
    taken += probed.back().seconds;
  }
  return probed;
}

}  // namespace ray
