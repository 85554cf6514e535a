#include "source/render/forecast/TimeBudget.h"

#include <algorithm>
#include <utility>

#include "source/render/forecast/SecondsOf.h"

namespace ray {

TimeBudget::TimeBudget(const RenderSettings& settings, Clock::time_point start, double seconds_before,
                       FinishForecast finish, DenoiseForecast* denoise)
    : settings_(settings),
      start_(start),
      seconds_before_(seconds_before),
      finish_(std::move(finish)),
      denoise_(denoise) {
  NoteTimeToDenoise(0, 0);
}

TimeBudget::Clock::time_point TimeBudget::In(double seconds) {
  constexpr double most = 1e8;
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::clamp(seconds, 0.0, most)));
}

double TimeBudget::Seconds() const { return seconds_before_ + SecondsSince(start_); }

double TimeBudget::SecondsUntilWriting() const {
  return latest_share_of_time * settings_.budget.seconds - finish_.Seconds() - Seconds();
}

std::optional<TimeBudget::Clock::time_point> TimeBudget::Deadline(double samples, double end) const {
  if (!IsLimited()) return {};
  const double more = after_.seconds_of_sample * std::max(0.0, end - samples);
  return In(SecondsUntilWriting() - after_.seconds - more);
}

std::optional<TimeBudget::Clock::time_point> TimeBudget::EndOfGuides() const {
  if (!denoise_) return {};
  return In(SecondsUntilWriting() - denoise_->FilterSeconds());
}

void TimeBudget::Look(const Film& film, double samples, double seconds_of_sample, std::uint64_t rays,
                      const std::atomic<bool>* stop) {
  // of the limit: a shorter time to finish does not affect when to stop
  constexpr double least = 0.02;
  if (denoise_ && after_.is_in_time) {
    denoise_->Look(film, samples, rays, stop);
    NoteTimeToDenoise(samples, seconds_of_sample);
  }
  if (IsLimited() && settings_.budget.seconds_to_finish > least * settings_.budget.seconds)
    finish_.Look(film, settings_.quantization);
}

/// Predicts the time to denoise an image with that many samples per pixel, each taken in `seconds_of_sample`. If it
/// would finish far too late, denoising is given up, and samples have all the time.
void TimeBudget::NoteTimeToDenoise(double samples, double seconds_of_sample) {
  if (!denoise_ || !after_.is_in_time) return;
  constexpr double most_late = 0.2;    // of the limit; slightly late is better than not denoised
  constexpr double least_samples = 2;  // per pixel, required to denoise
  // Until more is known, assumes that guides take as long as samples.
  const bool has_looked = denoise_->HasLooked();
  TimeAfter now;
  now.seconds_of_sample = has_looked ? denoise_->SecondsOfSample(samples) : seconds_of_sample;
  now.seconds = denoise_->Seconds(samples) + (has_looked ? 0 : seconds_of_sample * samples);
  const double to_least = std::max(0.0, least_samples - samples) * seconds_of_sample;
  const double left = settings_.budget.seconds - finish_.Seconds() - Seconds();
  const double late = to_least + denoise_->Seconds(samples) - left;
  const bool is_late = late > (samples > 0 ? most_late * settings_.budget.seconds : 0);
  if (!is_late) {
    after_ = now;
  } else if (samples > 0 && !after_.is_in_doubt) {
    // Other programs may have delayed so short a pass, or the look at denoising: the next one must confirm it.
    after_.is_in_doubt = true;
    denoise_->Forget();
  } else {
    after_ = {.is_in_time = false};
  }
}

}  // namespace ray
