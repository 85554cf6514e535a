#include "source/view/live/RenderStatus.h"

#include "source/view/live/JobStatus.h"

namespace ray {
namespace {

constexpr double seconds_between_statuses = 0.25;  // slow enough for digits to be read

}  // namespace

void RenderStatus::Update(const TracedPictures& pictures, double now) {
  const RenderJob* job = pictures.IsLive() ? pictures.Live() : pictures.Trace();
  if (!job) return text_.clear();
  const std::uint64_t number = pictures.IsLive() ? pictures.LiveNumber() : pictures.TraceNumber();
  const auto look = [&] { return Seen{number, job->Samples(), job->HasEnded()}; };
  const bool is_recent = now - since_ < seconds_between_statuses;
  if (look() == seen_ && (seen_.has_ended || is_recent)) return;
  since_ = now;
  do {  // again where a pass has ended meanwhile
    seen_ = look();
    text_ = StatusOf(*job);
  } while (look() != seen_);
}

}  // namespace ray
