#include "source/render/Render.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <mutex>

#include "source/integrate/debug/Heat.h"
#include "source/render/BlockRenderer.h"
#include "source/render/Tiles.h"

namespace ray {
namespace {

constexpr std::uint32_t most_samples = 1u << 30;      // a pixel and stream, where nothing else ends the render
constexpr std::uint32_t first_with_error_target = 8;  // of each stream, before anything is decided
constexpr std::uint32_t most_at_once = 64;            // samples a pixel between two looks at what is safe to keep
constexpr std::uint32_t stratified_unknown = 16;      // samples that strata are laid out for when no count is known
constexpr double seconds_to_finish_a_pixel = 150e-9;  // from sums to the bytes of a file
constexpr double share_of_time_aimed_at = 0.97;       // so that what is told wrong may be too long as well as too short
constexpr double share_of_time_at_once = 0.6;         // of what is left, by a pass: its speed is known from others
constexpr double fall_of_error = 0.75;                // error ~ samples^-this, for guessing how many are needed
// No block stops early where a thousandth of the pixels holds more than this share of the squared error, and blocks
// that seemed good enough before the last pass hold more than that share of it now: there light is found so seldom that
// nothing tells where it will be found next. (Along the edge of a lamp few pixels hold the error as well, but stay
// few.)
constexpr double too_hot = 0.5, too_surprising = 0.05;

bool IsCeilingGiven(const RenderSettings& settings) { return !settings.budget.IsOpen() || settings.samples > 1; }

TraceSettings TraceSettingsFor(const RenderSettings& settings) {
  TraceSettings trace = settings.trace;
  trace.samples = settings.replay            ? settings.replay->planned_samples
                  : IsCeilingGiven(settings) ? static_cast<std::uint32_t>(settings.samples)
                                             : stratified_unknown;
  return trace;
}

/// One render from its first sample to its picture.
class Job {
 public:
  using Clock = std::chrono::steady_clock;

  /// `start`: when the render began, by the clock that budgets count.
  Job(const World& world, const Integrator& integrator, const RenderSettings& settings, const RenderMonitor& monitor,
      Clock::time_point start)
      : start_(start),
        settings_(settings),
        monitor_(monitor),
        two_streams_(settings.replay ? settings.replay->two_streams : settings.budget.error.has_value()),
        ceiling_(Ceiling()),
        integrator_(integrator),
        camera_(CameraRaysOf(world, settings)),
        film_(EmptyFilmOf(settings)),
        tiles_(film_, settings.tile_size),
        targets_(static_cast<std::size_t>(film_.Blocks()), 0) {
    result_.two_streams = two_streams_;
    result_.planned_samples = TraceSettingsFor(settings).samples;
    result_.pixels_total = film_.Region().Area();
    measure_.unit = settings.budget.error ? settings.budget.error->unit : ErrorUnit::display;
    measure_.confidence = settings.budget.confidence;
    measure_.srgb = settings.srgb;
    for (int i = 0; i < film_.Blocks(); ++i) pixels_sampled_ += film_.PixelsOf(i).Area();
  }

  RenderResult Run() {
    if (monitor_.resume) Resume(monitor_.resume(film_));
    if (settings_.replay)
      RunReplay();
    else if (settings_.budget.IsOpen() || settings_.wants_passes || monitor_.pass_done)
      RunPasses();
    else
      RunTo(ceiling_);
    if (result_.stop == Stop::request && monitor_.save) monitor_.save(State());
    return Finish();
  }

 private:
  /// Samples a pixel and stream.
  std::uint32_t Ceiling() const {
    if (!IsCeilingGiven(settings_)) return most_samples;
    const auto samples = static_cast<std::uint32_t>(settings_.samples);
    return two_streams_ ? std::max(1u, samples / 2) : samples;
  }

  double Seconds() const {
    return monitor_.seconds_before + std::chrono::duration<double>(Clock::now() - start_).count();
  }

  std::uint32_t SamplesOf(int block) const { return two_streams_ ? film_[block].samples[0] : film_[block].Samples(); }

  /// A copy, for keeping.
  RenderState State() const {
    RenderState state{{}, targets_, squares_before_, end_, passes_, result_.rays};
    for (int i = 0; i < film_.Blocks(); ++i) state.blocks.push_back(film_[i]);
    return state;
  }

  void Resume(RenderState&& state) {
    targets_ = std::move(state.targets);
    squares_before_ = std::move(state.squares_before);
    end_ = state.end;
    passes_ = std::move(state.passes);
    result_.rays = state.rays;
    for (int i = 0; i < film_.Blocks(); ++i) {
      film_[i] = std::move(state.blocks[static_cast<std::size_t>(i)]);
      if (SamplesOf(i) >= targets_[static_cast<std::size_t>(i)]) work_done_ += film_.PixelsOf(i).Area();
    }
  }

  /// All blocks to the same number of samples. Whether nobody asked to stop.
  bool RunTo(std::uint32_t end) {
    std::fill(targets_.begin(), targets_.end(), end);
    return RunPass(end);
  }

  void RunReplay() {
    for (const std::uint32_t end : settings_.replay->ends) {
      if (end < end_) continue;
      for (std::size_t i = 0; i < targets_.size(); ++i)
        targets_[i] = settings_.replay->samples.empty() ? end : std::min(end, settings_.replay->samples[i]);
      if (!RunPass(end)) return;
      if (end != settings_.replay->ends.back()) ShowPass();
    }
  }

  void RunPasses() {
    // Where the clock counts, even the first samples must not take longer than they may.
    const std::uint32_t first_decision = std::min(ceiling_, two_streams_ ? first_with_error_target : 1u);
    std::uint32_t end = end_;
    if (end == 0) {
      end = settings_.budget.seconds > 0 ? 1 : first_decision;
      std::fill(targets_.begin(), targets_.end(), end);
    }
    while (true) {
      const double before = Seconds();
      const double samples_before = MeanSamples();
      if (!RunPass(end)) return;
      const double rate = (Seconds() - before) / std::max(1e-9, MeanSamples() - samples_before);
      std::optional<MeasuredError> error;
      if (settings_.budget.error || settings_.wants_passes) error = MeasureError(film_, measure_);
      if (error) passes_.back().error = error->estimate;

      if (end < first_decision) error.reset();  // too few samples to decide anything by it
      if (IsGoodEnough(error)) return End(Stop::error);
      if (end >= ceiling_) return End(Stop::samples);
      ShowPass();
      const std::uint32_t next = std::min(ceiling_, NextEnd(end, error));
      ChooseBlocks(next, error);
      const std::uint32_t begin = end;
      const double needed = rate * (MeanTarget() - MeanSamples());
      end = next;
      if (settings_.budget.seconds == 0) continue;
      const double left = share_of_time_aimed_at * settings_.budget.seconds - Seconds() -
                          seconds_to_finish_a_pixel * static_cast<double>(result_.pixels_total);
      // Each pass near the end leaves time for another, so that only the last and shortest can be told wrong.
      if (needed <= share_of_time_at_once * left) continue;
      const double one_sample = needed / (next - begin);
      if (one_sample > left) return End(Stop::time);
      constexpr double above_rounding = 1 + 1e-9;
      end = Shortened(std::max(share_of_time_at_once * left, above_rounding * one_sample) / needed);
      if (end == 0) return End(Stop::time);
    }
  }

  /// The next pass cut to a share of its samples, every block alike; 0 when nothing of it is left.
  std::uint32_t Shortened(double share) {
    std::uint32_t end = 0;
    for (int i = 0; i < film_.Blocks(); ++i) {
      std::uint32_t& target = targets_[static_cast<std::size_t>(i)];
      const std::uint32_t done = SamplesOf(i);
      target = done + static_cast<std::uint32_t>(std::max(0.0, share) * (target - done));
      if (target > done) end = std::max(end, target);
    }
    return end;
  }

  bool IsGoodEnough(const std::optional<MeasuredError>& error) const {
    if (!settings_.budget.error || !error) return false;
    return error->square_high <= SquaredTarget(settings_.budget.error->value, measure_, error->mean);
  }

  /// Twice as many, or fewer when the error is close to its target.
  std::uint32_t NextEnd(std::uint32_t end, const std::optional<MeasuredError>& error) const {
    const std::uint32_t twice = end > most_samples / 2 ? most_samples : 2 * end;
    if (!settings_.budget.error || !error) return twice;
    const double target = SquaredTarget(settings_.budget.error->value, measure_, error->mean);
    const double needed = std::pow(error->square_high / target, 0.5 / fall_of_error);
    if (!(needed < 1.7)) return twice;
    return std::min(twice, end + std::max(end / 8, static_cast<std::uint32_t>((needed - 1) * end)) + 1);
  }

  /// Which blocks go on to `next`: all, or those where the error is above the target or a neighbour's is. One look may
  /// see a small error by luck, so it takes two in a row to stop.
  void ChooseBlocks(std::uint32_t next, const std::optional<MeasuredError>& error) {
    std::fill(targets_.begin(), targets_.end(), next);
    if (settings_.budget.adaptive == Adaptive::off || !settings_.budget.error || !error) return;
    const double target = SquaredTarget(settings_.budget.error->value, measure_, error->mean);
    const std::vector<double>& squares = error->square_of_blocks;
    const bool is_first = squares_before_.empty();
    const bool is_risky = error->estimate.outlier_share > too_hot && ShareOfSurprise(squares, target) > too_surprising;
    std::vector<double> worse = squares;
    constexpr double fall = 0.5;  // of a squared error, at least, when the samples are doubled
    if (!is_first)
      for (std::size_t i = 0; i < worse.size(); ++i) worse[i] = std::max(worse[i], fall * squares_before_[i]);
    squares_before_ = squares;
    if (is_first || is_risky) return;
    bool any = false;
    for (double limit = target; !any && limit > 0; limit /= 2)
      for (int i = 0; i < film_.Blocks(); ++i) {
        const bool is_open = IsOpen(i, worse, limit);
        targets_[static_cast<std::size_t>(i)] = is_open ? next : SamplesOf(i);
        any |= is_open;
      }
  }

  /// How much of the squared error is in blocks that would have stopped before the last pass; all of it before there
  /// was one.
  double ShareOfSurprise(const std::vector<double>& squares, double target) const {
    if (squares_before_.empty()) return 1;
    double surprise = 0, all = 0;
    for (int i = 0; i < film_.Blocks(); ++i) {
      const double square = squares[static_cast<std::size_t>(i)];
      all += square;
      if (!IsOpen(i, squares_before_, target)) surprise += square;
    }
    return all > 0 ? surprise / all : 0;
  }

  bool IsOpen(int block, const std::vector<double>& squares, double limit) const {
    const int columns = film_.Columns(), rows = film_.Blocks() / columns;
    const int column = block % columns, row = block / columns;
    for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
        if (squares[static_cast<std::size_t>(r * columns + c)] > limit) return true;
    return false;
  }

  /// Every block to its target, pausing to keep the state now and then. Whether nobody asked to stop.
  bool RunPass(std::uint32_t end) {
    end_ = end;
    while (true) {
      halt_ = {monitor_.stop, {}};
      const bool keeps = monitor_.save && monitor_.save_every > 0;
      if (keeps)
        halt_.pause_at = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                            std::chrono::duration<double>(monitor_.save_every));
      if (RunUntilHalt()) break;
      if (halt_.IsAsked()) {
        result_.stop = Stop::request;
        return false;
      }
      monitor_.save(State());
    }
    passes_.push_back({end, MeanSamples(), Seconds() - monitor_.seconds_before, {}});
    return true;
  }

  bool RunUntilHalt() {
    const int threads = settings_.threads > 0 ? settings_.threads : tbb::info::default_concurrency();
    // The arena bounds this render alone, others may run beside it; only for more threads than usual is leave needed.
    std::optional<tbb::global_control> leave;
    if (threads > tbb::info::default_concurrency())
      leave.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    std::atomic<bool> is_whole = true;
    has_progressed_ = false;
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<int>(0, tiles_.Count()),
          [&](const tbb::blocked_range<int>& range) {
            for (int i = range.begin(); i != range.end(); ++i)
              if (!RunTile(i)) is_whole = false;
          },
          tbb::simple_partitioner());
    });
    return is_whole;
  }

  bool RunTile(int tile) {
    TraceState& state = states_.local();
    state.rays = {};
    BlockRenderer renderer(integrator_, camera_, film_.filter(), settings_, halt_);
    std::int64_t pixels = 0;
    bool is_whole = true;
    if (halt_.IsAsked() || (has_progressed_ && halt_.IsPauseDue())) return false;
    for (const int block : tiles_.BlocksOf(tile)) {
      state.workspace.ForgetLastHits();
      is_whole = Advance(block, state, renderer);
      if (!is_whole) break;
      pixels += film_.PixelsOf(block).Area();
    }
    const std::lock_guard lock(sums_);
    result_.rays += state.rays;
    work_done_ += pixels;
    if (monitor_.tile_done) monitor_.tile_done(Progress());
    return is_whole;
  }

  RenderProgress Progress() const {
    if (settings_.budget.seconds > 0) {
      const auto total = static_cast<std::int64_t>(1e3 * settings_.budget.seconds);
      return {std::min(total, static_cast<std::int64_t>(1e3 * Seconds())), total, result_.rays.Total()};
    }
    return {work_done_ % (pixels_sampled_ + 1), pixels_sampled_, result_.rays.Total()};
  }

  /// One block to its target, in steps after which it can be kept. The steps depend on the number of samples alone, so
  /// that a block is added up in the same order whether it got there in one pass or in several.
  bool Advance(int index, TraceState& state, BlockRenderer& renderer) {
    Film::Block& block = film_[index];
    const std::uint32_t target = targets_[static_cast<std::size_t>(index)];
    while (SamplesOf(index) < target) {
      const std::uint32_t done = SamplesOf(index), end = std::min(target, NextStep(done));
      if (!two_streams_ && std::has_single_bit(done) && block.samples[1] > 0) MergeParts(block);
      const int first_part = two_streams_ || done == 0 ? 0 : 1, last_part = two_streams_ ? 1 : first_part;
      Film::Block next = block;
      for (int part = first_part; part <= last_part; ++part) {
        if (next.sums[part].IsEmpty()) next.sums[part] = film_.EmptySums(index);
        if (!renderer.Render(film_.PixelsOf(index), two_streams_ ? part : 0, done, end, state, next.sums[part]))
          return false;
        next.samples[part] += end - done;
      }
      block = std::move(next);
      // However short the time between two pauses, each is worth a step.
      has_progressed_ = true;
      if (halt_.IsPauseDue() && SamplesOf(index) < target) return false;
    }
    return true;
  }

  /// With one stream the second part holds what came since the last power of two, so that both parts are about as
  /// large.
  void MergeParts(Film::Block& block) const {
    block.sums[0] += block.sums[1];
    block.samples[0] += block.samples[1];
    block.sums[1] = {};
    block.samples[1] = 0;
  }

  std::uint32_t NextStep(std::uint32_t done) const {
    std::uint32_t step = done < most_at_once ? std::bit_ceil(done + 1) : (done / most_at_once + 1) * most_at_once;
    if (!settings_.replay) return step;
    for (const std::uint32_t end : settings_.replay->ends)
      if (end > done) return std::min(step, end);
    return step;
  }

  double MeanOverPixels(const std::function<double(int)>& of_block) const {
    double sum = 0, pixels = 0;
    for (int i = 0; i < film_.Blocks(); ++i) {
      const auto area = static_cast<double>(Common(film_.PixelsOf(i), film_.Region()).Area());
      sum += area * of_block(i);
      pixels += area;
    }
    return sum / pixels;
  }
  double MeanSamples() const {
    return MeanOverPixels([&](int i) { return static_cast<double>(film_[i].Samples()); });
  }
  double MeanTarget() const {
    return (two_streams_ ? 2 : 1) *
           MeanOverPixels([&](int i) { return static_cast<double>(targets_[static_cast<std::size_t>(i)]); });
  }

  void ShowPass() const {
    if (monitor_.pass_done) monitor_.pass_done(Picture(), end_);
  }

  /// So far.
  R2::Image Picture() const {
    R2::Image image = film_.Picture();
    if (ShowsCosts(settings_.mode)) ColorHeat(image);
    return image;
  }

  void End(Stop stop) { result_.stop = stop; }

  RenderResult Finish() {
    RenderResult& r = result_;
    r.image = Picture();
    r.samples = {~0u, 0, MeanSamples()};
    for (int i = 0; i < film_.Blocks(); ++i) {
      r.block_samples.push_back(SamplesOf(i));
      const auto area = Common(film_.PixelsOf(i), film_.Region()).Area();
      if (area == 0) continue;
      const std::uint32_t samples = film_[i].Samples();
      r.samples.least = std::min(r.samples.least, samples);
      r.samples.most = std::max(r.samples.most, samples);
      if (samples > 0) r.pixels_done += area;
    }
    // Of heat no error is known: its sums are costs, not the colours shown.
    const auto error = ShowsCosts(settings_.mode) ? std::nullopt : MeasureError(film_, measure_);
    if (error) {
      r.error = error->estimate;
      r.has_hot_pixels = two_streams_ && r.error->outlier_share > too_hot && r.samples.least == r.samples.most;
      if (!passes_.empty()) passes_.back().error = r.error;
    }
    r.passes = std::move(passes_);
    return std::move(r);
  }

  static void ColorHeat(R2::Image& image) {
    for (int y = 0; y < image.Height(); ++y)
      for (int x = 0; x < image.Width(); ++x) image.Set(x, y, HeatColor(image.At(x, y).r));
  }

  const Clock::time_point start_;
  const RenderSettings& settings_;
  const RenderMonitor& monitor_;
  bool two_streams_;
  std::uint32_t ceiling_;
  const Integrator& integrator_;
  CameraRays camera_;
  Film film_;
  Tiles tiles_;
  std::vector<std::uint32_t> targets_;  // samples a pixel and stream, of each block
  std::vector<double>
      squares_before_;  // errors of the blocks when the last pass was decided on; empty before the first
  ErrorMeasure measure_;
  tbb::enumerable_thread_specific<TraceState> states_;
  std::mutex sums_;  // guards the counts below and the monitor; a block belongs to one tile and needs no guard
  std::int64_t work_done_ = 0;       // pixels, of all passes
  std::int64_t pixels_sampled_ = 0;  // by a pass of all blocks
  std::vector<Pass> passes_;
  std::uint32_t end_ = 0;  // of the pass that runs
  Halt halt_;
  std::atomic<bool> has_progressed_ = false;  // since the last pause
  RenderResult result_;
};

}  // namespace

double ExpectedRays(const RenderSettings& settings) {
  constexpr double rays_of_a_camera_ray = 3;  // with shadows and reflections, in scenes of the course
  constexpr double rays_a_second = 1e6;
  if (settings.budget.seconds > 0) return rays_a_second * settings.budget.seconds;
  const double pixels = settings.crop ? static_cast<double>(settings.crop->Area())
                                      : static_cast<double>(settings.width) * settings.height;
  return rays_of_a_camera_ray * pixels * settings.samples;
}

std::unique_ptr<const Integrator> IntegratorOf(const World& world, const Accelerator& accelerator,
                                               const RenderSettings& settings) {
  return MakeIntegrator(settings.mode, world, accelerator, TraceSettingsFor(settings));
}

CameraRays CameraRaysOf(const World& world, const RenderSettings& settings) {
  return CameraRays(settings.view.value_or(world.scene().camera), settings.camera, world.Moves(), settings.width,
                    settings.height, settings.trace.sampler, TraceSettingsFor(settings).samples);
}

Film EmptyFilmOf(const RenderSettings& settings) {
  return Film(settings.width, settings.height,
              settings.crop.value_or(PixelRectangle{0, 0, settings.width, settings.height}), settings.filter);
}

RenderResult Render(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                    const RenderMonitor& monitor) {
  const auto start = Job::Clock::now();
  const auto integrator = IntegratorOf(world, accelerator, settings);
  return Job(world, *integrator, settings, monitor, start).Run();
}

RenderResult Render(const World& world, const Integrator& integrator, const RenderSettings& settings,
                    const RenderMonitor& monitor) {
  return Job(world, integrator, settings, monitor, Job::Clock::now()).Run();
}

}  // namespace ray
