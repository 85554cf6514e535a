#pragma once

#include <chrono>
#include <optional>

#include "source/film/Film.h"
#include "source/render/RenderSettings.h"
#include "source/render/forecast/DenoiseForecast.h"
#include "source/render/forecast/FinishForecast.h"

namespace ray {

/// The fraction of a time limit at which the last sample, with all that follows it, should be done. The rest is a
/// reserve for passes that take longer than expected and for forecasts that were too short.
inline constexpr double share_of_time_aimed_at = 0.97;
/// The fraction at which a pass is interrupted: half of the reserve is for passes, half for forecasts.
inline constexpr double latest_share_of_time = (1 + share_of_time_aimed_at) / 2;

/// The time limit of one render: the time left for samples after subtracting that of the denoiser and of writing the
/// file. Without a limit it is only a clock.
class TimeBudget {
 public:
  using Clock = std::chrono::steady_clock;

  ///   start           when the render began
  ///   seconds_before  for which the program had run by then; limits count from its start
  ///   finish          forecast of composing and writing the file
  ///   denoise         forecast for an image that is to be denoised within the limit, else null; it must outlive this
  TimeBudget(const RenderSettings& settings, Clock::time_point start, double seconds_before, FinishForecast finish,
             DenoiseForecast* denoise);

  /// Returns the seconds since the program began.
  double Seconds() const;
  /// Returns the seconds since the render began.
  double SecondsOfRender() const { return Seconds() - seconds_before_; }

  /// Updates the forecasts from the film after a pass, if they affect when to stop.
  ///   samples            per pixel, on average, so far
  ///   seconds_of_sample  seconds that a sample of every pixel took in the pass
  ///   rays               of the render so far; `stop` as in RenderMonitor
  void Look(const Film& film, double samples, double seconds_of_sample, std::uint64_t rays,
            const std::atomic<bool>* stop);

  /// Returns the seconds from the last sample to the written file if no more samples were taken; 0 without a limit.
  double SecondsAfter() const { return IsLimited() ? after_.seconds + finish_.Seconds() : 0; }
  /// Returns the seconds that each further sample per pixel adds to these.
  double SecondsAfterPerSample() const { return after_.seconds_of_sample; }

  /// Returns the time at which a pass from `samples` to `end` samples per pixel must be interrupted; std::nullopt
  /// without a limit.
  std::optional<Clock::time_point> Deadline(double samples, double end) const;

  /// Returns true if the image is to be denoised within the limit.
  bool Denoises() const { return denoise_ != nullptr; }
  /// Returns true if there was time to denoise, or if nothing is to be denoised within a limit.
  bool HasTimeToDenoise() const { return after_.is_in_time; }
  /// Returns true if there is time to denoise the image twice: now, to measure its error, and at the end.
  bool HasTimeToLook() const { return !IsLimited() || 2 * after_.seconds < SecondsUntilWriting(); }
  /// Returns the time at which the denoiser's guides must be done so that its filters are in time; std::nullopt without
  /// a limit.
  std::optional<Clock::time_point> EndOfGuides() const;

  /// Returns the time that many seconds from now; now for negative numbers, some years for very large ones.
  static Clock::time_point In(double seconds);

 private:
  bool IsLimited() const { return settings_.budget.seconds > 0; }
  double SecondsUntilWriting() const;
  void NoteTimeToDenoise(double samples, double seconds_of_sample);

  const RenderSettings& settings_;
  const Clock::time_point start_;
  const double seconds_before_;
  FinishForecast finish_;
  DenoiseForecast* const denoise_;
  /// The denoiser's time after the last sample.
  struct TimeAfter {
    bool is_in_time = true, is_in_doubt = false;
    double seconds = 0, seconds_of_sample = 0;  // after the samples so far, and for each more per pixel
  } after_;
};

}  // namespace ray
