#include "source/render/Render.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "source/film/error/Contrast.h"
#include "source/integrate/debug/Heat.h"
#include "source/integrate/lights/Caustics.h"
#include "source/render/DenoiseResult.h"
#include "source/render/Parts.h"
#include "source/render/PassRunner.h"
#include "source/render/forecast/DenoiseForecast.h"
#include "source/render/forecast/ErrorForecast.h"
#include "source/render/forecast/FinishForecast.h"
#include "source/render/forecast/SecondsOf.h"

namespace ray {
namespace {

ErrorMeasure MeasureFor(const RenderSettings& settings) {
  return {settings.budget.error ? settings.budget.error->unit : ErrorUnit::display, settings.budget.confidence,
          settings.srgb};
}

/// How many of the block's pixels have no sample but their first, which is not in the film's sums yet.
std::int64_t PixelsLookedAt(const Film& film, int block) {
  const PixelRectangle pixels = film.PixelsInRegion(block);
  const std::size_t places = film[block].first_samples.size();
  if (pixels.Area() == BlockOrder::places) return static_cast<std::int64_t>(places);  // a block that is no rim
  std::int64_t count = 0;
  for (std::size_t place = 0; place < places; ++place) {
    const auto [column, row] = BlockOrder::PixelAt(static_cast<int>(place), film.PixelsOf(block));
    count += pixels.Contains(column, row);
  }
  return count;
}

SampleCounts CountSamples(const Film& film) {
  SampleCounts counts{~0u, 0, 0};
  double sum = 0, pixels = 0;
  for (int i = 0; i < film.Blocks(); ++i) {
    const auto area = static_cast<double>(film.PixelsInRegion(i).Area());
    if (area == 0) continue;
    const std::uint32_t samples = film[i].Samples();
    const std::int64_t places = PixelsLookedAt(film, i);  // 0 where all have samples
    counts.least = std::min(counts.least, places == film.PixelsInRegion(i).Area() ? 1 : samples);
    counts.most = std::max(counts.most, places > 0 ? 1 : samples);
    sum += area * samples + static_cast<double>(places);
    pixels += area;
  }
  counts.mean = sum / pixels;
  return counts;
}

/// Taken so far, those of the margin that a wide filter needs among them.
double SamplesTaken(const Film& film) {
  double sum = 0;
  for (int i = 0; i < film.Blocks(); ++i)
    sum += static_cast<double>(film.PixelsOf(i).Area()) * film[i].Samples() +
           static_cast<double>(film[i].first_samples.size());
  return sum;
}

void ColorCosts(R2::Image& image) {
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, HeatColor(image.At(x, y).r));
}

Camera CameraOf(const World& world, const RenderSettings& settings) {
  return settings.view.value_or(world.scene().camera);
}

/// The distances of the nearest and the farthest surface seen through the middles of the whole picture's pixels.
ZBufferRange RangeOfPicture(const World& world, const Accelerator& accelerator, const RenderSettings& settings) {
  const Camera camera = CameraOf(world, settings);
  const auto range_of_row = [&](int row, ZBufferRange so_far) {
    Workspace workspace;
    for (int column = 0; column < settings.width; ++column) {
      const auto ray = camera.RayThrough(column + 0.5, row + 0.5, settings.width, settings.height);
      const auto hit = ray ? accelerator.Intersect(*ray, workspace) : std::nullopt;
      if (!hit) continue;
      const double distance = hit->t * Length(ray->direction);
      so_far = {std::min(so_far.near, distance), std::max(so_far.far, distance)};
    }
    return so_far;
  };
  const ZBufferRange range = tbb::parallel_reduce(
      tbb::blocked_range(0, settings.height), ZBufferRange{R3::infinity, 0},
      [&](const tbb::blocked_range<int>& rows, ZBufferRange so_far) {
        for (int row = rows.begin(); row != rows.end(); ++row) so_far = range_of_row(row, so_far);
        return so_far;
      },
      [](const ZBufferRange& a, const ZBufferRange& b) {
        return ZBufferRange{std::min(a.near, b.near), std::max(a.far, b.far)};
      });
  return range.far > 0 ? range : ZBufferRange{0, 1};
}

/// One render from its first sample to its picture: runs the passes that its schedule chooses.
class Job {
 public:
  using Clock = PassRunner::Clock;

  ///   start      when the render began, by the clock that budgets count
  ///   forecast   of a picture that is to be denoised in time, else null
  Job(const World& world, const Integrator& integrator, const RenderSettings& settings, const RenderMonitor& monitor,
      Clock::time_point start, DenoiseForecast* forecast = nullptr)
      : start_(start),
        denoise_forecast_(forecast),
        finish_forecast_(settings.budget.seconds_to_finish, monitor.encode),
        settings_(settings),
        monitor_(monitor),
        camera_(CameraRaysOf(world, settings)),
        caustics_(settings.mode == RenderMode::path ? CausticsOf(world, settings.trace) : Caustics()),
        source_{integrator, camera_, RandomKey(settings.seed), settings.clamp == Clamp::samples},
        film_(EmptyFilmOf(settings)),
        schedule_(settings, {film_.Columns(), film_.AreasInRegion()}, settings.wants_passes || monitor.pass_done),
        runner_({source_, film_, HasTwoStreams(settings), settings.threads, settings.tile_size, monitor.stop,
                 [this](std::int64_t pixels, const RayCounts& rays) { TellProgress(pixels, rays); },
                 OthersThan(settings)}) {}

  RenderResult Run() {
    NoteTimeAfter(0, 0);
    if (monitor_.resume) Resume(monitor_.resume(film_));
    std::optional<Stop> stop;
    while (true) {
      const PassRunner::End end = RunPass();
      if (end == PassRunner::End::stopped) {
        stop = Stop::request;
        break;
      }
      const PassOutcome pass = EndPass();
      stop = end == PassRunner::End::complete ? schedule_.Next(pass) : Stop::time;
      if (stop) break;
      if (monitor_.pass_done && passes_.back().end > 0) monitor_.pass_done(Picture(), passes_.back().end);
    }
    if ((*stop == Stop::request || monitor_.saves_finished) && monitor_.save) monitor_.save(State());
    return Result(*stop);
  }

  /// See RenderPart.
  bool RunPart() {
    Resume(monitor_.resume(film_));
    const PassRunner::End end = RunPass();
    monitor_.save(State());
    return end == PassRunner::End::complete;
  }

  /// See NextRound.
  std::optional<RenderState> NextRound(RenderState&& state) {
    Resume(std::move(state));
    if (!passes_.empty()) pass_begin_ = {passes_.back().seconds, passes_.back().samples};
    PassOutcome round = EndPass();
    round.is_of_many_machines = true;
    if (schedule_.Next(round)) return {};
    schedule_.SkipToRound();
    return State();
  }

  const Film& film() const { return film_; }
  /// Whether the picture's time, if it has one, was enough for samples that can be denoised, and for that.
  bool HasTimeToDenoise() const { return !denoise_forecast_ || (after_.is_in_time && film_.HasBothParts()); }

  /// When a picture that is denoised in time should be, but for the filters.
  std::optional<Clock::time_point> EndOfGuides() const {
    if (!denoise_forecast_) return {};
    return In(SecondsUntilWriting() - denoise_forecast_->FilterSeconds());
  }

  /// A copy, for keeping.
  RenderState State() const {
    RenderState state{{}, schedule_.State(), passes_, runner_.Rays(), PlannedSamples(settings_), differences_};
    for (int i = 0; i < film_.Blocks(); ++i) state.blocks.push_back(film_[i]);
    return state;
  }

 private:
  /// The blocks of other parts; empty where the whole image is rendered.
  std::vector<bool> OthersThan(const RenderSettings& settings) const {
    std::vector<bool> others;
    if (!settings.part) return others;
    for (const int part : PartsOfBlocks(film_, settings.part->of)) others.push_back(part != settings.part->index);
    return others;
  }

  struct PassWork {
    double end = 0;          // samples per pixel after the pass, on average
    double idle_pixels = 0;  // of blocks that are at their target before
  };

  double Seconds() const { return monitor_.seconds_before + SecondsSince(start_); }

  void Resume(RenderState&& state) {
    for (int i = 0; i < film_.Blocks(); ++i) film_[i] = std::move(state.blocks[static_cast<std::size_t>(i)]);
    schedule_.Resume(std::move(state.schedule));
    passes_ = std::move(state.passes);
    runner_.AddRays(state.rays);
    rays_before_ = state.rays.Total();
    differences_ = std::move(state.differences);
  }

  /// Seconds from now; some years where there is no clock.
  static Clock::time_point In(double seconds) {
    constexpr double most = 1e8;
    return Clock::now() +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::clamp(seconds, 0.0, most)));
  }

  /// The pass that the schedule chose, with pauses to keep the state. It ends `paused` where the time is over.
  PassRunner::End RunPass() {
    pass_begin_ = {Seconds(), CountSamples(film_).mean};
    pass_work_ = WorkOf(schedule_.State().targets);
    const auto deadline = settings_.budget.seconds > 0 ? std::optional(In(SecondsLeft(pass_work_.end))) : std::nullopt;
    const bool saves = monitor_.save && monitor_.save_every > 0;
    while (true) {
      auto pause_at = saves ? std::optional(In(monitor_.save_every)) : deadline;
      if (deadline) pause_at = std::min(*pause_at, *deadline);
      const auto end = runner_.Run(schedule_.State().targets, pause_at);
      const bool is_late = deadline && Clock::now() >= *deadline;
      if (end != PassRunner::End::paused || is_late) return end;
      monitor_.save(State());
    }
  }

  /// Until the picture has to be ready.
  double SecondsUntilWriting() const {
    constexpr double share_of_time_aimed_at = 0.985;  // what is left is for what was foretold too short
    return share_of_time_aimed_at * settings_.budget.seconds - finish_forecast_.Seconds() - Seconds();
  }
  /// Before what comes after so many samples per pixel has to begin.
  double SecondsLeft(double samples) const {
    const double more = after_.seconds_of_sample * std::max(0.0, samples - CountSamples(film_).mean);
    return SecondsUntilWriting() - after_.seconds - more;
  }

  /// How long a picture of so many samples per pixel, each taken in so many seconds, takes to be denoised. Where it
  /// would be far too late, denoising is given up, and samples have all the time.
  void NoteTimeAfter(double samples, double seconds_of_sample) {
    if (!denoise_forecast_ || !after_.is_in_time) return;
    constexpr double most_late = 0.2;  // of the time; a little late is better than not denoised
    // Until it is known guides are taken to take as long as samples.
    const bool has_looked = denoise_forecast_->HasLooked();
    TimeAfter now;
    now.seconds_of_sample = has_looked ? denoise_forecast_->SecondsOfSample(samples) : seconds_of_sample;
    now.seconds = denoise_forecast_->Seconds(samples) + (has_looked ? 0 : seconds_of_sample * samples);
    const double to_least = std::max(0.0, 2 - samples) * seconds_of_sample;  // samples per pixel
    const double left = settings_.budget.seconds - finish_forecast_.Seconds() - Seconds();
    const double late = to_least + denoise_forecast_->Seconds(samples) - left;
    const bool is_late = late > (samples > 0 ? most_late * settings_.budget.seconds : 0);
    if (!is_late) {
      after_ = now;
    } else if (samples > 0 && !after_.is_in_doubt) {
      // Other programs may have held up so short a pass, or look at denoising: the next one has to agree.
      after_.is_in_doubt = true;
      denoise_forecast_->Forget();
    } else {
      after_ = {.is_in_time = false};
    }
  }

  /// Notes the pass that is over.
  PassOutcome EndPass() {
    // Looks are no pass that anybody counts, nor are those of a render that has nothing to decide.
    const bool are_counted =
        settings_.budget.IsOpen() || settings_.wants_passes || settings_.replay || monitor_.pass_done;
    const double samples = CountSamples(film_).mean;
    // One that was over when it was kept is noted already, and what came before it is known no more.
    const std::uint32_t end = schedule_.State().end;
    const bool is_noted = !passes_.empty() && passes_.back().end == end && passes_.back().samples == samples;
    if (!passes_.empty() && !is_noted && (!are_counted || passes_.back().end == 0)) passes_.pop_back();
    if (!is_noted) passes_.push_back({end, samples, Seconds() - monitor_.seconds_before, {}});
    PassOutcome pass;
    pass.seconds_taken = Seconds() - pass_begin_.seconds;
    pass.samples_taken = samples - pass_begin_.samples;
    const bool measures = schedule_.LooksAtError() || settings_.wants_passes;
    if (measures && !ShowsCosts(settings_.mode)) pass.error = Measure();
    if (pass.error) {
      // Errors that a report alone asks for must not bear on those that decide, nor on what is claimed.
      if (!is_noted && schedule_.LooksAtError()) differences_ = pass.error->differences;
      if (!is_noted) passes_.back().error = pass.error->estimate;
      Foretell(pass);
    }
    if (schedule_.LooksAtContrast()) pass.contrasts = Contrasts();
    if (denoise_forecast_ && after_.is_in_time) {
      denoise_forecast_->Look(film_, samples, runner_.Rays().Total(), monitor_.stop);
      NoteTimeAfter(samples, pass.samples_taken > 0 ? pass.seconds_taken / pass.samples_taken : 0);
      pass.seconds_after_per_sample = after_.seconds_of_sample;
    }
    if (settings_.budget.seconds > 0) {
      LookAtFinishing();
      pass.seconds_after = after_.seconds + finish_forecast_.Seconds();
    }
    pass.now = Seconds();
    return pass;
  }

  /// Where it bears on when to stop.
  void LookAtFinishing() {
    constexpr double least = 0.02;  // of the time
    if (settings_.budget.seconds_to_finish > least * settings_.budget.seconds)
      finish_forecast_.Look(film_, settings_.quantization);
  }

  void Foretell(PassOutcome& pass) {
    if (!settings_.budget.error) return;
    const auto forecast = ForecastOf(passes_, *settings_.budget.error);
    pass.has_stalled = forecast && forecast->has_stalled;
    samples_foretold_ = forecast ? forecast->samples : 0;
  }

  PassWork WorkOf(const PassTargets& targets) const {
    PassWork work;
    const bool has_two_streams = HasTwoStreams(settings_);
    double samples = 0;
    for (int i = 0; i < film_.Blocks(); ++i) {
      const auto area = static_cast<double>(film_.PixelsOf(i).Area());
      const std::uint32_t target = targets.samples[static_cast<std::size_t>(i)];
      samples += area * (target > 0 ? (has_two_streams ? 2.0 : 1.0) * target
                                    : targets.PlacesOf(i) / double{BlockOrder::places});
      const bool is_done = film_[i].SamplesPerStream(has_two_streams) >= target && target > 0;
      if (is_done || runner_.IsLeftAlone(i)) work.idle_pixels += area;
    }
    work.end = samples / static_cast<double>(film_.Sampled().Area());
    return work;
  }

  void TellProgress(std::int64_t pixels, const RayCounts& rays) const {
    if (!monitor_.tile_done) return;
    const auto area = static_cast<double>(film_.Sampled().Area());
    double done = 0, total = 0;
    if (settings_.budget.seconds > 0) {
      total = 1e3 * settings_.budget.seconds;
      done = 1e3 * Seconds();
    } else if (settings_.replay || settings_.budget.is_endless) {
      total = area;
      done = static_cast<double>(pixels);
    } else {
      const double share =
          (static_cast<double>(pixels) - pass_work_.idle_pixels) / std::max(1.0, area - pass_work_.idle_pixels);
      total = area * (settings_.budget.error ? std::max(pass_work_.end, samples_foretold_) : settings_.samples);
      done = area * std::lerp(pass_begin_.samples, pass_work_.end, share);
    }
    constexpr double most = 1e18;  // what 64 bits hold
    total = std::clamp(total, 1.0, most);
    monitor_.tile_done(
        {static_cast<std::int64_t>(std::min(done, total)), static_cast<std::int64_t>(total), rays.Total()});
  }

  /// So far.
  R2::Image Picture() const {
    R2::Image image = film_.Picture(settings_.quantization);
    if (ShowsCosts(settings_.mode)) ColorCosts(image);
    return image;
  }

  RenderResult Result(Stop stop) {
    RenderResult result;
    result.image = Picture();
    result.rays = runner_.Rays();
    result.rays_before = rays_before_;
    if (const double samples = SamplesTaken(film_); samples > 0)
      result.share_cut = static_cast<double>(result.rays.throughput_cut) / RayCounts::throughput_unit / samples;
    result.stop = stop;
    result.samples = CountSamples(film_);
    result.planned_samples = PlannedSamples(settings_);
    result.two_streams = HasTwoStreams(settings_);
    result.pixels_total = film_.Region().Area();
    for (int i = 0; i < film_.Blocks(); ++i) {
      result.block_samples.push_back(film_[i].SamplesPerStream(result.two_streams));
      result.block_places.push_back(static_cast<std::uint8_t>(film_[i].first_samples.size()));
      result.pixels_done += film_[i].Samples() > 0 ? film_.PixelsInRegion(i).Area() : PixelsLookedAt(film_, i);
    }
    // Of costs no error is known: they are what is summed, not the colors shown.
    if (!ShowsCosts(settings_.mode)) result.error = LastError(stop);
    if (result.error && !passes_.empty()) passes_.back().error = result.error;
    result.unseen = Unseen();
    result.has_outliers = result.error && result.two_streams && result.error->IsMostlyOutliers() &&
                          result.samples.least == result.samples.most;
    result.passes = passes_;
    return result;
  }

  UnseenLight Unseen() const {
    if (runner_.Rays().caustics > 0) return {};
    return {caustics_.most, SamplesTaken(film_)};
  }

  std::vector<double> Contrasts() const {
    const ErrorMeasure measure = MeasureFor(settings_);
    return film_.HasSurroundings() ? NeighborContrasts(film_.WithSurroundings(), measure)
                                   : NeighborContrasts(film_, measure);
  }

  std::optional<MeasuredError> Measure() const {
    const ErrorMeasure measure = MeasureFor(settings_);
    auto measured = MeasureError(film_, measure, &differences_);
    if (measured) AllowFor(Unseen(), measure, *measured);
    return measured;
  }

  /// That of the last pass, unless samples have come since.
  std::optional<ErrorEstimate> LastError(Stop stop) const {
    if (stop != Stop::request && !passes_.empty() && passes_.back().error) return passes_.back().error;
    const auto measured = Measure();
    return measured ? std::optional(measured->estimate) : std::nullopt;
  }

  const Clock::time_point start_;
  DenoiseForecast* const denoise_forecast_;
  FinishForecast finish_forecast_;
  const RenderSettings& settings_;
  const RenderMonitor& monitor_;
  const CameraRays camera_;
  const Caustics caustics_;
  const SampleSource source_;
  Film film_;
  Schedule schedule_;
  PassRunner runner_;
  std::vector<Pass> passes_;  // that are over
  BlockErrors differences_;   // after the last pass that was measured
  struct {
    double seconds = 0, samples = 0;  // per pixel, on average
  } pass_begin_;
  PassWork pass_work_;
  /// What comes after the last sample.
  struct TimeAfter {
    bool is_in_time = true, is_in_doubt = false;
    double seconds = 0, seconds_of_sample = 0;  // after the samples so far, and for each more per pixel
  } after_;
  std::uint64_t rays_before_ = 0;
  double samples_foretold_ = 0;  // per pixel, that reach the error asked for; 0: unknown
};

/// Of an image that is to be denoised in time; else nothing.
std::optional<DenoiseForecast> DenoiseForecastOf(const World& world, const Accelerator& accelerator,
                                          const RenderSettings& settings) {
  if (!settings.denoise || settings.budget.seconds == 0) return {};
  return std::optional<DenoiseForecast>(std::in_place, world, accelerator, settings, MeasureFor(settings));
}

}  // namespace

double ExpectedRays(const RenderSettings& settings) {
  constexpr double rays_per_camera_ray = 3;  // with shadows and reflections, in scenes of the course
  constexpr double rays_per_second = 1e6;
  if (settings.budget.seconds > 0) return rays_per_second * settings.budget.seconds;
  const int parts = settings.part ? settings.part->of : 1;
  const double share = IsSubsampled(settings) ? static_cast<double>(settings.places) / BlockOrder::places : 1;
  return rays_per_camera_ray * share * static_cast<double>(MadeRegionOf(settings).Area()) * settings.samples / parts;
}

std::unique_ptr<const Integrator> IntegratorOf(const World& world, const Accelerator& accelerator,
                                               const RenderSettings& settings) {
  TraceSettings trace = TraceSettingsOf(settings);
  const Camera camera = CameraOf(world, settings);
  trace.outline.right = 2 * camera.HalfWidth() / settings.width * camera.right;
  trace.outline.up = 2 * camera.HalfHeight(settings.width, settings.height) / settings.height * camera.up;
  trace.outline.camera = camera;
  trace.outline.picture_width = settings.width, trace.outline.picture_height = settings.height;
  if (settings.mode == RenderMode::zbuffer && trace.zbuffer.IsOfPicture())
    trace.zbuffer = RangeOfPicture(world, accelerator, settings);
  return MakeIntegrator(settings.mode, world, accelerator, trace);
}

TraceSettings TraceSettingsOf(const RenderSettings& settings) {
  TraceSettings trace = settings.trace;
  trace.samples = PlannedSamples(settings);
  return trace;
}

CameraRays CameraRaysOf(const World& world, const RenderSettings& settings) {
  return CameraRaysOf(world, settings, PlannedSamples(settings));
}

CameraRays CameraRaysOf(const World& world, const RenderSettings& settings, std::uint32_t samples) {
  return CameraRays(CameraOf(world, settings), settings.camera, world.Moves(), settings.width, settings.height,
                    settings.trace.sampler, samples);
}

Film EmptyFilmOf(const RenderSettings& settings) {
  return Film(settings.width, settings.height, RegionOf(settings), settings.filter, SurroundingsOf(settings));
}

RenderResult Render(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                    const RenderMonitor& monitor) {
  const auto start = Job::Clock::now();
  const auto integrator = IntegratorOf(world, accelerator, settings);
  auto forecast = DenoiseForecastOf(world, accelerator, settings);
  Job job(world, *integrator, settings, monitor, start, forecast ? &*forecast : nullptr);
  RenderResult result = job.Run();
  if (!settings.denoise || !result.IsComplete() || (settings.replay && !settings.replay->denoised)) return result;
  result.had_no_time_to_denoise = !job.HasTimeToDenoise();
  if (result.had_no_time_to_denoise) return result;
  DenoiseResult(world, accelerator, settings, job.film(), MeasureFor(settings), job.EndOfGuides(), monitor, result);
  if (!result.IsComplete() && monitor.save) monitor.save(job.State());
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
  return Job(world, *integrator, settings, from_start, start, forecast ? &*forecast : nullptr)
      .NextRound(std::move(state));
}

RenderResult Render(const World& world, const Integrator& integrator, const RenderSettings& settings,
                    const RenderMonitor& monitor) {
  assert(!settings.denoise);
  return Job(world, integrator, settings, monitor, Job::Clock::now()).Run();
}

}  // namespace ray
