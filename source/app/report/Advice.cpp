#include "source/app/report/Advice.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "R1/Elementary.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/FileNames.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ProbeImage.h"
#include "source/render/SceneFeatures.h"
#include "source/render/forecast/FinishForecast.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr double seconds_a_probe = 1.2;  // five or six of them take some seconds
// Noise is uneven, so many small squares represent an image better than a few large ones.
constexpr int square_side = 16;
constexpr std::size_t least_squares = 16, most_squares = 256;  // their error is within 15% of the image's
// Filters also need the surroundings of a square, which are three times its pixels for squares of this size.
constexpr int filtered_side = 32;
constexpr std::size_t least_filtered_squares = 4, most_filtered_squares = 16;
constexpr std::size_t all_squares = 1 << 30;  // more squares than any image has
constexpr ErrorTarget usual_target{2, ErrorUnit::display};  // noise that is barely visible

/// Options by name and value; the value of a flag is empty.
using Setting = std::pair<std::string, std::string>;
using Settings = std::vector<Setting>;

std::string Typed(const Settings& settings) {
  std::string text;
  for (const auto& [name, value] : settings)
    text += (text.empty() ? "-" : " -") + name + (value.empty() ? "" : " " + value);
  return text;
}

std::string NumberText(double number) {
  if (!std::isfinite(number)) return "never";
  return number < 100 ? Rounded(number, 2) : Fixed(number, 0);
}

/// A change of settings that is worth probing.
struct Knob {
  Setting setting;
  bool may_help;  // in this scene with these settings
};

bool IsWhitted(const RenderSettings& render) { return render.mode == RenderMode::whitted; }

/// Returns settings that affect noise and time but not the mean.
std::vector<Knob> KnobsOfNoise(const World& world, const SceneFeatures& has, const RenderSettings& render) {
  const TraceSettings& trace = render.trace;
  const bool is_path = render.mode == RenderMode::path, takes_all = !has.choice_of_lights;
  const bool has_lamps = has.emissive_triangles || has.emissive_shapes;
  const bool has_areas = IsWhitted(render) && (has.area_lights || has_lamps || has.environment);
  const bool has_several = world.scene().lights.size() + has_lamps > 1;
  return {
      {{"shadow_samples", "1"}, has_areas && trace.shadow_samples > 1},
      {{"shadow_samples", "4"}, has_areas && trace.shadow_samples != 4},
      {{"lights", "one"}, takes_all && (is_path || IsWhitted(render)) && has_several},
      {{"lights", "all"}, has.choice_of_lights},
      {{"sampler", "sobol"}, trace.sampler != SamplerKind::sobol},
      {{"strategy", "mis"}, is_path && trace.strategy != LightStrategy::mis},
  };
}

/// Returns settings that find light cut off by the current ones.
std::vector<Knob> KnobsOfLight(const SceneFeatures& has, const RenderSettings& render) {
  const TraceSettings& trace = render.trace;
  const bool goes_on = render.mode == RenderMode::path || has.mirrors || has.clear;
  const std::int64_t deeper = std::min<std::int64_t>(2 * trace.max_depth, most_bounces);
  return {
      {{"max_depth", std::to_string(deeper)}, goes_on && deeper > trace.max_depth},
      {{"min_luminance", "0"},
       IsWhitted(render) && goes_on && trace.min_luminance > 0 && trace.roulette != Roulette::on},
  };
}

/// The predicted end of a render with some settings, at which its estimate meets the requested error.
struct Forecast {
  Settings settings;
  double samples = 0, seconds = 0;  // per pixel; of one processor, from the start of the program to the written file
};

bool HasName(const Settings& settings, const std::string& name) {
  return std::ranges::find(settings, name, &Setting::first) != settings.end();
}

class Advisor {
 public:
  Advisor(const World& world, const Accelerator& accelerator, const RenderOptions& options, double seconds_to_start)
      : world_(world),
        accelerator_(accelerator),
        options_(WithTarget(options)),
        has_target_(options.render.budget.error.has_value()),
        target_(*options_.render.budget.error),
        seconds_beside_(seconds_to_start +
                        SecondsToFinish(options_.render, EncoderOf(ImageName(options), options.encoding))) {
    // The time of a few squares determines how many are probed, to twice as many samples.
    const PixelRectangle image = RegionOf(options_.render);
    RenderSettings noisy = options_.render;
    noisy.denoise = false;
    const auto few = SquaresToProbe(image, square_side, 4);
    const Pass pass = ProbeToError(world_, accelerator_, noisy, few, 0).passes.back();
    has_time_for_all_ = 2 * pass.seconds < seconds_a_probe;
    squares_ = SquaresInTime(2 * pass.seconds, square_side, least_squares, most_squares);
    // Some 8 samples are filtered, of a square and of as much around it.
    constexpr double samples = 8, times_larger = 4, share_of_samples = 0.5;
    filtered_squares_ = SquaresInTime(times_larger / share_of_samples * samples * pass.seconds / pass.samples,
                                      filtered_side, least_filtered_squares, most_filtered_squares);
    asked_ = Probed({});
  }

  std::string Text() {
    const SceneFeatures has = FeaturesOf(world_, options_.render);
    asked_forecast_ = ForecastOfProbe(asked_, {});
    best_ = asked_forecast_;
    std::string rows = Row(asked_forecast_);
    std::vector<Forecast> helpful;
    const auto try_settings = [&](const Settings& settings) {
      const Forecast forecast = ForecastOfProbe(Probed(settings), settings);
      rows += Row(forecast);
      if (forecast.seconds < best_.seconds) best_ = forecast;
      return forecast;
    };
    for (const Knob& knob : KnobsOfNoise(world_, has, options_.render))
      if (knob.may_help && !IsNoiseless()) helpful.push_back(try_settings({knob.setting}));
    std::erase_if(helpful, [&](const Forecast& f) { return !IsNoticeablyFaster(f); });
    std::ranges::sort(helpful, {}, &Forecast::seconds);
    for (const Forecast& other : helpful) {
      if (HasName(best_.settings, other.settings[0].first) || IsWithoutEffect(best_.settings, other.settings)) continue;
      Settings both = best_.settings;
      both.push_back(other.settings[0]);
      try_settings(both);
    }
    if (CanDenoise() && !IsNoiseless()) {
      Settings filtered = best_.settings;
      filtered.emplace_back("denoise", "");
      try_settings(filtered);
    }
    if (!IsNoticeablyFaster(best_)) best_ = asked_forecast_;
    std::string light;
    for (const Knob& knob : KnobsOfLight(has, options_.render)) {
      if (!knob.may_help) continue;
      const Probe probe = Probed({knob.setting});
      rows += Row(ForecastOfProbe(probe, {knob.setting}));
      light += LightFound({knob.setting}, probe);
    }
    return Heading() + rows + "\n" + Conclusion() + light;
  }

 private:
  static RenderOptions WithTarget(RenderOptions options) {
    if (!options.render.budget.error) options.render.budget.error = usual_target;
    return options;
  }
  /// Returns the name that determines the image's format; PNG if none is given.
  static std::string ImageName(const RenderOptions& options) {
    return options.files.image.empty() ? standard_stream : options.files.image;
  }

  RenderSettings With(const Settings& settings) const {
    RenderOptions changed = options_;
    for (const auto& [name, value] : settings)
      Store(*FindOption(Program::raypro, name),
            value.empty() ? std::vector<std::string>{} : std::vector<std::string>{value}, changed);
    return changed.render;
  }
  Probe Probed(const Settings& settings) const {
    const RenderSettings render = With(settings);
    return ProbeToError(world_, accelerator_, render, render.denoise ? filtered_squares_ : squares_, seconds_a_probe);
  }
  Forecast ForecastOfProbe(const Probe& probe, const Settings& settings) const {
    const Probe::Arrival arrival = probe.ArrivalAt(target_);
    return {settings, arrival.samples, arrival.seconds + seconds_beside_};
  }

  bool CanDenoise() const {
    const RenderSettings& render = options_.render;
    return !render.denoise && (render.mode == RenderMode::whitted || render.mode == RenderMode::path);
  }
  /// Returns as many squares as there is time to probe, if the whole image takes `seconds_of_image`. Their number is a
  /// power of two, so that machines of similar speed probe the same squares.
  std::vector<PixelRectangle> SquaresInTime(double seconds_of_image, int side, std::size_t least,
                                            std::size_t most) const {
    const PixelRectangle image = RegionOf(options_.render);
    if (has_time_for_all_) return SquaresToProbe(image, side, all_squares);
    const double in_time = seconds_a_probe / seconds_of_image * static_cast<double>(image.Area()) / (side * side);
    const auto count =
        static_cast<std::size_t>(std::clamp(in_time, static_cast<double>(least), static_cast<double>(most)));
    return SquaresToProbe(image, side, std::bit_floor(count));
  }

  /// Returns true if one setting makes the other useless: in mode whitted, a light that is chosen gets one shadow ray.
  bool IsWithoutEffect(const Settings& settings, const Settings& other) const {
    const auto& [one, another] = std::pair(settings[0], other[0]);
    return IsWhitted(options_.render) && (one == Setting{"lights", "one"} || another == Setting{"lights", "one"}) &&
           (one.first == "shadow_samples" || another.first == "shadow_samples");
  }
  bool IsNoiseless() const { return asked_.square == 0 && asked_.stop == Stop::error; }
  bool IsNoticeablyFaster(const Forecast& forecast) const {
    constexpr double noticeable = 1.1;  // smaller differences are within the variation of squares
    return noticeable * forecast.seconds < asked_forecast_.seconds;
  }

  static std::string Line(std::string name, const std::string& samples, const std::string& seconds) {
    const auto column = [](const std::string& text, std::size_t width) {
      return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
    };
    name.resize(std::max<std::size_t>(name.size(), 40), ' ');
    return name + column(samples, 12) + column(seconds, 12) + "\n";
  }
  static std::string Row(const Forecast& forecast) {
    return Line(forecast.settings.empty() ? "as requested" : Typed(forecast.settings), NumberText(forecast.samples),
                NumberText(forecast.seconds));
  }
  std::string Target() const { return ErrorText(target_.value, target_.unit); }

  std::string Heading() const {
    const std::string parts = squares_.size() == 1 && squares_[0] == RegionOf(options_.render)
                                  ? "all of the image"
                                  : Counted(squares_.size(), "square") + " of 16x16 pixels";
    return "From " + parts + ": samples per pixel and seconds of one processor, from the\n"
           "start of the program to the file, until the estimated error is below " + Target() + ":\n" +
           Line("settings", "samples", "seconds");
  }

  std::string Conclusion() const {
    if (IsNoiseless()) return "No noise was found: one sample per pixel suffices.\n";
    if (!std::isfinite(best_.seconds))
      return "No settings reach " + Target() + (options_.render.samples > 1 ? " with this number of -samples" : "") +
             ".\n";
    std::string add = Typed(best_.settings);
    if (!has_target_) add += (add.empty() ? "-error " : " -error ") + ShowErrorTarget(target_);
    if (best_.settings.empty())
      return "No other settings get to " + Target() + " noticeably faster" + (add.empty() ? "" : "; add: " + add) +
             "\n";
    const double times = asked_forecast_.seconds / best_.seconds;
    return "To get to " + Target() + (std::isfinite(times) ? " " + Rounded(times, 2) + " times as fast" : "") +
           ", add: " + add + "\n";
  }

  std::string LightFound(const Settings& settings, const Probe& probe) const {
    constexpr double noticeable = 0.005, sure = 3;  // of all light; standard deviations
    const double gained = probe.light - asked_.light, noise = std::sqrt((probe.square + asked_.square) / Pixels());
    const double share = asked_.light > 0 ? gained / asked_.light : 0;
    if (!(std::abs(gained) > sure * noise) || std::abs(share) < noticeable) return {};
    return "With " + Typed(settings) + " the image has " + Rounded(100 * std::abs(share), 2) + "% " +
           (share > 0 ? "more" : "less") + " light, which no number of samples changes.\n";
  }
  double Pixels() const {
    double pixels = 0;
    for (const PixelRectangle& square : options_.render.denoise ? filtered_squares_ : squares_)
      pixels += static_cast<double>(square.Area());
    return pixels;
  }

  const World& world_;
  const Accelerator& accelerator_;
  const RenderOptions options_;
  const bool has_target_;  // requested by the user
  const ErrorTarget target_;
  const double seconds_beside_;  // for starting, and for writing the image
  bool has_time_for_all_ = false;
  std::vector<PixelRectangle> squares_, filtered_squares_;  // filtered_squares_ are for settings with -denoise
  Probe asked_;
  Forecast asked_forecast_, best_;
};

}  // namespace

std::string Advice(const World& world, const Accelerator& accelerator, const RenderOptions& options,
                   double seconds_to_start) {
  return Advisor(world, accelerator, options, seconds_to_start).Text();
}

}  // namespace ray
