#include "source/view/live/TracedImages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "R2/Ramp.h"
#include "R2/compare/Difference.h"
#include "R2/compare/Flip.h"
#include "source/render/FirstLook.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr double seconds_of_first_pass = 0.03;      // so that a move is answered within 40 ms
constexpr double most_seconds_of_first_pass = 0.2;  // that a move waits for the pass of the one before
constexpr double seconds_of_motion = 1.0 / 15;      // between images that eyes take for motion
constexpr double seconds_of_rest = 0.15;            // a hand that pauses for longer has stopped
constexpr double seconds_of_fading = 0.12;
constexpr int least_places = 4;  // of a block of 64 pixels, below which the preview shows more

/// The settings of a live image in its mode.
RenderSettings ForLive(RenderSettings settings, bool is_layer, bool budget_of_rest) {
  const bool is_surface = settings.mode == RenderMode::depth || settings.mode == RenderMode::id;
  if (is_surface && is_layer) settings.samples = 1;  // means over an edge would be of nothing that is there
  const bool is_estimate = !is_surface && !ShowsCosts(settings.mode);
  if (!is_estimate) settings.budget = {};
  // A grid's samples are laid out for their number.
  const bool takes_more = is_estimate && !is_layer && !IsGrid(settings.trace.sampler);
  if (budget_of_rest && takes_more && !settings.budget.IsOpen()) settings.samples = TracedImages::samples_at_rest;
  return settings;
}

}  // namespace

void TracedImages::StartTrace(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings,
                              bool continues) {
  trace_.Start(std::move(scene), settings, RenderJob::Order::rows, 1, continues ? Trace()->Canceled() : std::nullopt);
  trace_number_ = ++jobs_;
  has_reported_end_ = false;
}

bool TracedImages::StopTrace() {
  if (!IsTracing()) return false;
  trace_.Current()->Cancel();
  return true;
}

const RenderJob* TracedImages::TakeEnded() {
  trace_.Collect();
  live_.Collect();
  depths_.Collect();
  if (has_reported_end_ || !Trace() || !Trace()->HasEnded()) return nullptr;
  has_reported_end_ = true;
  return Trace();
}

void TracedImages::ShowLive(std::optional<RenderMode> mode) {
  is_wanted_ = is_live_ = is_due_ = true;
  moves_ = false;
  mode_ = mode;
}

void TracedImages::HideLive() {
  Suspend();
  is_wanted_ = false;
  mode_.reset();
}

void TracedImages::Suspend() {
  is_live_ = is_due_ = false;
  live_.Abandon();
  live_.ForgetLast();
  depths_.Abandon();
}

void TracedImages::Touch() {
  is_live_ = is_live_ || is_wanted_;
  is_due_ = true;
  moves_ = false;
}

void TracedImages::TouchView() {
  is_live_ = is_live_ || is_wanted_;
  moves_ = is_due_ ? moves_ : true;
  is_due_ = true;
  moved_at_ = Clock::now();
}

bool TracedImages::StopLive() {
  if (!is_live_) return false;
  if (!is_due_ && (!Live() || Live()->HasEnded())) return false;
  is_due_ = false;
  has_reported_live_end_ = true;
  if (Live()) live_.Current()->Cancel();
  return true;
}

const RenderJob* TracedImages::TakeEndedLive() {
  if (has_reported_live_end_ || is_due_ || !Live() || !Live()->HasEnded()) return nullptr;
  has_reported_live_end_ = true;
  return Live();
}

bool TracedImages::Moves() const {
  return moves_ && std::chrono::duration<double>(Clock::now() - moved_at_).count() < seconds_of_rest;
}

bool TracedImages::TracesInMotion(const RenderSettings& settings) const {
  const auto pixels = static_cast<std::int64_t>(settings.width) * settings.height;
  return PlacesWithin(seconds_of_motion, pixels, pixels_per_second_) >= least_places;
}

void TracedImages::Update(const std::shared_ptr<const LoadedScene>& scene, const RenderSettings& settings,
                          bool budget_of_rest) {
  if (Live() && Live()->PixelsPerSecond() > 0) pixels_per_second_ = Live()->PixelsPerSecond();
  const bool is_shown = ShownLive() != nullptr;
  if (is_shown && !was_shown_) shown_since_ = Clock::now();
  was_shown_ = is_shown;
  if (!is_live_ || !is_due_) return;
  const bool waits = Moves();
  if (waits && !TracesInMotion(settings)) {
    if (Live() && !Live()->HasEnded()) live_.Current()->Cancel();  // whoever draws gets the processor
    return;
  }
  const bool has_nothing_yet = Live() && !Live()->HasEnded() && Live()->Places() == 0;
  if (waits && has_nothing_yet && Live()->Seconds() < most_seconds_of_first_pass) return;
  is_due_ = false;
  if (Live() && Live()->Places() > 0) last_number_ = live_number_;
  RenderSettings in_mode = settings;
  in_mode.mode = mode_.value_or(settings.mode);
  const auto pixels = static_cast<std::int64_t>(settings.width) * settings.height;
  StartLive(scene, ForLive(in_mode, mode_.has_value(), budget_of_rest),
            PlacesWithin(seconds_of_first_pass, pixels, pixels_per_second_));
  if (moves_ && !TracesInMotion(settings)) live_.ForgetLast();  // of a view that is far by now
}

void TracedImages::StartLive(const std::shared_ptr<const LoadedScene>& scene, const RenderSettings& settings,
                             int first_places, std::optional<RenderJob::Stopped> before) {
  live_.Start(scene, settings, RenderJob::Order::coarse_first, first_places, std::move(before));
  live_number_ = ++jobs_;
  has_reported_live_end_ = false;
}

void TracedImages::ResumeLive() {
  if (!IsPaused()) return;
  const RenderJob& job = *Live();
  StartLive(job.SharedScene(), job.Settings(), BlockOrder::places, job.Canceled());
}

void TracedImages::TraceDepths() {
  if (Moves() || !ShownLive() || ShownLive() != Live() || depths_of_ == live_number_) return;
  depths_of_ = live_number_;
  RenderSettings settings = Live()->Settings();
  settings.mode = RenderMode::depth;
  settings.samples = 1;
  settings.budget = {};
  settings.denoise = false;
  settings.flare = 0;
  depths_.Start(Live()->SharedScene(), settings, RenderJob::Order::coarse_first, BlockOrder::places);
  depths_number_ = ++jobs_;
}

const RenderJob* TracedImages::Depths() const {
  const RenderJob* depths = depths_.Current();
  return depths_of_ == live_number_ && depths && depths->IsComplete() ? depths : nullptr;
}

const RenderJob* TracedImages::ShownLive() const {
  if (!is_live_ || !Live()) return nullptr;
  const bool is_waiting = is_due_ && moves_;  // for rest
  if (is_waiting && !TracesInMotion(Live()->Settings())) return nullptr;
  if (Live()->Places() >= least_places) return Live();
  const RenderJob* last = live_.Last();
  const bool is_alike =
      last && last->frame().Width() == Live()->frame().Width() && last->frame().Height() == Live()->frame().Height();
  return is_alike ? last : nullptr;
}

double TracedImages::Opacity() const {
  return std::min(1.0, std::chrono::duration<double>(Clock::now() - shown_since_).count() / seconds_of_fading);
}

bool TracedImages::IsBusy() const {
  const RenderJob* depths = depths_.Current();
  return IsTracing() || (is_live_ && is_due_) || (Live() && !Live()->HasEnded()) || (depths && !depths->HasEnded()) ||
         (ShownLive() && Opacity() < 1);
}

std::shared_ptr<const R2::Image> TracedImages::Current() const {
  return Job() ? std::make_shared<const R2::Image>(Job()->frame().Image()) : nullptr;
}

void TracedImages::SetReference(ReferenceImage reference) {
  reference_ = std::move(reference);
  reference_light_ = reference_.AsLight(encoding_);
}

void TracedImages::SetEncoding(const ByteEncoding& encoding) {
  if (encoding == encoding_) return;
  encoding_ = encoding;
  reference_light_ = reference_.AsLight(encoding_);
}

std::string TracedImages::Comparison() const {
  const auto current = Current();
  if (!reference_) return "no reference yet; press R to keep the rendered image as one";
  if (!current) return "nothing is rendered yet; press S or P first";
  const R2::Image& reference = *reference_.image;
  if (current->Width() != reference.Width() || current->Height() != reference.Height())
    return "the reference is " + std::to_string(reference.Width()) + "x" + std::to_string(reference.Height()) +
           " but the image is " + std::to_string(current->Width()) + "x" + std::to_string(current->Height());
  if (!reference_.IsLight()) return EncodedComparison(reference_.Comparable(*current, encoding_));
  const R2::Difference difference = R2::Compare(*current, reference, R2::Display::straight);
  return "linear RMSE " + Rounded(difference.rmse, 4) + ", display RMSE " + Rounded(difference.display_rmse, 4) +
         " / 255";
}

std::string TracedImages::EncodedComparison(const R2::Image& current) const {
  const R2::Difference difference = R2::Compare(current, *reference_.image, R2::Display::straight);
  const std::int64_t different = R2::PixelsBeyond(current, *reference_.image, 0.5 / reference_.levels);
  const double bytes = 255;
  return std::to_string(different) + " of " + std::to_string(difference.pixels) +
         (reference_.levels == 255 ? " pixels differ as 8 bits" : " pixels differ as 16 bits") +
         (different == 0 ? ""
                         : ", RMSE " + Rounded(difference.display_rmse, 4) + " / 255, largest difference " +
                               Rounded(bytes * difference.largest.value, 4) + " / 255");
}

std::shared_ptr<const R2::Image> TracedImages::Compared() const {
  if (comparing_ == Comparing::no || !reference_) return nullptr;
  if (comparing_ == Comparing::reference) return reference_light_;
  if (ShowsFalseColors()) return InFalseColors().image;
  const auto light = Current();
  const R2::Image& reference = *reference_.image;
  if (!light || light->Width() != reference.Width() || light->Height() != reference.Height()) return nullptr;
  const R2::Image current = reference_.Comparable(*light, encoding_);
  auto difference = std::make_shared<R2::Image>(current.Width(), current.Height());
  for (int y = 0; y < current.Height(); ++y)
    for (int x = 0; x < current.Width(); ++x) {
      const R2::Color d = current.At(x, y) - reference.At(x, y);
      difference->Set(x, y, {std::abs(d.r), std::abs(d.g), std::abs(d.b)});
    }
  return difference;
}

const TracedImages::FalseColors& TracedImages::InFalseColors() const {
  FalseColors now;
  if (const RenderJob* job = Job()) {
    now.number = JobNumber();
    now.samples = job->Samples(), now.rows = job->RowsDone(), now.places = job->Places();
    now.has_ended = job->HasEnded();
  }
  now.how = comparing_;
  now.reference = reference_.image;
  FalseColors& known = false_colors_;
  if (known.number == now.number && known.samples == now.samples && known.rows == now.rows &&
      known.places == now.places && known.has_ended == now.has_ended && known.how == now.how &&
      known.reference == now.reference)
    return known;
  known = std::move(now);
  const auto light = Current();
  const R2::Image& reference = *reference_.image;
  if (!light || light->Width() != reference.Width() || light->Height() != reference.Height()) return known;
  const R2::Image current = reference_.Comparable(*light, encoding_);
  const auto display = reference_.IsLight() && encoding_.srgb ? R2::Display::srgb : R2::Display::straight;
  R2::Plane numbers = comparing_ == Comparing::flip
                          ? R2::Flip(R2::Displayed(current, display), R2::Displayed(reference, display))
                          : R2::DisplayDifference(current, reference, display);
  known.largest = static_cast<double>(*std::ranges::max_element(numbers.values));
  known.mean = R2::Mean(numbers);
  if (comparing_ == Comparing::false_colors && known.largest > 0)
    for (float& number : numbers.values) number /= static_cast<float>(known.largest);
  known.image = std::make_shared<const R2::Image>(R2::RampImage(numbers));
  return known;
}

std::string TracedImages::ScaleOfComparison() const {
  if (!reference_ || (!ShowsFalseColors() && comparing_ != Comparing::difference)) return {};
  const FalseColors& shown = InFalseColors();
  if (!shown.image) return {};
  if (shown.largest == 0) return "the image equals the reference";  // all is black
  if (comparing_ == Comparing::difference) return {};
  if (comparing_ == Comparing::flip)
    return "FLIP, black 0, white 1: mean " + Rounded(shown.mean, 3) + ", largest " + Rounded(shown.largest, 3);
  constexpr double bytes = 255;
  return "largest difference of a channel, black 0, white " + Rounded(bytes * shown.largest, 3) + " / 255: mean " +
         Rounded(bytes * shown.mean, 3) + " / 255";
}

}  // namespace ray
