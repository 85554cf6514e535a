#include "source/app/rayimg/Table.h"

#include <algorithm>
#include <array>
#include <limits>

#include "R2/ToneCurve.h"
#include "source/app/Status.h"
#include "source/app/rayimg/Commands.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();
constexpr double highest = std::numeric_limits<double>::max();

std::vector<std::string> ToneCurveNames() {
  std::vector<std::string> names;
  for (const R2::ToneCurve& curve : R2::ToneCurves()) names.emplace_back(curve.name);
  return names;
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
  FLIP             mean of what an eye notices when the pictures alternate (Andersson et al. 2020), of the same values
  largest          the largest |x-r|, with its pixel (x from the left, y from the bottom) and its channel
  bias             mean x-r, channel by channel
With -reference2 c, the same picture as r with other random numbers, also mean (x-r)(x-c) and its root: the error
without the noise of the reference, which the linear RMSE takes for an error of x (how misleading that can be: Whittle
et al. 2017).
With thresholds the exit status is 1 when one is exceeded. Pixels that are not finite fail every threshold.
)", Diff},
    CommandKind{"info", "picture...", 1, any_number, "print what is in pictures and how they were made", R"(
Size and format, the settings kept in the picture, and of the values as stored, those that are finite: smallest, mean
and largest of each channel, mean luminance (0.30 r + 0.59 g + 0.11 b); how many values are negative or not finite.
)", Info},
    CommandKind{"convert", "in out", 2, 2, "write a picture in another format, brighter, tone-mapped or encoded", R"(
Values are multiplied by 2^exposure, go through the tone curve, channel by channel, and are encoded. Pictures of floats
(pfm, hdr, exr) are never encoded. Settings kept in the picture stay, and what was done is added.
)", Convert},
    CommandKind{"merge", "picture...", 2, any_number, "average float pictures of different seeds", R"(
Writes the weighted mean of pictures of floats (pfm, hdr, exr) of one size to the file that -out names. Refuses those
that are not independent, of one scene or command with a seed in common, and those that were interrupted.
)", Merge},
    CommandKind{"movie", "out.avi frame.jpg...", 2, any_number, "make a movie of JPEG pictures", R"(
Writes an AVI file of motion JPEG: the frames as they are, in the order named, and an index. Nothing is encoded again,
so the quality is that of the pictures. They must be JPEG and of one size; one may be named more often.
)", Movie},
};

constexpr std::array requests{
    RequestKind{"help", "[command]", "print this, or the options of one command"},
    RequestKind{"version", "", "print the version and what is built in"},
    RequestKind{"complete", "shell", "print the completion script of a shell: bash, zsh or fish"},
    RequestKind{"man", "", "print the manual page"},
};

std::vector<OptionKind> MakeTable() {
  constexpr double most_stops = 64;
  constexpr double slowest_movie = 0.1, fastest_movie = 1000;
  return {
      {"srgb", "", Flag{&Options::srgb}, {"diff", "convert"},
       "light is linear: decode 8 and 16 bit pictures from sRGB, encode what is shown or written to it"},
      {"reference2", "picture", File{&Options::reference2}, {"diff"},
       "a second reference with other random numbers, for the error without their noise"},
      {"map", "picture", File{&Options::map}, {"diff"}, "write a heat map of the difference, black 0 to white 1"},
      {"map_of", "name", OneName{&Options::map_of, {"flip", "display"}}, {"diff"},
       "what the map shows: FLIP, or the largest difference of a displayed channel"},
      {"pixels_per_degree", "x", Number{&Options::pixels_per_degree, 1, 1000}, {"diff"},
       "FLIP: pixels in a degree of the view; as given, 3840 pixels seen from as far as they reach"},
      {"fail", "x", Threshold{&Options::fail, highest}, {"diff"},
       "a pixel fails when a channel differs by more than this"},
      {"fail_percent", "p", Threshold{&Options::fail_percent, 100}, {"diff"},
       "percent of the pixels that may fail; 0 unless given"},
      {"fail_rmse", "x", Threshold{&Options::fail_rmse, highest}, {"diff"}, "the largest linear RMSE allowed"},
      {"fail_flip", "x", Threshold{&Options::fail_flip, 1}, {"diff"}, "the largest mean FLIP allowed"},
      {"json", "", Flag{&Options::json}, {"diff"}, "print one JSON object; what is infinite or unknown is null"},

      {"exposure", "stops", Number{&Options::exposure, -most_stops, most_stops}, {"convert"},
       "multiply by two to this power"},
      {"tonemap", "name", OneName{&Options::tonemap, ToneCurveNames()}, {"convert"},
       "reinhard: x/(1+x), Reinhard 2002; aces: Narkowicz 2015; filmic: Hable 2010"},
      {"bits", "n", OneName{&Options::bits, {"8", "16"}}, {"convert"}, "bits a channel of a PNG"},
      {"jpeg_quality", "n", Whole{&Options::jpeg_quality, 1, 100}, {"convert"}, "quality of a JPEG"},

      {"out", "picture", File{&Options::out}, {"merge"}, "the picture to write"},
      {"weights", "w1,w2,...", Weights{&Options::weights}, {"merge"},
       "one a picture; else the samples kept in the pictures, if all have them, else equal ones"},
      {"force", "", Flag{&Options::force}, {"merge"}, "merge also what is not independent or was interrupted"},

      {"fps", "n", Number{&Options::fps, slowest_movie, fastest_movie}, {"movie"}, "frames a second"},
  };
}
// clang-format on

template <class... Lambda>
struct Overloaded : Lambda... {
  using Lambda::operator()...;
};
template <class... Lambda>
Overloaded(Lambda...) -> Overloaded<Lambda...>;

[[noreturn]] void Refuse(const OptionKind& option, const std::string& word) {
  throw UsageError("-" + std::string(option.name) + " must be " + Range(option) + ", got " + Quoted(word));
}

double ReadNumber(const OptionKind& option, const std::string& word, double low, double high) {
  const auto number = ParseNumber(word);
  if (number.problem || !(number.value >= low && number.value <= high)) Refuse(option, word);
  return number.value;
}

std::vector<double> ReadWeights(const OptionKind& option, const std::string& word) {
  std::vector<double> weights;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find(',', at), word.size());
    const auto number = ParseNumber(std::string_view(word).substr(at, end - at));
    if (number.problem || !(number.value > 0)) Refuse(option, word);
    weights.push_back(number.value);
    at = end + 1;
  }
  return weights;
}

}  // namespace

std::span<const CommandKind> Commands() { return commands; }
std::span<const RequestKind> Requests() { return requests; }

const CommandKind* FindCommand(const std::string& name) {
  const auto found = std::ranges::find_if(commands, [&](const CommandKind& c) { return name == c.name; });
  return found == commands.end() ? nullptr : &*found;
}

std::span<const OptionKind> OptionTable() {
  static const std::vector<OptionKind> table = MakeTable();
  return table;
}

const OptionKind* FindOption(const std::string& name) {
  for (const OptionKind& option : OptionTable())
    if (name == option.name) return &option;
  return nullptr;
}

bool Takes(const CommandKind& command, const OptionKind& option) {
  return std::ranges::any_of(option.commands, [&](const std::string& name) { return name == command.name; });
}

void Store(const OptionKind& option, const std::string& word, Options& options) {
  std::visit(
      Overloaded{
          [&](const Flag& flag) { options.*flag.member = true; },
          [&](const Number& number) { options.*number.member = ReadNumber(option, word, number.low, number.high); },
          [&](const Threshold& threshold) { options.*threshold.member = ReadNumber(option, word, 0, threshold.high); },
          [&](const Whole& whole) {
            const auto number = ParseWhole(word);
            if (number.problem || number.value < whole.low || number.value > whole.high) Refuse(option, word);
            options.*whole.member = static_cast<int>(number.value);
          },
          [&](const OneName& one) {
            if (std::ranges::find(one.choices, word) == one.choices.end())
              throw UsageError("-" + std::string(option.name) + " must be " + Range(option) + ", got " + Quoted(word) +
                               DidYouMean(word, one.choices));
            options.*one.member = word;
          },
          [&](const File& file) {
            if (word.empty()) Refuse(option, word);
            options.*file.member = word;
          },
          [&](const Weights& weights) { options.*weights.member = ReadWeights(option, word); },
      },
      option.value);
}

std::string Show(const OptionKind& option, const Options& options) {
  return std::visit(Overloaded{
                        [&](const Number& number) { return ToText(options.*number.member); },
                        [&](const Whole& whole) { return ToText(options.*whole.member); },
                        [&](const OneName& one) { return options.*one.member; },
                        [](const auto&) { return std::string(); },  // none of these has a default
                    },
                    option.value);
}

std::string Range(const OptionKind& option) {
  const auto interval = [](const char* kind, auto low, auto high) {
    return kind + ToText(low) + " to " + ToText(high);
  };
  return std::visit(Overloaded{
                        [](const Flag&) { return std::string(); },
                        [&](const Number& number) { return interval("a number, ", number.low, number.high); },
                        [&](const Threshold& threshold) {
                          return threshold.high == highest ? "a number, at least 0"
                                                           : interval("a number, ", 0, threshold.high);
                        },
                        [&](const Whole& whole) { return interval("a whole number, ", whole.low, whole.high); },
                        [](const OneName& one) { return OneOf(one.choices); },
                        [](const File&) { return std::string("the name of a file"); },
                        [](const Weights&) { return std::string("numbers above 0 with commas between them"); },
                    },
                    option.value);
}

std::vector<std::string> Choices(const OptionKind& option) {
  const auto* one = std::get_if<OneName>(&option.value);
  return one ? one->choices : std::vector<std::string>{};
}

std::string Synopsis(const char* name, const char* argument) {
  return "-" + std::string(name) + (*argument ? " " + std::string(argument) : "");
}

std::vector<std::string> CommandNames() {
  std::vector<std::string> names;
  for (const CommandKind& command : Commands()) names.emplace_back(command.name);
  return names;
}

std::vector<std::string> Shells() { return {"bash", "zsh", "fish"}; }

}  // namespace ray::rayimg
