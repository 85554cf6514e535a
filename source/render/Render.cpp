#include "source/render/Render.h"

#include <algorithm>
#include <cassert>

#include "source/film/error/Contrast.h"
#include "source/integrate/debug/Heat.h"
#include "source/integrate/lights/Caustics.h"
#include "source/render/Flare.h"
#include "source/render/ImageDenoiser.h"
#include "source/render/Parts.h"
#include "source/render/PassHistory.h"
#include "source/render/PassProgress.h"
#include "source/render/PassRunner.h"
#include "source/render/forecast/DenoiseForecast.h"
#include "source/render/forecast/TimeBudget.h"

namespace ray {
namespace {

/// Returns the blocks of other parts; empty if the whole image is rendered.
std::vector<bool> BlocksOfOthers(const RenderSettings& settings, const Film& film) {
  std::vector<bool> others;
  if (!settings.part) return others;
  for (const int part : PartsOfBlocks(film, settings.part->of)) others.push_back(part != settings.part->index);
  return others;
}

/// Returns the contrasts of neighboring pixels for each block, as displayed.
std::vector<double> Contrasts(const Film& film, const RenderSettings& settings) {
  const ErrorMeasure measure = MeasureFor(settings);
  return film.HasSurroundings() ? NeighborContrasts(film.WithSurroundings(), measure)
                                : NeighborContrasts(film, measure);
}

/// Returns the light that samples may have missed, unless a camera path has found a caustic.
UnseenLight UnseenBy(const RayCounts& rays, const Film& film, const Caustics& caustics) {
  return rays.caustics > 0 ? UnseenLight{} : UnseenLight{caustics.most, SamplesTaken(film)};
}

/// Copies the image and its sample counts from the film.
void TakeFilm(const Film& film, const RayCounts& rays, const RenderSettings& settings, RenderResult& result) {
  result.rays = rays;
  if (const double samples = SamplesTaken(film); samples > 0)
    result.share_cut = static_cast<double>(rays.throughput_cut) / RayCounts::throughput_unit / samples;
  result.image = ImageOf(film, settings);
  result.samples = CountSamples(film);
  result.planned_samples = PlannedSamples(settings);
  result.two_streams = HasTwoStreams(settings);
  result.shares_light = settings.shares_light;
  result.pixels_total = film.Region().Area();
  for (int i = 0; i < film.Blocks(); ++i) {
    result.block_samples.push_back(film[i].SamplesPerStream(result.two_streams));
    result.block_places.push_back(static_cast<std::uint8_t>(film[i].first_samples.size()));
    result.pixels_done += film[i].Samples() > 0 ? film.PixelsInRegion(i).Area() : PixelsLookedAt(film, i);
  }
}

/// Returns true if filters could bring a squared error below the target, divided by `caution`. A larger error is not
/// worth a look.
bool MayReachTargetDenoised(const MeasuredError& noisy, const ErrorTarget& target, double caution) {
  // For 15 scenes at 16 samples (script/denoise_table.sh) regression leaves at least 0.2 of the error, a library 0.14;
  // with more noise they leave less.
  constexpr double least_left = 0.125;
  return caution * least_left * least_left * noisy.square <=
         SquaredTarget(target.value, {.unit = target.unit}, noisy.mean);
}

/// One render from its first sample to its image: runs the passes that its schedule chooses.
class Job {
 public:
  using Clock = TimeBudget::Clock;

  /// Prepares a render.
  ///   start      when the render began, by the clock that budgets count
  ///   denoiser   for an image that is to be denoised, otherwise null
  ///   forecast   for an image that is to be denoised within a time limit, otherwise null
  Job(const World& world, const Integrator& integrator, const RenderSettings& settings, const RenderMonitor& monitor,
      Clock::time_point start, ImageDenoiser* denoiser = nullptr, DenoiseForecast* forecast = nullptr)
      : settings_(settings),
        monitor_(monitor),
        denoiser_(denoiser),
        time_(settings, start, monitor.seconds_before, {settings.budget.seconds_to_finish, monitor.encode}, forecast),
        camera_(CameraRaysOf(world, settings)),
        caustics_(settings.mode == RenderMode::path ? CausticsOf(world, settings.trace) : Caustics()),
        source_{integrator, camera_, RandomKey(settings.seed), settings.clamp == Clamp::samples},
        film_(EmptyFilmOf(settings)),
        schedule_(settings, {film_.Columns(), film_.AreasInRegion(), film_.Together()},
                  settings.wants_passes || monitor.pass_done),
        history_(settings, film_, static_cast<bool>(monitor.pass_done), MeasureFor(settings), ErrorLeft()),
        progress_(settings, film_, BlocksOfOthers(settings, film_)),
        runner_({source_, film_, HasTwoStreams(settings), settings.threads, settings.tile_size, monitor.stop,
                 [this](std::int64_t pixels, const RayCounts& rays) {
                   if (monitor_.tile_done) monitor_.tile_done(progress_.Of(pixels, time_.Seconds(), rays.Total()));
                 },
                 BlocksOfOthers(settings, film_), BlockWatch()}) {}

  RenderResult Run() {
    if (monitor_.resume) Resume(monitor_.resume(film_));
    if (monitor_.blocks_done) schedule_.SkipToRound();
    std::optional<Stop> stop;
    while (true) {
      const PassRunner::End end = RunPass();
      if (end == PassRunner::End::stopped) {
        stop = Stop::request;
        break;
      }
      const PassOutcome pass = EndPass();
      if (denoiser_ && denoiser_->WasStopped()) {
        stop = Stop::request;
        break;
      }
      stop = end == PassRunner::End::complete ? schedule_.Next(pass) : Stop::time;
      if (stop) break;
      const std::uint32_t end_of_pass = history_.Passes().back().end;
      if (monitor_.pass_done && end_of_pass > 0) monitor_.pass_done(ImageOf(film_, settings_), end_of_pass);
    }
    if ((*stop == Stop::request || monitor_.saves_finished) && monitor_.save) monitor_.save(State());
    return Result(*stop);
  }

  /// Implements ray::RenderPart.
  bool RunPart() {
    Resume(monitor_.resume(film_));
    const PassRunner::End end = RunPass();
    monitor_.save(State());
    return end == PassRunner::End::complete;
  }

  /// Implements ray::NextRound.
  std::optional<RenderState> NextRound(RenderState&& state) {
    Resume(std::move(state));
    const auto& passes = history_.Passes();
    if (!passes.empty()) pass_begin_ = {passes.back().seconds, passes.back().samples};
    PassOutcome round = EndPass();
    round.is_of_many_machines = true;
    if (schedule_.Next(round)) return {};
    schedule_.SkipToRound();
    return State();
  }

  /// Returns true if the image reaches its error target only without denoising, which leaves the error `left`.
  bool IsBetterNoisy(const MeasuredError& left) const { return is_good_enough_noisy_ && !schedule_.Suffices(left); }

  const Film& film() const { return film_; }
  const TimeBudget& time() const { return time_; }

  /// Returns a copy of the state, for saving.
  RenderState State() const {
    RenderState state{{},  schedule_.State(), history_.Passes(), runner_.Rays(), PlannedSamples(settings_),
                      history_.Differences()};
    for (int i = 0; i < film_.Blocks(); ++i) state.blocks.push_back(film_[i]);
    return state;
  }

 private:
  std::function<void(std::span<const int>)> BlockWatch() {
    if (!monitor_.blocks_done) return {};
    return [this](std::span<const int> blocks) { monitor_.blocks_done(film_, blocks); };
  }

  /// Returns a function that measures the error of the denoised image, if that error decides when the render ends;
  /// otherwise an empty one. If the image will not be denoised, or need not be, the function returns the error of the
  /// film.
  PassHistory::LookAtDenoised ErrorLeft() {
    if (!denoiser_ || !settings_.budget.error || settings_.replay) return {};
    return [this](const MeasuredError& noisy, const UnseenLight& unseen) -> PassHistory::Look {
      is_good_enough_noisy_ = schedule_.Suffices(noisy);
      if (is_good_enough_noisy_ || denoiser_->HasFailed() || !time_.HasTimeToDenoise()) return {noisy};
      if (!MayReachTargetDenoised(noisy, *settings_.budget.error, schedule_.Caution()) || !time_.HasTimeToLook())
        return {};
      return {denoiser_->ErrorLeft(film_, unseen), denoiser_->WasStopped()};
    };
  }

  void Resume(RenderState&& state) {
    for (int i = 0; i < film_.Blocks(); ++i) film_[i] = std::move(state.blocks[static_cast<std::size_t>(i)]);
    const bool of_looks = state.schedule.end == 0;
    schedule_.Resume(std::move(state.schedule));
    history_.Resume(std::move(state.passes), std::move(state.differences));
    runner_.AddRays(state.rays, of_looks);
    rays_before_ = state.rays.Total();
  }

  /// Runs the pass that the schedule chose, with pauses to save the state. It returns `paused` if the time is over.
  PassRunner::End RunPass() {
    const PassTargets& targets = schedule_.State().targets;
    progress_.Begin(targets);
    pass_begin_ = {time_.Seconds(), progress_.SamplesBefore()};
    const auto deadline = time_.Deadline(progress_.SamplesBefore(), progress_.SamplesAfter());
    const bool saves = monitor_.save && monitor_.save_every > 0;
    while (true) {
      auto pause_at = saves ? std::optional(TimeBudget::In(monitor_.save_every)) : deadline;
      if (deadline) pause_at = std::min(*pause_at, *deadline);
      const auto end = runner_.Run(targets, pause_at);
      const bool is_late = deadline && Clock::now() >= *deadline;
      if (end != PassRunner::End::paused || is_late) return end;
      monitor_.save(State());
    }
  }

  /// Notes the completed pass, and returns the data that the schedule needs about it.
  PassOutcome EndPass() {
    const double samples = CountSamples(film_).mean;
    PassOutcome pass;
    pass.seconds_taken = time_.Seconds() - pass_begin_.seconds;
    pass.samples_taken = samples - pass_begin_.samples;
    if (schedule_.LooksAtContrast()) pass.contrasts = Contrasts(film_, settings_);
    const double seconds_of_render = time_.SecondsOfRender();
    const double seconds_of_sample = pass.samples_taken > 0 ? pass.seconds_taken / pass.samples_taken : 0;
    time_.Look(film_, samples, seconds_of_sample, runner_.Rays().Total(), monitor_.stop);
    pass.error = history_.Note(schedule_, samples, seconds_of_render, Unseen());
    pass.noisy = history_.Noisy();
    if (const auto forecast = history_.Forecast(); pass.error && forecast) {
      pass.has_stalled = forecast->has_stalled;
      progress_.Expect(forecast->samples);
    }
    pass.seconds_after = time_.SecondsAfter();
    pass.seconds_after_per_sample = time_.SecondsAfterPerSample();
    pass.now = time_.Seconds();
    return pass;
  }

  RenderResult Result(Stop stop) {
    RenderResult result;
    TakeFilm(film_, runner_.Rays(), settings_, result);
    result.rays_before = rays_before_;
    result.stop = stop;
    result.unseen = Unseen();
    result.error = history_.Finish(stop == Stop::request, result.unseen);
    result.has_outliers = result.error && result.two_streams && result.error->IsMostlyOutliers() &&
                          result.samples.least == result.samples.most;
    result.passes = history_.Passes();
    return result;
  }

  UnseenLight Unseen() const { return UnseenBy(runner_.Rays(), film_, caustics_); }

  const RenderSettings& settings_;
  const RenderMonitor& monitor_;
  ImageDenoiser* const denoiser_;
  TimeBudget time_;
  const CameraRays camera_;
  const Caustics caustics_;
  const SampleSource source_;
  Film film_;
  Schedule schedule_;
  PassHistory history_;
  PassProgress progress_;
  PassRunner runner_;
  struct {
    double seconds = 0, samples = 0;  // per pixel, on average
  } pass_begin_;
  std::uint64_t rays_before_ = 0;  // of the state from which the render resumed
  bool is_good_enough_noisy_ = false;
};

/// Returns the forecast for an image that is to be denoised within a time limit, otherwise std::nullopt.
std::optional<DenoiseForecast> DenoiseForecastOf(const World& world, const Accelerator& accelerator,
                                                 const RenderSettings& settings) {
  if (!settings.denoise || settings.budget.seconds == 0) return {};
  return std::optional<DenoiseForecast>(std::in_place, world, accelerator, settings, MeasureFor(settings));
}

std::unique_ptr<ImageDenoiser> DenoiserOf(const World& world, const Accelerator& accelerator,
                                          const RenderSettings& settings, const RenderMonitor& monitor) {
  if (!settings.denoise) return nullptr;
  return std::make_unique<ImageDenoiser>(world, accelerator, settings, MeasureFor(settings), monitor);
}

RenderResult RenderWithoutFlare(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                const RenderMonitor& monitor) {
  const auto start = Job::Clock::now();
  const auto integrator = IntegratorOf(world, accelerator, settings);
  auto forecast = DenoiseForecastOf(world, accelerator, settings);
  auto denoiser = DenoiserOf(world, accelerator, settings, monitor);
  Job job(world, *integrator, settings, monitor, start, denoiser.get(), forecast ? &*forecast : nullptr);
  RenderResult result = job.Run();
  if (!denoiser || !result.IsComplete() || (settings.replay && !settings.replay->denoised)) return result;
  const TimeBudget& time = job.time();
  result.had_no_time_to_denoise = time.Denoises() && !(time.HasTimeToDenoise() && job.film().HasBothParts());
  if (result.had_no_time_to_denoise) return result;
  denoiser->Finish(
      job.film(), time.EndOfGuides(), [&](const MeasuredError& left) { return job.IsBetterNoisy(left); }, result);
  if (!result.IsComplete() && monitor.save) monitor.save(job.State());
  return result;
}

}  // namespace

R2::Image ImageOf(const Film& film, const RenderSettings& settings) {
  R2::Image image = film.Image(settings.quantization);
  if (!ShowsCosts(settings.mode)) return image;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, HeatColor(image.At(x, y).r));
  return image;
}

RenderResult Render(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                    const RenderMonitor& monitor) {
  RenderResult result = RenderWithoutFlare(world, accelerator, settings, monitor);
  const Camera camera = CameraOf(world, settings);
  if (HasFlare(camera, settings)) AddFlare(world, accelerator, camera, settings, result.image);
  return result;
}

bool RenderPart(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                const RenderMonitor& monitor) {
  const auto start = Job::Clock::now();
  const auto integrator = IntegratorOf(world, accelerator, settings);
  return Job(world, *integrator, settings, monitor, start).RunPart();
}

std::optional<RenderState> NextRound(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                     RenderState state, const RenderMonitor& monitor) {
  const auto integrator = IntegratorOf(world, accelerator, settings);
  const auto start = Job::Clock::now() - std::chrono::duration_cast<Job::Clock::duration>(
                                             std::chrono::duration<double>(monitor.seconds_before));
  RenderMonitor from_start = monitor;
  from_start.seconds_before = 0;
  auto forecast = DenoiseForecastOf(world, accelerator, settings);
  auto denoiser = DenoiserOf(world, accelerator, settings, from_start);
  return Job(world, *integrator, settings, from_start, start, denoiser.get(), forecast ? &*forecast : nullptr)
      .NextRound(std::move(state));
}

RenderResult Render(const World& world, const Integrator& integrator, const RenderSettings& settings,
                    const RenderMonitor& monitor) {
  assert(!settings.denoise);
  return Job(world, integrator, settings, monitor, Job::Clock::now()).Run();
}

}  // namespace ray
