#include "source/render/PassProgress.h"

#include <algorithm>

#include "source/render/Schedule.h"

namespace ray {

void PassProgress::Begin(const PassTargets& targets) {
  const bool has_two_streams = HasTwoStreams(settings_);
  samples_before_ = CountSamples(film_).mean;
  idle_pixels_ = 0;
  double samples = 0;
  for (int i = 0; i < film_.Blocks(); ++i) {
    const auto area = static_cast<double>(film_.PixelsOf(i).Area());
    const auto block = static_cast<std::size_t>(i);
    const std::uint32_t target = targets.samples[block];
    samples += area * (target > 0 ? (has_two_streams ? 2.0 : 1.0) * target
                                  : targets.PlacesOf(i) / double{BlockOrder::places});
    const bool is_done = film_[i].SamplesPerStream(has_two_streams) >= target && target > 0;
    if (is_done || (!left_alone_.empty() && left_alone_[block])) idle_pixels_ += area;
  }
  samples_after_ = samples / static_cast<double>(film_.Sampled().Area());
}

RenderProgress PassProgress::Of(std::int64_t pixels, double seconds, std::uint64_t rays) const {
  const auto area = static_cast<double>(film_.Sampled().Area());
  double done = 0, total = 0;
  if (settings_.budget.seconds > 0) {
    total = 1e3 * settings_.budget.seconds;
    done = 1e3 * seconds;
  } else if (settings_.replay) {
    total = area;
    done = static_cast<double>(pixels);
  } else {
    const double share = (static_cast<double>(pixels) - idle_pixels_) / std::max(1.0, area - idle_pixels_);
    total = area * (settings_.budget.error ? std::max(samples_after_, samples_expected_) : settings_.samples);
    done = area * std::lerp(samples_before_, samples_after_, share);
  }
  constexpr double most = 1e18;  // fits into 64 bits
  total = std::clamp(total, 1.0, most);
  return {static_cast<std::int64_t>(std::min(done, total)), static_cast<std::int64_t>(total), rays};
}

}  // namespace ray
