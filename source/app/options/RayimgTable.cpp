#include "source/app/options/RayimgTable.h"

#include <array>
#include <limits>

#include "R2/ToneCurve.h"
#include "source/app/Status.h"
#include "source/app/options/OptionEntry.h"
#include "source/text/Number.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

std::vector<std::string> ToneCurveNames() {
  std::vector<std::string> names;
  for (const R2::ToneCurve& curve : R2::ToneCurves()) names.emplace_back(curve.name);
  return names;
}

/// "1,2,0.5": numbers above 0.
std::optional<std::vector<double>> ReadWeights(const std::string& word) {
  std::vector<double> weights;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find(',', at), word.size());
    const auto number = ParseNumber(std::string_view(word).substr(at, end - at));
    if (number.problem || !(number.value > 0)) return {};
    weights.push_back(number.value);
    at = end + 1;
  }
  return weights;
}

/// A limit that is none unless given. `most`: 0 for any number.
template <int most>
std::optional<double> ReadThreshold(const std::string& word) {
  const auto number = ParseNumber(word);
  if (number.problem || !(number.value >= 0) || (most > 0 && number.value > most)) return {};
  return number.value;
}

/// None of these has a default to show.
template <class T>
std::string ShowNothing(const T&) {
  return {};
}

template <int most, class Lambda>
Word Threshold(Lambda member, const char* range) {
  return WordOf<ReadThreshold<most>, ShowNothing<std::optional<double>>>(member, range);
}

// One entry stays one thought.
// clang-format off
constexpr std::array commands{
    CommandKind{"diff", "picture reference", 2, 2, "print how far a picture is from a reference", R"(
Means are over all channels of all pixels that are finite in both pictures; x is the picture, r the reference.
  linear RMSE      sqrt(mean (x-r)^2)
  relMSE           mean (x-r)^2 / (r^2 + 0.01)
  display RMSE     as the linear one, of the values for a screen, in 255ths. Those are clamped to 0..1 and, with -srgb,
                   encoded; without it they are taken as they are
  PSNR             -10 log10(mean square) of the same values, in dB
  FLIP             mean perceived difference when the pictures alternate (Andersson et al. 2020), of the same values
  largest          the largest |x-r|, its pixel (x from the left, y from the bottom) and channel
  bias             mean x-r, channel by channel
With -reference2 c, the same picture as r from another random seed, also mean (x-r)(x-c) and its root: the error
without the noise of the reference, which the linear RMSE counts as error of x (how misleading that can be: Whittle et
al. 2017).
With thresholds the exit status is 1 when one is exceeded. Pixels that are NaN or infinite fail every threshold.
)"},
    CommandKind{"info", "picture...", 1, any_number, "print what is in pictures and how they were made", R"(
Size, format and metadata; of the finite values as stored, the minimum, mean and maximum of each channel and the mean
luminance (0.30 r + 0.59 g + 0.11 b); how many values are negative, and how many NaN or infinite.
)"},
    CommandKind{"convert", "in out", 2, 2, "write a picture in another format, brighter, tone-mapped or encoded", R"(
Values are multiplied by 2^exposure, go through the tone curve, channel by channel, and are encoded. Pictures of floats
(pfm, hdr, exr) are never encoded. The metadata is kept, and the conversion added to it.
)"},
    CommandKind{"merge", "picture...", 2, any_number, "average float pictures of different seeds", R"(
Writes the weighted mean of pictures of floats (pfm, hdr, exr) of one size to the file that -out names. Refuses those
that are not independent (the same scene or command, and a seed in common), those of different scenes or settings and
those that were interrupted.
)"},
    CommandKind{"movie", "out.avi frame.jpg...", 2, any_number, "make a movie from JPEG pictures", R"(
Writes an AVI file of motion JPEG: the frames as they are, in the order named, and an index. Nothing is encoded again,
so the quality is that of the pictures. They must be JPEG and of one size; the same picture may be listed
more than once.
)"},
};

// clang-format on

}  // namespace

std::span<const CommandKind> Commands() { return commands; }

// clang-format off
std::vector<OptionKind> OptionsOfCommands() {
  constexpr double most_stops = 64;
  constexpr double slowest_movie = 0.1, fastest_movie = 1000;
  using enum KnownTo;
  return {
      {"srgb", rayimg, {}, {}, Flag{AT(image.srgb)}, "", "",
       "linear workflow: decode 8 and 16 bit pictures from sRGB, encode what is shown or written",
       {"diff", "convert"}},
      {"reference2", rayimg, {}, {"picture"}, FileName{AT(image.reference2), FileKind::image}, "", "",
       "a second reference from another random seed, for the error without their noise", {"diff"}},
      {"map", rayimg, {}, {"picture"}, FileName{AT(image.map), FileKind::image}, "", "",
       "write a heat map of the difference, black 0 to white 1", {"diff"}},
      {"map_of", rayimg, {}, {"name"}, OneOfEnum<MapOf>(AT(image.map_of)), "", "",
       "what the map shows: FLIP, or the largest difference of a displayed channel", {"diff"}},
      {"pixels_per_degree", rayimg, {}, {"x"}, Number<double>{AT(image.pixels_per_degree), 1, 1000}, "", "",
       "FLIP: pixels per degree of view; by default those of 3840 pixels seen from their own width",
       {"diff"}},
      {"fail", rayimg, {}, {"x"}, Threshold<0>(AT(image.fail), "a number, at least 0"), "", "",
       "a pixel fails when a channel differs by more than this", {"diff"}},
      {"fail_percent", rayimg, {}, {"p"}, Threshold<100>(AT(image.fail_percent), "a number, 0 to 100"), "", "",
       "percentage of the pixels that may fail; 0 by default", {"diff"}},
      {"fail_rmse", rayimg, {}, {"x"}, Threshold<0>(AT(image.fail_rmse), "a number, at least 0"), "", "",
       "the largest linear RMSE allowed", {"diff"}},
      {"fail_flip", rayimg, {}, {"x"}, Threshold<1>(AT(image.fail_flip), "a number, 0 to 1"), "", "",
       "the largest mean FLIP allowed", {"diff"}},
      {"json", rayimg, {}, {}, Flag{AT(image.json)}, "", "",
       "print a JSON object; what is infinite or unknown is null", {"diff"}},

      {"exposure", rayimg, {}, {"stops"}, Number<double>{AT(image.exposure), -most_stops, most_stops}, "", "",
       "multiply by two to this power", {"convert"}},
      {"tonemap", rayimg, {}, {"name"}, OneOfNames(AT(image.tonemap), ToneCurveNames), "", "",
       "reinhard: x/(1+x), Reinhard 2002; aces: Narkowicz 2015; filmic: Hable 2010", {"convert"}},
      {"bits", rayimg, {}, {"n"}, OneNumberOf{AT(image.bits), {8, 16}}, "bits per channel", "",
       "bit depth of a PNG", {"convert"}},
      {"jpeg_quality", rayimg, {}, {"n"}, Number<int>{AT(image.jpeg_quality), 1, 100}, "", "", "JPEG quality",
       {"convert"}},

      {"out", rayimg, {}, {"picture"}, FileName{AT(image.out), FileKind::image}, "", "", "the picture to write", {"merge"}},
      {"weights", rayimg, {}, {"w1,w2,..."}, WordOf<ReadWeights, ShowNothing<std::vector<double>>>(AT(image.weights),
        "numbers above 0, separated by commas"), "", "",
       "one per picture; by default the samples in the metadata, if all have them, else equal", {"merge"}},
      {"force", rayimg, {}, {}, Flag{AT(image.force)}, "", "",
       "merge pictures even if they are not independent, not alike or were interrupted", {"merge"}},

      {"fps", rayimg, {}, {"n"}, Number<double>{AT(image.fps), slowest_movie, fastest_movie}, "", "",
       "frames per second", {"movie"}},
  };
}
// clang-format on

void CheckTogether(const CommandKind& command, const Options& options) {
  if (options.fail_percent && !options.fail) throw UsageError("-fail_percent has no effect without -fail");
  if (options.map_of != Options().map_of && options.map.empty()) throw UsageError("-map_of has no effect without -map");
  if (std::string_view(command.name) == "merge" && options.out.empty())
    throw UsageError("merge needs -out picture, the picture to write");
  if (!options.weights.empty() && options.weights.size() != options.names.size())
    throw UsageError("-weights has " + Counted(options.weights.size(), "number") + " for " +
                     Counted(options.names.size(), "picture"));
}

}  // namespace ray::rayimg
