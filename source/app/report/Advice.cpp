#include "source/app/report/Advice.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "source/app/options/BudgetWords.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ProbeImage.h"
#include "source/render/SceneFeatures.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr int probed_samples = 16;        // of every probe: enough for the two streams' difference to be no accident
constexpr double seconds_a_probe = 0.6;   // so that five or six of them take some seconds
constexpr std::size_t most_squares = 16;  // 16,384 pixels, whose mean error varies by a few percent
constexpr ErrorTarget usual_target{2, ErrorUnit::display};  // noise that one has to look for

/// Options by name and value, none for a flag.
using Setting = std::pair<std::string, std::string>;
using Settings = std::vector<Setting>;

std::string Typed(const Settings& settings) {
  std::string text;
  for (const auto& [name, value] : settings)
    text += (text.empty() ? "-" : " -") + name + (value.empty() ? "" : " " + value);
  return text;
}

std::string SecondsText(double seconds) { return seconds < 100 ? Rounded(seconds, 2) : Fixed(seconds, 0); }

/// A change of settings worth a probe.
struct Knob {
  Setting setting;
  bool may_help;  // in this scene with these settings
};

bool IsWhitted(const RenderSettings& render) { return render.mode == RenderMode::whitted; }

/// Settings that change noise and time, and on average nothing else.
std::vector<Knob> KnobsOfNoise(const World& world, const SceneFeatures& has, const RenderSettings& render) {
  const TraceSettings& trace = render.trace;
  const bool is_path = render.mode == RenderMode::path, takes_all = !has.choice_of_lights;
  return {
      {{"shadow_samples", "1"}, IsWhitted(render) && has.area_lights && trace.shadow_samples > 1},
      {{"shadow_samples", "4"}, IsWhitted(render) && has.area_lights && trace.shadow_samples == 1},
      {{"lights", "one"}, takes_all && (is_path || IsWhitted(render)) && world.scene().lights.size() > 1},
      {{"lights", "all"}, has.choice_of_lights},
      {{"sampler", "sobol"}, trace.sampler != SamplerKind::sobol},
      {{"strategy", "mis"}, is_path && trace.strategy != LightStrategy::mis},
  };
}

/// Settings that find light which the current ones cut away.
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

/// What squares say, added up.
struct Totals {
  double pixels = 0, seconds = 0, squares = 0, light = 0;

  explicit Totals(const std::vector<ProbedSquare>& probed) {
    for (const ProbedSquare& square : probed) {
      const auto area = static_cast<double>(square.pixels.Area());
      pixels += area;
      seconds += square.seconds;
      squares += area * square.square;
      light += area * square.mean;
    }
  }
};

/// A whole image by what was probed of it.
struct Forecast {
  Settings settings;
  double seconds = 0;       // of one processor, at so many samples
  double square = 0;        // of the error
  double light_gained = 0;  // over that of the settings asked for, as a share
  bool is_light_sure = false;

  double SecondsTo(double target_square) const {
    const double least = 1.0 / probed_samples;  // one sample per pixel
    return seconds * std::max(least, square / target_square);
  }
};

class Advisor {
 public:
  Advisor(const World& world, const Accelerator& accelerator, const RenderSettings& render)
      : world_(world),
        accelerator_(accelerator),
        render_(render),
        target_(render.budget.error.value_or(usual_target)),
        base_(Probe({})) {
    const Totals totals(base_);
    const PixelRectangle whole = EmptyFilmOf(render).Region();
    asked_.seconds = totals.seconds / totals.pixels * static_cast<double>(whole.Area());
    asked_.square = totals.squares / totals.pixels;
    const ErrorMeasure measure{.unit = target_.unit, .srgb = render.srgb};
    target_square_ = SquaredTarget(target_.value, measure, totals.light / totals.pixels);
  }

  std::string Text() {
    const SceneFeatures has = FeaturesOf(world_, render_);
    std::string rows = Row(asked_);
    Forecast best = asked_;
    Settings helpful;
    const auto probe = [&](const Settings& settings) {
      const Forecast forecast = ForecastOf(settings);
      rows += Row(forecast);
      if (SecondsTo(forecast) < SecondsTo(best)) best = forecast;
      return forecast;
    };
    for (const Knob& knob : KnobsOfNoise(world_, has, render_))
      if (knob.may_help && IsNoticeablyFaster(probe({knob.setting}))) helpful.push_back(knob.setting);
    if (helpful.size() > 1) probe(helpful);
    if (!IsNoticeablyFaster(best)) best = asked_;
    std::string light;
    for (const Knob& knob : KnobsOfLight(has, render_)) {
      if (!knob.may_help) continue;
      const Forecast forecast = ForecastOf({knob.setting});
      rows += Row(forecast);
      light += LightFound(forecast);
    }
    return Heading() + rows + "\n" + Conclusion(best) + Denoising() + light;
  }

 private:
  std::vector<ProbedSquare> Probe(const Settings& settings) const {
    Options changed;
    changed.render = render_;
    changed.render.samples = probed_samples;
    for (const auto& [name, value] : settings)
      Store(*FindOption(Program::raypro, name),
            value.empty() ? std::vector<std::string>{} : std::vector<std::string>{value}, changed);
    return ProbeImage(world_, accelerator_, changed.render, seconds_a_probe, most_squares);
  }

  /// By the squares that were probed with the settings asked for too.
  Forecast ForecastOf(const Settings& settings) const {
    std::vector<ProbedSquare> probed = Probe(settings), base = base_;
    const std::size_t common = std::min(probed.size(), base.size());
    probed.resize(common), base.resize(common);
    const Totals now(probed), then(base);
    Forecast forecast{settings};
    constexpr double tick = 1e-6;  // of the system's count of processor time
    forecast.seconds = asked_.seconds * now.seconds / std::max(then.seconds, tick);
    forecast.square = then.squares > 0 ? asked_.square * now.squares / then.squares : now.squares / now.pixels;
    const double gained = now.light - then.light, noise = std::sqrt(now.squares + then.squares);
    forecast.light_gained = then.light > 0 ? gained / then.light : 0;
    constexpr double sure = 3;  // standard deviations
    forecast.is_light_sure = std::abs(gained) > sure * noise;
    return forecast;
  }

  double SecondsTo(const Forecast& forecast) const { return forecast.SecondsTo(target_square_); }

  bool IsNoticeablyFaster(const Forecast& forecast) const {
    constexpr double noticeable = 1.1;  // less is within what squares vary by
    return noticeable * SecondsTo(forecast) < SecondsTo(asked_);
  }

  std::string ErrorOf(double square) const {
    const double root = std::sqrt(square);
    return IsOfLight(target_.unit) ? ErrorText(root, ErrorUnit::linear) : ErrorText(255 * root, ErrorUnit::display);
  }

  static std::string Line(std::string name, const std::string& error, const std::string& seconds,
                          const std::string& seconds_to_target) {
    const auto column = [](const std::string& text, std::size_t width) {
      return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
    };
    name.resize(std::max<std::size_t>(name.size(), 32), ' ');
    return name + column(error, 12) + column(seconds, 12) + column(seconds_to_target, 12) + "\n";
  }

  std::string Row(const Forecast& forecast) const {
    return Line(forecast.settings.empty() ? "as asked" : Typed(forecast.settings), ErrorOf(forecast.square),
                SecondsText(forecast.seconds), SecondsText(SecondsTo(forecast)));
  }

  std::string Heading() const {
    return "From " + Counted(base_.size(), "square") + " of 32x32 pixels at " + std::to_string(probed_samples) +
           " samples per pixel; seconds of one processor, for the whole image:\n" +
           Line("settings", "error", "seconds", "to " + ErrorText(target_.value, target_.unit));
  }

  std::string Conclusion(const Forecast& best) const {
    if (asked_.square == 0) return "No noise was found: one sample per pixel shows what there is.\n";
    std::string add = Typed(best.settings);
    if (!render_.budget.error) add += (add.empty() ? "-error " : " -error ") + ShowErrorTarget(target_);
    const std::string target = ErrorText(target_.value, target_.unit);
    if (best.settings.empty())
      return "No other settings get to " + target + " noticeably faster" + (add.empty() ? "" : "; add: " + add) + "\n";
    return "To get to " + target + " " + Rounded(SecondsTo(asked_) / SecondsTo(best), 2) +
           " times as fast, add: " + add + "\n";
  }

  std::string Denoising() const {
    const bool can = render_.mode == RenderMode::whitted || render_.mode == RenderMode::path;
    if (!can || render_.denoise || asked_.square == 0) return {};
    const Forecast filtered = ForecastOf({{"denoise", ""}});
    return "With -denoise, " + std::to_string(probed_samples) + " samples leave an error of " +
           ErrorOf(filtered.square) + " instead of " + ErrorOf(asked_.square) + ", in " +
           SecondsText(filtered.seconds) + " seconds instead of " + SecondsText(asked_.seconds) + ".\n";
  }

  static std::string LightFound(const Forecast& forecast) {
    constexpr double noticeable = 0.005;
    if (!forecast.is_light_sure || std::abs(forecast.light_gained) < noticeable) return {};
    return "With " + Typed(forecast.settings) + " the image has " + Rounded(100 * std::abs(forecast.light_gained), 2) +
           "% " + (forecast.light_gained > 0 ? "more" : "less") + " light, which no number of samples changes.\n";
  }

  const World& world_;
  const Accelerator& accelerator_;
  const RenderSettings& render_;
  const ErrorTarget target_;
  const std::vector<ProbedSquare> base_;
  double target_square_ = 0;
  Forecast asked_;
};

}  // namespace

std::string Advice(const World& world, const Accelerator& accelerator, const RenderSettings& render) {
  return Advisor(world, accelerator, render).Text();
}

}  // namespace ray
