#include "source/view/live/JobStatus.h"

#include <cmath>

#include "source/render/SceneFeatures.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"

namespace ray {
namespace {

std::string Samples(int count) { return Counted(static_cast<std::uint64_t>(count), "sample"); }

/// Returns the samples so far, and those planned.
std::string Reach(const RenderJob& job) {
  if (job.order() == RenderJob::Order::rows && !job.HasEnded())
    return "row " + std::to_string(job.RowsDone()) + " of " + std::to_string(job.frame().Height());
  const RenderSettings& settings = job.Settings();
  if (job.HasEnded()) return Samples(job.Samples()) + (job.IsComplete() ? "" : " stopped");
  if (settings.budget.IsOpen()) return Samples(job.Samples());
  return std::to_string(job.Samples()) + " of " + Samples(settings.samples);
}

}  // namespace

std::string StatusOf(const RenderJob& job) {
  if (job.IsComplete() && job.Settings().budget.IsOpen()) return ClaimOf(*job.Result());
  std::string status = Reach(job) + (job.IsOfOneLight() ? " (one light per point so far)" : "");
  const auto share = job.Share(), left = job.SecondsLeft();
  if (share && !job.HasEnded()) status += " " + Fixed(std::floor(100 * *share), 0) + " %";
  const double seconds = job.Seconds();
  if (seconds > 0) status += " " + Fixed(1e-6 * static_cast<double>(job.Rays()) / seconds, 1) + " Mrays/s";
  if (left && !job.HasEnded()) status += " " + Fixed(std::ceil(*left), 0) + " s left";
  return status;
}

std::string ClaimOf(const RenderResult& result) {
  const std::string samples = Samples(static_cast<int>(std::lround(result.samples.mean)));
  if (!result.error) return samples;
  const ErrorEstimate& e = *result.error;
  return std::string(result.two_streams ? "estimated error " : "estimated error at most ") +
         ErrorText(e.estimate, e.unit) + " (" + Rounded(e.low, 3) + " to " + Rounded(e.high, 3) + "), " + samples;
}

namespace {

std::string MissingLightOf(const RenderJob& job) {
  if (!job.IsComplete() || !job.Result()->MissesLight()) return {};
  std::string limits;
  for (const std::string& source : SourcesOfBias(FeaturesOf(job.scene().world, job.Settings()), job.Settings()))
    if (CutsLight(source)) limits += (limits.empty() ? "-" : ", -") + source;
  return Rounded(100 * job.Result()->share_cut, 2) + "% of the light ended at " + limits;
}

constexpr double seconds_between_statuses = 0.25;  // slow enough for digits to be read

}  // namespace

void RenderStatus::Update(const TracedImages& traced, double now) {
  const RenderJob* job = traced.Job();
  if (!job) return text_.clear(), missing_light_.clear();
  const auto look = [&] { return Seen{traced.JobNumber(), job->Samples(), job->HasEnded()}; };
  const bool is_recent = now - since_ < seconds_between_statuses;
  if (look() == seen_ && (seen_.has_ended || is_recent)) return;
  since_ = now;
  do {  // again where a pass has ended meanwhile
    seen_ = look();
    text_ = StatusOf(*job);
    missing_light_ = MissingLightOf(*job);
  } while (look() != seen_);
}

}  // namespace ray
