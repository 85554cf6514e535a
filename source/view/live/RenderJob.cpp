#include "source/view/live/RenderJob.h"

#include <tbb/info.h>

#ifdef __linux__
#include <sys/resource.h>
#endif

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "source/integrate/lights/LightSource.h"
#include "source/render/FirstLook.h"
#include "source/render/SharingGain.h"

namespace ray {
namespace {

constexpr std::chrono::milliseconds time_between_images{250};  // of a first look that takes longer

/// Leaves processors for drawing: besides a thread that draws this one, and those it
/// starts, get a tenth of the time.
void GiveWay() {
#ifdef __linux__
  constexpr int nice = 10;
  setpriority(PRIO_PROCESS, 0, nice);  // of this thread alone, says sched(7)
#endif
}

RenderSettings ForJob(RenderSettings settings, RenderJob::Order order) {
  if (settings.threads <= 0) settings.threads = std::max(1, tbb::info::default_concurrency() - 1);
  if (order == RenderJob::Order::rows) settings.budget = WithoutLimits(settings.budget);
  settings.replay.reset();
  return settings;
}

/// Returns true if blocks are final once they have their samples; otherwise neighboring pixels decide who gets some,
/// those around fill pixels that are skipped, or the whole image is filtered.
bool HasFinalBlocks(const RenderSettings& settings) {
  return !SamplesWhereNeighborsDiffer(settings) && !IsSubsampled(settings) && !settings.denoise;
}

/// Returns true if points sample many lights, so that a first look with one of them is much faster.
bool SamplesManyLights(const World& world, const RenderSettings& settings) {
  // For nine, a look at a quarter of the pixels takes a twentieth of the rays of all first samples.
  constexpr std::size_t few = 8;
  const TraceSettings& trace = settings.trace;
  if (IsSubsampled(settings)) return false;
  if (settings.mode == RenderMode::whitted)
    return trace.lights <= 0 && LightSourcesOfWhitted(world, trace).size() > few;
  return settings.mode == RenderMode::path && trace.lights == 0 && LightSourcesOfPath(world, trace).size() > few;
}

bool HasSamples(const RenderState& state) {
  return std::ranges::any_of(state.blocks, [](const Film::Block& block) { return block.Samples() > 0; });
}

/// The rows of an image that will not change any more, from the bottom, as blocks of its film get all their samples.
class FinishedRows {
 public:
  /// `film`: an empty one of the image.
  explicit FinishedRows(const Film& film) : columns_(film.Columns()), region_(film.Region()), top_(region_.y0) {
    for (int block = 0; block < film.Blocks(); block += columns_) {
      missing_.push_back(columns_);
      // Samples of the blocks above count for pixels below them where the filter reaches so far.
      const bool is_last = block + columns_ >= film.Blocks();
      const int top = film.PixelsOf(block).y1 - (is_last ? 0 : film.filter().Apron());
      final_.push_back(is_last ? region_.y1 : std::clamp(top, region_.y0, region_.y1));
    }
  }

  /// Notes that these blocks have their samples. Returns the rows that are final since then, of the film's region;
  /// empty for none.
  PixelRectangle Add(std::span<const int> blocks) {
    for (const int block : blocks) --missing_[static_cast<std::size_t>(block / columns_)];
    while (whole_ < missing_.size() && missing_[whole_] == 0) ++whole_;
    const int top = whole_ > 0 ? final_[whole_ - 1] : region_.y0;
    return {region_.x0, std::exchange(top_, top), region_.x1, top};
  }

 private:
  int columns_;
  PixelRectangle region_;
  std::vector<int> missing_;  // blocks of each row of them
  std::vector<int> final_;    // where the rows of the image end that are final once all blocks are there up to this row
  std::size_t whole_ = 0;     // rows of blocks, from the bottom
  int top_;                   // of the rows that are final
};

}  // namespace

RenderJob::RenderJob(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings, Order order,
                     int first_places, std::optional<Stopped> before)
    : before_(std::move(before)),
      start_(Clock::now() - std::chrono::duration_cast<Clock::duration>(
                                std::chrono::duration<double>(before_ ? before_->seconds : 0))),
      scene_(std::move(scene)),
      settings_(ForJob(settings, order)),
      order_(order),
      threads_of_further_samples_(settings.threads),
      first_places_(first_places),
      frame_(RegionOf(settings).Width(), RegionOf(settings).Height()),
      thread_([this] { Run(); }) {}

RenderJob::~RenderJob() {
  Cancel();
  thread_.join();
}

bool RenderJob::IsComplete() const { return HasEnded() && result_.has_value(); }

std::string RenderJob::Failure() const { return HasEnded() ? failure_ : std::string(); }

const RenderResult* RenderJob::Result() const { return IsComplete() ? &*result_ : nullptr; }

const std::optional<RenderJob::Stopped>& RenderJob::Canceled() const {
  static const std::optional<Stopped> none;
  return HasEnded() && !result_ && failure_.empty() ? canceled_ : none;
}

double RenderJob::Seconds() const {
  return HasEnded() ? seconds_ : std::chrono::duration<double>(Clock::now() - start_).count();
}

void RenderJob::Run() {
  GiveWay();
  try {
    const auto integrator = IntegratorOf(scene_->world, *scene_->accelerator, settings_);
    result_ = order_ == Order::rows ? RenderRows(*integrator) : RenderCoarseFirst(*integrator);
  } catch (const std::bad_alloc&) {
    failure_ = "out of memory";
  } catch (const std::exception& problem) {
    failure_ = problem.what();
  } catch (...) {
    failure_ = "unknown error";
  }
  seconds_ = Seconds();
  if (canceled_) canceled_->seconds = seconds_;
  has_ended_.store(true, std::memory_order_release);
}

std::optional<double> RenderJob::Share() const {
  if (IsComplete()) return 1;
  if (settings_.budget.seconds > 0) return std::min(1.0, Seconds() / settings_.budget.seconds);
  if (settings_.budget.IsOpen()) return {};
  return share_.load(std::memory_order_relaxed);
}

std::optional<double> RenderJob::SecondsLeft() const {
  if (IsComplete()) return 0;
  if (settings_.budget.seconds > 0) return std::max(0.0, settings_.budget.seconds - Seconds());
  const auto share = Share();
  if (!share || *share == 0) return {};
  return Seconds() * (1 - *share) / *share;
}

std::optional<RenderResult> RenderJob::RenderCoarseFirst(const Integrator& integrator) {
  // What a pixel costs may depend on those before it, so Render takes all samples of costs, in one go; if they are
  // many, the first is worth being seen at every pixel.
  const bool is_kept = !ShowsCosts(settings_.mode);
  FirstLook look(scene_->world, integrator, settings_, &stop_, [this](std::uint64_t rays) { rays_ = rays; });
  if (before_) {
    frame_.Put(before_->image, 0);
    samples_.store(before_->samples, std::memory_order_release);
    places_.store(BlockOrder::places, std::memory_order_release);
  } else {
    if (SamplesManyLights(scene_->world, settings_) && !LookByOneLight()) return {};
    if (!LookFirst(look, is_kept)) return {};
  }

  RenderSettings settings = DecidedSettings();
  settings.threads = threads_of_further_samples_;
  const int streams = HasTwoStreams(settings) ? 2 : 1;
  const std::uint64_t rays_not_kept = is_kept ? 0 : rays_.load();
  RenderMonitor monitor;
  monitor.stop = &stop_;
  monitor.seconds_before = Seconds();
  monitor.tile_done = [&](const RenderProgress& progress) {
    rays_ = rays_not_kept + progress.rays;
    share_ = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  };
  if (is_kept) {
    monitor.resume = [&](const Film&) { return before_ ? std::move(before_->state) : look.TakeState(); };
    monitor.save = [&](const RenderState& state) { canceled_ = Stopped{state, 0, frame_.Image(), Samples()}; };
    monitor.pass_done = [&](const R2::Image& image, std::uint32_t per_stream) {
      frame_.Put(image, 0);
      is_of_one_light_ = false;
      samples_.store(streams * static_cast<int>(per_stream), std::memory_order_release);
    };
  }
  RenderResult result = RenderAll(integrator, settings, monitor);
  if (!result.IsComplete()) return {};
  is_of_one_light_ = false;
  // Passes were made to be seen; Render has one unless more were requested.
  if (!settings_.wants_passes && !settings_.budget.IsOpen())
    result.passes.erase(result.passes.begin(), result.passes.end() - 1);
  frame_.Put(result.image, 0);
  places_.store(BlockOrder::places, std::memory_order_release);
  samples_.store(static_cast<int>(std::lround(result.samples.mean)), std::memory_order_release);
  return result;
}

bool RenderJob::LookByOneLight() {
  RenderSettings settings = settings_;
  settings.trace.lights = 1;
  const auto integrator = IntegratorOf(scene_->world, *scene_->accelerator, settings);
  FirstLook look(scene_->world, *integrator, settings, &stop_, [this](std::uint64_t rays) { rays_ = rays; });
  is_of_one_light_ = true;
  constexpr int last = BlockOrder::places / 4;
  for (int places = std::min(first_places_, last);; places *= 4) {
    if (look.Look(places, Clock::time_point::max()) == PassRunner::End::stopped) return false;
    frame_.Put(look.Image(), 0);
    pixels_per_second_ = look.Pixels(places) / std::max(1e-9, Seconds());
    places_.store(places, std::memory_order_release);
    if (places == last) return true;
  }
}

bool RenderJob::LookFirst(FirstLook& look, bool is_kept) {
  const int whole = IsSubsampled(settings_) ? settings_.places : BlockOrder::places;
  const int last = is_kept || settings_.samples > 1 ? whole : whole / 4;
  // By one light per point there is an image until each pixel has its sample.
  const int first = is_of_one_light_ ? last : std::min(first_places_, last);
  for (int places = first;; places = std::min(4 * places, last)) {
    auto end = PassRunner::End::paused;
    while (end == PassRunner::End::paused) {
      end = look.Look(places, Clock::now() + time_between_images);
      if (end == PassRunner::End::stopped) return false;
      if (is_of_one_light_) continue;
      if (end == PassRunner::End::paused || places < last || !is_kept)
        frame_.Put(look.Image(), 0);  // else Render shows it
    }
    if (!is_of_one_light_) pixels_per_second_ = look.Pixels(places) / std::max(1e-9, Seconds());
    if (is_kept) share_ = places / (settings_.samples * double{BlockOrder::places});
    places_.store(places, std::memory_order_release);
    if (places == last) break;
  }
  if (!is_kept && last == whole) samples_.store(1, std::memory_order_release);
  return true;
}

RenderSettings RenderJob::DecidedSettings() const {
  RenderSettings settings = settings_;
  settings.shares_light = SharesLight(scene_->world, *scene_->accelerator, settings, &stop_);
  return settings;
}

RenderResult RenderJob::RenderAll(const Integrator& integrator, const RenderSettings& settings,
                                  const RenderMonitor& monitor) const {
  // Denoising needs guides from the accelerator, and flares need to know which lights are visible.
  if (settings.denoise || settings.flare > 0) return Render(scene_->world, *scene_->accelerator, settings, monitor);
  return Render(scene_->world, integrator, settings, monitor);
}

std::optional<RenderResult> RenderJob::RenderRows(const Integrator& integrator) {
  RenderSettings settings = DecidedSettings();
  settings.tile_size = Film::block_side;  // so that all threads have some of a row
  settings.wants_passes = false;
  RenderMonitor monitor;
  monitor.stop = &stop_;
  monitor.tile_done = [&](const RenderProgress& progress) {
    if (progress.phase == RenderPhase::samples) rays_ = progress.rays;
    share_ = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  };
  monitor.save = [&](const RenderState& state) {
    if (HasSamples(state)) canceled_ = Stopped{state, 0, {}, 0};
  };
  if (before_) monitor.resume = [&](const Film&) { return std::move(before_->state); };
  FinishedRows rows(EmptyFilmOf(settings));
  if (HasFinalBlocks(settings))
    monitor.blocks_done = [&](const Film& film, std::span<const int> blocks) {
      const PixelRectangle strip = rows.Add(blocks);
      if (strip.Area() == 0) return;
      frame_.Put(ImageOf(film.Cut(strip), settings), strip.y0 - film.Region().y0);
      rows_done_.store(strip.y1 - film.Region().y0, std::memory_order_release);
    };
  RenderResult result = RenderAll(integrator, settings, monitor);
  if (!result.IsComplete()) return {};
  frame_.Put(result.image, 0);
  rows_done_.store(result.image.Height(), std::memory_order_release);
  samples_.store(static_cast<int>(std::lround(result.samples.mean)), std::memory_order_release);
  return result;
}

RenderJob& JobQueue::Start(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings,
                           RenderJob::Order order, int first_places, std::optional<RenderJob::Stopped> before) {
  Abandon();
  current_ = std::make_unique<RenderJob>(std::move(scene), settings, order, first_places, std::move(before));
  return *current_;
}

void JobQueue::Abandon() {
  Collect();
  if (!current_) return;
  current_->Cancel();
  if (current_->Places() == 0) return abandoned_.push_back(std::move(current_));
  ForgetLast();
  last_ = std::move(current_);
}

void JobQueue::ForgetLast() {
  if (last_) abandoned_.push_back(std::move(last_));
}

int JobQueue::Collect() {
  std::erase_if(abandoned_, [](const auto& job) { return job->HasEnded(); });
  return static_cast<int>(abandoned_.size());
}

}  // namespace ray
