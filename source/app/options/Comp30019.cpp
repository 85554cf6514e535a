#include "source/app/options/Comp30019.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <variant>

#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/Overloaded.h"
#include "source/parse/courses/comp30019/View.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::comp30019 {
namespace {

/// Everything that the course's options decide, with their defaults.
struct Asked {
  std::string file, output;
  std::int64_t width = 400, height = 400, samples_a_side = 1, quality = 0;
  bool ambient = false;
  R3::Vector position{0, 0, 0}, axis{0, 0, 1};
  double angle = 0, aperture = 0, focus = 1;  // the angle in degrees
};

struct WholeNumber {
  std::int64_t Asked::*member;
  std::int64_t low, high;
};
struct RealNumber {
  double Asked::*member;
  double low;
};
using Value = std::variant<std::string Asked::*, bool Asked::*, R3::Vector Asked::*, WholeNumber, RealNumber>;

struct CourseOption {
  char letter;
  const char* name;
  const char* value_name;  // empty for a flag
  Value value;
  const char* help;
};

constexpr std::int64_t most_pixels_a_side = 1 << 30;
constexpr std::int64_t most_samples_a_side = 1 << 12;
constexpr std::int64_t best_quality = 10;  // 16 million shadow rays per pixel
constexpr double lowest = std::numeric_limits<double>::lowest();

constexpr std::array course_options{
    CourseOption{'f', "file", "path", &Asked::file, "scene to render (required)"},
    CourseOption{'o', "output", "path", &Asked::output, "image to write, a PNG (required)"},
    CourseOption{'w', "width", "n", WholeNumber{&Asked::width, 1, most_pixels_a_side}, "width of the image in pixels"},
    CourseOption{'h', "height", "n", WholeNumber{&Asked::height, 1, most_pixels_a_side},
                 "height of the image in pixels"},
    CourseOption{'x', "aa-mult", "n", WholeNumber{&Asked::samples_a_side, 1, most_samples_a_side},
                 "n x n samples per pixel"},
    CourseOption{'l', "ambient", "", &Asked::ambient, "ambient light, by tracing paths over many bounces"},
    CourseOption{'p', "cam-pos", "x,y,z", &Asked::position, "position of the camera"},
    CourseOption{'a', "cam-axis", "x,y,z", &Asked::axis, "axis that the camera is turned about"},
    CourseOption{'n', "cam-angle", "degrees", RealNumber{&Asked::angle, lowest}, "by how much it is turned"},
    CourseOption{'r', "aperture-radius", "r", RealNumber{&Asked::aperture, 0}, "radius of the lens, 0 for a pinhole"},
    CourseOption{'t', "focal-length", "d", RealNumber{&Asked::focus, 0}, "distance of what the lens sees sharply"},
    CourseOption{'q', "quality", "n", WholeNumber{&Asked::quality, 0, best_quality},
                 "each level halves the noise of soft shadows, ambient light and the lens"},
};

/// "-x, --aa-mult"
std::string NamesOf(const CourseOption& option) { return std::string("-") + option.letter + ", --" + option.name; }

[[noreturn]] void Refuse(const CourseOption& option, const std::string& rule, const std::string& word) {
  throw UsageError(NamesOf(option) + " must be " + rule + ", got " + Quoted(word));
}

R3::Vector ReadVector(const CourseOption& option, const std::string& word) {
  std::array<double, 3> parts{};
  std::string_view rest = word;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t comma = i + 1 < parts.size() ? rest.find(',') : rest.size();
    const auto number = ParseNumber(rest.substr(0, comma));
    if (comma == std::string_view::npos || number.problem)
      Refuse(option, "three numbers with commas and no spaces between them, such as 0,2,-0.5", word);
    parts[i] = number.value;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return {parts[0], parts[1], parts[2]};
}

void Store(const CourseOption& option, const std::string& word, Asked& asked) {
  std::visit(Overloaded{
                 [&](std::string Asked::*file) {
                   if (word.empty()) Refuse(option, "a file name", word);
                   asked.*file = word;
                 },
                 [&](bool Asked::*flag) { asked.*flag = true; },
                 [&](R3::Vector Asked::*vector) { asked.*vector = ReadVector(option, word); },
                 [&](const WholeNumber& whole) {
                   const auto number = ParseWhole(word);
                   if (number.problem || number.value < whole.low || number.value > whole.high)
                     Refuse(option,
                            "a whole number, " + std::to_string(whole.low) + " to " + std::to_string(whole.high), word);
                   asked.*whole.member = number.value;
                 },
                 [&](const RealNumber& real) {
                   const auto number = ParseNumber(word);
                   if (number.problem || number.value < real.low)
                     Refuse(option, real.low == lowest ? "a number" : "a number, at least " + ToText(real.low), word);
                   asked.*real.member = number.value;
                 },
             },
             option.value);
}

const CourseOption& Known(const std::string& word) {
  const std::string name = SplitOption(word).name;
  const bool is_long = word.starts_with("--");
  for (const CourseOption& option : course_options)
    if (is_long ? name == option.name : name == std::string(1, option.letter)) return option;
  std::vector<std::string> names{"--help"};
  for (const CourseOption& option : course_options) names.push_back(std::string("--") + option.name);
  throw UsageError("unknown option " + Quoted(word) + DidYouMean(word, names) + " (--help lists them all)");
}

/// The value of the option in front of `words`; takes the words from it.
std::string TakeValue(const CourseOption& option, std::span<const std::string>& words) {
  const auto attached = SplitOption(words[0]).attached;
  words = words.subspan(1);
  if (!*option.value_name) {
    if (attached) throw UsageError(NamesOf(option) + " takes no value");
    return {};
  }
  if (attached) return *attached;
  if (words.empty() || LooksLikeOption(words[0]))
    throw UsageError(NamesOf(option) + " needs a value: " + option.value_name);
  const std::string value = words[0];
  words = words.subspan(1);
  return value;
}

Asked Read(std::span<const std::string> words) {
  Asked asked;
  std::vector<const CourseOption*> seen;
  while (!words.empty()) {
    const std::string word = words[0];
    if (!LooksLikeOption(word))
      throw UsageError("unexpected extra argument " + Quoted(word) + "; the scene is named by --file");
    const CourseOption& option = Known(word);
    if (std::ranges::find(seen, &option) != seen.end()) throw UsageError(NamesOf(option) + " is given twice");
    seen.push_back(&option);
    Store(option, TakeValue(option, words), asked);
  }
  std::string missing;
  for (const CourseOption& option : course_options)
    if (const auto* file = std::get_if<std::string Asked::*>(&option.value); file && (asked.**file).empty())
      missing += (missing.empty() ? "" : " and ") + NamesOf(option);
  if (!missing.empty()) throw UsageError("missing: " + missing + " (--help lists all options)");
  if (asked.axis == R3::Vector{} && asked.angle != 0)
    throw UsageError("-a, --cam-axis must not be 0,0,0 where --cam-angle is not 0");
  if (asked.aperture > 0 && !(asked.focus > 0))
    throw UsageError("-t, --focal-length must be above 0 with --aperture-radius");
  return asked;
}

/// The same in raypro's words. What is left to chance gets 16 samples per pixel at quality 0, and 4 times as many, half
/// the noise, with each level: as shadow rays, or where every camera ray has its own chance, as camera rays.
std::vector<std::string> RayprosWords(const Asked& asked) {
  const bool is_lens = asked.aperture > 0;
  const bool is_random = asked.ambient || is_lens;
  const std::int64_t samples_a_side = asked.samples_a_side * (is_random ? std::int64_t{4} << asked.quality : 1);
  const std::int64_t shadow_samples = is_random ? 1 : std::int64_t{16} << 2 * asked.quality;
  std::vector<std::string> words{"-width=" + std::to_string(asked.width), "-height=" + std::to_string(asked.height),
                                 "-samples=" + std::to_string(samples_a_side * samples_a_side),
                                 "-shadow_samples=" + std::to_string(shadow_samples)};
  if (asked.ambient) words.insert(words.end(), {"-mode=path", "-lights=all"});
  if (is_lens) words.insert(words.end(), {"-aperture=" + ToText(asked.aperture), "-focus=" + ToText(asked.focus)});
  words.insert(words.end(), {"--", asked.file, asked.output});
  return words;
}

/// " [400]"; nothing for a flag, and for a file, which has none.
std::string DefaultOf(const CourseOption& option) {
  const Asked defaults;
  const auto bracketed = [](const std::string& value) { return " [" + value + "]"; };
  return std::visit(Overloaded{
                        [](std::string Asked::*) { return std::string(); },
                        [](bool Asked::*) { return std::string(); },
                        [&](R3::Vector Asked::*vector) {
                          const R3::Vector& v = defaults.*vector;
                          return bracketed(ToText(v.x) + "," + ToText(v.y) + "," + ToText(v.z));
                        },
                        [&](const WholeNumber& whole) { return bracketed(ToText(defaults.*whole.member)); },
                        [&](const RealNumber& real) { return bracketed(ToText(defaults.*real.member)); },
                    },
                    option.value);
}

bool IsHelp(const std::string& word) { return word == "--help"; }

bool IsAs(const std::string& word) { return LooksLikeOption(word) && SplitOption(word).name == "as"; }

/// How many words "-as comp30019" takes in front of the others; 0 where it is not there.
std::size_t WordsOfRequest(std::span<const std::string> words) {
  if (words.empty() || !IsAs(words[0])) return 0;
  if (const auto attached = SplitOption(words[0]).attached) return *attached == "comp30019" ? 1 : 0;
  return words.size() > 1 && words[1] == "comp30019" ? 2 : 0;
}

}  // namespace

bool IsAskedFor(int argc, const char* const* argv) {
  if (argc == 0) return false;
  const std::vector<std::string> words(argv + 1, argv + argc);
  return std::filesystem::path(argv[0]).filename() == "comp30019" || WordsOfRequest(words) > 0;
}

std::vector<std::string> WithRequest(std::span<const std::string> words) {
  std::vector<std::string> all{"-as", "comp30019"};
  const auto rest = words.subspan(WordsOfRequest(words));
  all.insert(all.end(), rest.begin(), rest.end());
  return all;
}

Options ReadCommandLine(std::span<const std::string> words) {
  words = words.subspan(WordsOfRequest(words));
  if (std::ranges::any_of(words, IsHelp)) {
    Options options = Defaults(Program::raypro);
    options.task = Task::help;
    options.subject = "comp30019";
    return options;
  }
  const Asked asked = Read(words);
  Options options = ray::ReadCommandLine(Program::raypro, RayprosWords(asked));
  options.as_course = true;
  if (!(asked.position == R3::Vector{}) || asked.angle != 0)
    options.render.view = ViewFrom(asked.position, asked.axis, asked.angle);
  return options;
}

std::string Help() {
  std::string text =
      "usage: comp30019 -f scene.txt -o image.png [options]\n"
      "       raypro -as comp30019 -f scene.txt -o image.png [options]\n\n"
      "The command line of COMP30019, Graphics and Interaction.\n\noptions:\n";
  for (const CourseOption& option : course_options) {
    const std::string names = "  " + NamesOf(option) + (*option.value_name ? " " : "") + option.value_name;
    constexpr std::size_t column_of_help = 34;
    text += names + std::string(column_of_help - names.size(), ' ') + option.help + DefaultOf(option) + "\n";
  }
  return text +
         "      --help                      print this help\n\n"
         "A value follows its option, or --option=value. Exit status: 0 on success, else 1.\n";
}

}  // namespace ray::comp30019
