#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>
#include <vector>

#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "rayimg/Independence.h"
#include "source/app/Status.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

using R2::ImageSettings;

constexpr const char* unless_forced = "; -force merges them anyway";

void RefuseDependent(const std::vector<std::string>& names, const std::vector<ImageSettings>& settings) {
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const auto why = WhyDependent(names[j], settings[j], names[i], settings[i]))
        throw UsageError(*why + unless_forced);
}

/// Returns the options of the render behind an image that determine its content, as typed, without its seed and
/// samples. std::nullopt if another program made it.
std::optional<std::string> Look(const ImageSettings& settings) {
  std::istringstream words(Setting(settings, "command"));
  std::string word, look;
  if (!(words >> word) || word != NameOf(Program::raypro)) return {};
  for (bool is_of_look = false; words >> word;) {
    if (LooksLikeOption(word)) {
      const OptionKind* option = FindOption(Program::raypro, SplitOption(word).name);
      is_of_look = option && option->facts.Has(Fact::image) && option->name != std::string("seed");
    }
    if (is_of_look) look += (look.empty() ? "" : " ") + word;
  }
  return look;
}

/// Returns why two images have different content, as far as their metadata show.
std::optional<std::string> WhyUnlike(const ImageSettings& a, const ImageSettings& b) {
  const auto differ = [&](const std::string& key) {
    return !Setting(a, key).empty() && !Setting(b, key).empty() && !Agree(a, b, key);
  };
  if (differ("scene_hash")) return "are of different scenes";
  if (Setting(a, "camera") != Setting(b, "camera")) return "are seen by different cameras";
  const auto look_of_a = Look(a), look_of_b = Look(b);
  if (!look_of_a || !look_of_b || *look_of_a == *look_of_b) return {};
  return "were rendered with different settings, " + Quoted(*look_of_a) + " and " + Quoted(*look_of_b);
}

void RefuseUnlike(const std::vector<std::string>& names, const std::vector<ImageSettings>& settings) {
  for (std::size_t i = 1; i < names.size(); ++i)
    if (const auto why = WhyUnlike(settings[0], settings[i]))
      throw UsageError(Quoted(names[0]) + " and " + Quoted(names[i]) + " " + *why + unless_forced);
}

void RefuseInterrupted(const std::vector<std::string>& names, const std::vector<ImageSettings>& settings) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string pixels = Setting(settings[i], "pixels");
    if (!pixels.empty() && pixels != "complete")
      throw UsageError(Quoted(names[i]) + " is not complete: " + Escaped(pixels) + unless_forced);
  }
}

void WarnOfUnknownSeeds(const std::vector<std::string>& names, const std::vector<ImageSettings>& settings) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (Seeds(settings[i]).empty())
      PrintError("rayimg: warning: " + Quoted(names[i]) + " records no seed; assuming it is independent");
}

/// Reads the metadata in a first pass, which decides whether and how the images are merged.
std::vector<ImageSettings> ReadSettings(const std::vector<std::string>& names) {
  std::vector<ImageSettings> settings;
  R2::Image first;
  for (const std::string& name : names) {
    const R2::DecodedImage decoded = ReadImageFile(name);
    if (!decoded.format->is_linear)
      throw UsageError(Quoted(name) + " is a " + decoded.format->name +
                       ", whose values are rounded and clamped; merge needs pfm, hdr or exr");
    if (settings.empty()) first = decoded.image;
    RefuseOtherSize(names[0], first, name, decoded.image);
    settings.push_back(decoded.settings);
  }
  return settings;
}

/// Returns the samples per pixel of all images, or std::nullopt. They are means over the pixels, and not integers if an
/// error or a clock ended the render.
std::optional<std::vector<double>> StoredSamples(const std::vector<std::string>& names,
                                                 const std::vector<ImageSettings>& settings) {
  constexpr double most = 9007199254740992;  // 2^53: beyond that, sums would not be exact
  std::vector<double> samples;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto number = ParseNumber(Setting(settings[i], "samples"));
    if (number.problem || !(number.value > 0 && number.value <= most)) {
      PrintError("rayimg: warning: " + Quoted(names[i]) +
                 " does not record its samples per pixel; all images get the same weight");
      return {};
    }
    samples.push_back(number.value);
  }
  return samples;
}

/// Scales weights by a power of two so that the largest is below 1 and no sum overflows; no mean changes by a bit.
std::vector<double> Scaled(std::vector<double> weights) {
  int exponent = 0;
  std::frexp(std::ranges::max(weights), &exponent);
  for (double& weight : weights) weight = std::ldexp(weight, -exponent);
  return weights;
}

/// Computes the mean in a second pass that reads the images again, one at a time, so that a hundred of them need no
/// more memory than two. Their warnings have been printed before.
R2::Image WeightedMean(const std::vector<std::string>& names, const std::vector<double>& weights) {
  R2::Image mean;
  std::vector<double> sums;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const R2::Image image = DecodeImageFile(names[i], ReadBytes(names[i])).image;
    if (i == 0) {
      mean = image;
      sums.resize(image.Channels().size());
    }
    RefuseOtherSize(names[0], mean, names[i], image);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += weights[i] * static_cast<double>(image.Channels()[k]);
  }
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (int y = 0; y < mean.Height(); ++y)
    for (int x = 0; x < mean.Width(); ++x) {
      const std::size_t k =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(mean.Width()) + static_cast<std::size_t>(x));
      mean.Set(x, y, R2::Color{sums[k], sums[k + 1], sums[k + 2]} / total);
    }
  return mean;
}

/// Returns the settings that all images share, all their seeds, and the sum of their samples if meaningful.
ImageSettings MergedSettings(const std::vector<ImageSettings>& settings, bool by_samples, double samples,
                             const std::string& command_line) {
  ImageSettings merged = settings[0];
  std::erase_if(merged, [&](const auto& entry) {
    return std::ranges::any_of(settings,
                               [&](const ImageSettings& one) { return !Agree(settings[0], one, entry.first); });
  });
  merged.erase("samples");
  merged.erase("seconds");
  if (by_samples) merged["samples"] = CountText(samples);
  std::string seeds;
  for (const ImageSettings& one : settings)
    for (const std::string& seed : Seeds(one)) seeds += (seeds.empty() ? "" : " ") + seed;
  if (!seeds.empty()) merged["seed"] = seeds;
  merged["program"] = NameAndVersion(Program::rayimg);
  merged["command"] = command_line;
  return merged;
}

}  // namespace

int Merge(const ImageOptions& options, const std::string& command_line) {
  const std::vector<std::string>& names = options.names;
  const ImageOutput output = CheckImageOutput(options.out, names);
  const std::vector<ImageSettings> settings = ReadSettings(names);
  if (!options.force) {
    RefuseDependent(names, settings);
    RefuseUnlike(names, settings);
    RefuseInterrupted(names, settings);
    WarnOfUnknownSeeds(names, settings);
  }

  const auto samples = options.weights.empty() ? StoredSamples(names, settings) : std::nullopt;
  const std::vector<double> equal(names.size(), 1.0);
  const std::vector<double>& weights = samples ? *samples : options.weights.empty() ? equal : options.weights;
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  Write(output, WeightedMean(names, Scaled(weights)), {},
        MergedSettings(settings, samples.has_value(), total, command_line));
  return status::done;
}

}  // namespace ray::rayimg
