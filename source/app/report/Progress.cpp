#include "source/app/report/Progress.h"

#include <cmath>

#include "source/app/report/Messages.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr const char* to_line_start_and_clear = "\r\033[K";

std::string Bold(const std::string& text) { return HasColors() ? "\033[1m" + text + "\033[0m" : text; }

/// Returns the phase after the samples, as shown with the progress.
const char* WordsOf(RenderPhase phase) { return phase == RenderPhase::guides ? "gathering guides" : "denoising"; }

std::string TwoDigits(std::int64_t n) { return (n < 10 ? "0" : "") + std::to_string(n); }

}  // namespace

ProgressStyle ChooseProgressStyle(bool quiet) {
  if (quiet) return ProgressStyle::none;
  return HasTerminal() ? ProgressStyle::terminal : ProgressStyle::log;
}

std::string DurationText(double seconds) {
  constexpr double longest = 3600.0 * 24 * 365 * 1000;  // nobody waits longer for a render
  if (!(seconds < longest)) return "ages";
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  const std::int64_t hours = whole / 3600, minutes = whole / 60 % 60;
  return (hours > 0 ? std::to_string(hours) + ":" + TwoDigits(minutes) : std::to_string(minutes)) + ":" +
         TwoDigits(whole % 60);
}

std::string ProgressText(const RenderProgress& progress, double seconds) {
  const auto done = static_cast<double>(progress.done), total = static_cast<double>(progress.total);
  const std::string percent = std::to_string(progress.done * 100 / progress.total) + "%";
  const double left = seconds * (total - done) / done;
  const double million_rays = static_cast<double>(progress.rays) * 1e-6;
  return std::string(4 - std::min<std::size_t>(4, percent.size()), ' ') + percent +
         (progress.done > 0 ? "  " + DurationText(left) + " left" : "") +
         (progress.phase != RenderPhase::samples ? std::string("  ") + WordsOf(progress.phase)
          : seconds > 0                          ? "  " + Fixed(million_rays / seconds, 1) + " Mrays/s"
                                                 : "");
}

Progress::Progress(ProgressStyle style) : style_(style) {}

Progress::~Progress() {
  if (has_line_) PrintErrorPart(to_line_start_and_clear);
}

bool Progress::IsDue(const RenderProgress& progress) const {
  using namespace std::chrono_literals;
  const auto pause = Clock::now() - last_;
  switch (style_) {
    case ProgressStyle::none:
      return false;
    case ProgressStyle::terminal:
      return pause >= 100ms;
    case ProgressStyle::log:
      // The share falls if an error turns out to be further away.
      return pause >= 5s && progress.done * 10 / progress.total != tenths_shown_;
  }
  return false;
}

void Progress::Update(const RenderProgress& progress) {
  if (progress.phase != phase_) {
    phase_ = progress.phase;
    start_ = Clock::now();
    tenths_shown_ = 0;
  }
  if (!IsDue(progress)) return;
  last_ = Clock::now();
  tenths_shown_ = progress.done * 10 / progress.total;
  const std::string text = ProgressText(progress, std::chrono::duration<double>(last_ - start_).count());
  if (style_ == ProgressStyle::log) return PrintError(text);
  has_line_ = true;
  constexpr std::size_t percent_letters = 5;
  PrintErrorPart(to_line_start_and_clear + Bold(text.substr(0, percent_letters)) + text.substr(percent_letters));
}

}  // namespace ray
