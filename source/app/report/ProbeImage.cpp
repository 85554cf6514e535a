#include "source/app/report/ProbeImage.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "source/app/report/Resources.h"
#include "source/film/denoise/DenoisedError.h"
#include "source/integrate/lights/Caustics.h"
#include "source/render/ImageDenoiser.h"
#include "source/render/PassHistory.h"
#include "source/render/PassRunner.h"
#include "source/render/RenderInputs.h"

namespace ray {
namespace {

constexpr int block_side = Film::block_side;

/// Returns settings whose errors are measured in the target's unit.
RenderSettings ForProbing(RenderSettings settings) {
  const Budget asked = settings.budget;
  settings.budget = {};
  settings.budget.error = asked.error;
  settings.budget.confidence = asked.confidence;
  settings.budget.adaptive = asked.adaptive;
  settings.replay.reset(), settings.part.reset();
  settings.wants_passes = false;
  settings.threads = 1;
  return settings;
}

/// A square of the image, rendered like a crop.
struct Square {
  Square(const RenderSettings& of_image, const PixelRectangle& pixels, const SampleSource& source)
      : settings(CroppedTo(pixels, of_image)),
        film(EmptyFilmOf(settings)),
        runner({source, film, HasTwoStreams(settings), settings.threads, settings.tile_size, nullptr, {}}) {}

  static RenderSettings CroppedTo(const PixelRectangle& pixels, RenderSettings settings) {
    settings.crop = pixels;
    return settings;
  }

  const RenderSettings settings;
  Film film;
  PassRunner runner;
};

/// The squares of a probe as one render: they take each pass together, and one film has the pixels of all.
class Squares {
 public:
  Squares(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
          const std::vector<PixelRectangle>& rectangles)
      : world_(world),
        accelerator_(accelerator),
        settings_(settings),
        integrator_(IntegratorOf(world, accelerator, settings)),
        camera_(CameraRaysOf(world, settings)),
        caustics_(settings.mode == RenderMode::path ? CausticsOf(world, settings.trace) : Caustics()),
        source_{*integrator_, camera_, RandomKey(settings.seed), settings.clamp == Clamp::samples},
        is_whole_(rectangles.size() == 1),
        film_(is_whole_ ? Film(settings.width, settings.height, rectangles[0], FilterKind::box)
                        : Stack(rectangles[0], static_cast<int>(rectangles.size()))) {
    seconds_to_prepare_ = CpuSeconds() - start_;
    double sampled = 0;
    for (const PixelRectangle& pixels : rectangles) {
      squares_.emplace_back(settings, pixels, source_);
      sampled += static_cast<double>(squares_.back().film.Sampled().Area());
    }
    times_larger_ = static_cast<double>(EmptyFilmOf(settings).Sampled().Area()) / sampled;
    measure_ = MeasureFor(settings);
    measure_.share = static_cast<double>(film_.Region().Area()) / static_cast<double>(RegionOf(settings).Area());
  }

  /// Returns the pixels of all squares, one above the other, without those that only a filter sees.
  const Film& film() const { return film_; }
  const ErrorMeasure& Measure() const { return measure_; }

  /// Returns the seconds of one processor so far. SecondsOfImage scales them to the whole image.
  double SecondsTaken() const { return CpuSeconds() - start_; }
  double SecondsOfImage() const { return seconds_to_prepare_ + times_larger_ * (SecondsTaken() - seconds_to_prepare_); }

  /// Takes samples until each block of film() has its target, per pixel and stream.
  void SampleTo(const std::vector<std::uint32_t>& targets) {
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      Square& square = squares_[i];
      PassTargets of_square;
      for (int block = 0; block < square.film.Blocks(); ++block)
        of_square.samples.push_back(targets[BlockOfFilm(i, square.film.PixelsOf(block))]);
      square.runner.Run(of_square, {});
      TakePixels(i);
    }
  }

  UnseenLight Unseen() const {
    for (const Square& square : squares_)
      if (square.runner.Rays().caustics > 0) return {};
    return {caustics_.most, CountSamples(film_).mean * static_cast<double>(RegionOf(settings_).Area())};
  }

  DenoisedImage Denoised() const {
    const PixelRectangle& all = film_.Region();
    DenoisedImage stack{{R2::Image(all.Width(), all.Height()), R2::Image(all.Width(), all.Height())}};
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      const Square& square = squares_[i];
      const DenoisedImage part = DenoiseFilm(world_, accelerator_, square.settings, square.film);
      for (int stream = 0; stream < 2; ++stream)
        ForEachPixel(i, [&](int column, int row, int x, int y) {
          stack.of_stream[stream].Set(x - all.x0, y - all.y0, part.of_stream[stream].At(column, row));
        });
    }
    return stack;
  }

 private:
  static Film Stack(const PixelRectangle& first, int squares) {
    const PixelRectangle all{0, 0, first.Width(), squares * first.Height()};
    return {all.x1, all.y1, all, FilterKind::box};
  }

  /// Calls visit(column, row, x, y) for each pixel of a square, with its positions in the square and in film().
  template <typename Visit>
  void ForEachPixel(std::size_t square, const Visit& visit) const {
    const PixelRectangle& pixels = squares_[square].film.Region();
    for (int y = pixels.y0; y < pixels.y1; ++y)
      for (int x = pixels.x0; x < pixels.x1; ++x) {
        const auto [in_film_x, in_film_y] = InFilm(square, x, y);
        visit(x - pixels.x0, y - pixels.y0, in_film_x, in_film_y);
      }
  }
  std::pair<int, int> InFilm(std::size_t square, int x, int y) const {
    const PixelRectangle& pixels = squares_[square].film.Region();
    if (is_whole_) return {x, y};
    return {x - pixels.x0, y - pixels.y0 + pixels.Height() * static_cast<int>(square)};
  }
  /// Returns the block of film() that contains, or is nearest to, these pixels of a square's own film.
  std::size_t BlockOfFilm(std::size_t square, const PixelRectangle& pixels) const {
    const PixelRectangle& region = squares_[square].film.Region();
    const auto [x, y] = InFilm(square, std::clamp(pixels.x0, region.x0, region.x1 - 1),
                               std::clamp(pixels.y0, region.y0, region.y1 - 1));
    return static_cast<std::size_t>(film_.BlockOf(x, y));
  }

  /// Copies the existing pixels of a square.
  void TakePixels(std::size_t square) {
    const Film& own = squares_[square].film;
    for (int part = 0; part < Film::parts; ++part) {
      const R2::Image image = own.Part(part);
      ForEachPixel(square, [&](int column, int row, int x, int y) {
        const int block = film_.BlockOf(x, y);
        Film::Block& to = film_[block];
        const auto samples = own[own.BlockOf(own.Region().x0 + column, own.Region().y0 + row)].samples[part];
        if (to.sums[part].IsEmpty()) to.sums[part] = film_.EmptySums(block);
        const PixelRectangle& reach = to.sums[part].Reach();
        const auto index = static_cast<std::size_t>(y - reach.y0) * static_cast<std::size_t>(reach.Width()) +
                           static_cast<std::size_t>(x - reach.x0);
        to.sums[part].Sums()[index] = {samples * image.At(column, row), static_cast<double>(samples)};
        to.samples[part] = samples;
      });
    }
  }

  const World& world_;
  const Accelerator& accelerator_;
  const RenderSettings& settings_;
  const double start_ = CpuSeconds();
  const std::unique_ptr<const Integrator> integrator_;
  const CameraRays camera_;
  const Caustics caustics_;
  const SampleSource source_;
  const bool is_whole_;
  Film film_;
  ErrorMeasure measure_;
  std::deque<Square> squares_;
  double seconds_to_prepare_ = 0, times_larger_ = 1;
};

}  // namespace

std::vector<PixelRectangle> SquaresToProbe(const PixelRectangle& image, int side, std::size_t most) {
  const auto down = [](int x) { return x / block_side * block_side; };
  const auto up = [&](int x) { return down(x + block_side - 1); };
  const PixelRectangle blocks{up(image.x0), up(image.y0), down(image.x1), down(image.y1)};  // whole blocks
  constexpr double hardly_more = 1.5;
  const int columns = blocks.Width() / side, rows = blocks.Height() / side;
  if (columns < 1 || rows < 1 || columns * rows <= hardly_more * static_cast<double>(most)) return {image};
  const double step_x = 0.7548776662466927, step_y = 0.5698402909980532;
  std::vector<PixelRectangle> squares;
  const std::size_t tries = 4 * most;  // small images repeat theirs
  for (std::size_t i = 0; i < tries && squares.size() < most; ++i) {
    const auto place = [&](double step, int count, int length) {
      const double at = 0.5 + step * static_cast<double>(i);
      const int which = std::min(static_cast<int>((at - std::floor(at)) * count), count - 1);
      return down(static_cast<int>(static_cast<std::int64_t>(which) * (length - side) / std::max(1, count - 1)));
    };
    const int x = blocks.x0 + place(step_x, columns, blocks.Width());
    const int y = blocks.y0 + place(step_y, rows, blocks.Height());
    const PixelRectangle square{x, y, x + side, y + side};
    if (std::ranges::find(squares, square) == squares.end()) squares.push_back(square);
  }
  return squares;
}

Probe::Arrival Probe::ArrivalAt(const ErrorTarget& target) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Pass& last = passes.back();
  if (stop == Stop::error) return {last.samples, last.seconds};
  const auto forecast = ForecastOf(passes, target);
  if (stop || !forecast || !std::isfinite(forecast->samples)) return {never, never};
  const Pass before = passes.size() > 1 ? passes[passes.size() - 2] : Pass{};
  const double pace = (last.seconds - before.seconds) / (last.samples - before.samples);
  return {forecast->samples, last.seconds + pace * (forecast->samples - last.samples)};
}

Probe ProbeToError(const World& world, const Accelerator& accelerator, const RenderSettings& asked,
                   const std::vector<PixelRectangle>& rectangles, double seconds) {
  const RenderSettings settings = ForProbing(asked);
  Squares squares(world, accelerator, settings, rectangles);
  const Film& film = squares.film();
  Schedule schedule(settings, {film.Columns(), film.AreasInRegion()}, false);
  Probe probe;
  const auto look = [&](const MeasuredError& noisy, const UnseenLight& unseen) {
    MeasuredError error = noisy;
    if (settings.denoise && !schedule.Suffices(noisy)) {
      error = MeasureDenoisedError(film, squares.Denoised(), squares.Measure());
      AllowFor(unseen, squares.Measure(), error);
    }
    probe.square = noisy.square;
    return PassHistory::Look{std::move(error)};
  };
  PassHistory history(settings, film, false, squares.Measure(), look);
  while (schedule.State().end == 0) schedule.Next({});  // the initial passes are part of the first samples
  bool is_measured = false;
  while (!probe.stop && !(is_measured && squares.SecondsTaken() > seconds)) {
    squares.SampleTo(schedule.State().targets.samples);
    PassOutcome pass;
    pass.error = history.Note(schedule, CountSamples(film).mean, squares.SecondsOfImage(), squares.Unseen());
    if (settings.denoise) pass.noisy = history.Noisy();
    if (pass.error) probe.light = MeanOf(film.Image()), is_measured = true;
    if (const auto forecast = history.Forecast()) pass.has_stalled = forecast->has_stalled;
    probe.stop = schedule.Next(pass);
  }
  probe.passes = history.Passes();
  probe.passes.back().seconds = squares.SecondsOfImage();
  return probe;
}

}  // namespace ray
