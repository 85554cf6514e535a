#include "source/app/options/Comp30019.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <limits>

#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/OptionEntry.h"
#include "source/parse/courses/comp30019/View.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::comp30019 {
namespace {

constexpr int most_pixels_a_side = 1 << 30;
constexpr int most_samples_a_side = 1 << 12;
constexpr int best_quality = 10;  // 16 million shadow rays per pixel
constexpr double highest = std::numeric_limits<double>::max();

std::optional<R3::Vector> ReadVector(const std::string& word) {
  std::array<double, 3> parts{};
  std::string_view rest = word;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t comma = i + 1 < parts.size() ? rest.find(',') : rest.size();
    const auto number = ParseNumber(rest.substr(0, comma));
    if (comma == std::string_view::npos || number.problem) return {};
    parts[i] = number.value;
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return R3::Vector{parts[0], parts[1], parts[2]};
}

std::string ShowVector(const R3::Vector& v) { return ToText(v.x) + "," + ToText(v.y) + "," + ToText(v.z); }

template <class Lambda>
Word Triple(Lambda member) {
  return WordOf<ReadVector, ShowVector>(member,
                                        "three numbers with commas and no spaces between them, such as 0,2,-0.5");
}

/// The values of the options of COMP30019's command line, with their defaults.
struct Asked : Options {
  Asked() : Options(Program::raypro) {}

  std::string file, output;
  int width = 400, height = 400, samples_a_side = 1, quality = 0;
  bool ambient = false, one_sided = false;
  R3::Vector position{0, 0, 0}, axis{0, 0, 1};
  double angle = 0, aperture = 0, focus = 1;  // the angle in degrees
};

#define AT(member) AT_OF(Asked, member)

// clang-format would split entries over many lines.
// clang-format off
/// Returns the course's options, as rows like raypro's own. Their names are as in messages: "x, --aa-mult".
std::span<const OptionKind> CourseOptions() {
  using Whole = Number<int>;
  using Real = Number<double>;
  using enum KnownTo;
  static const std::vector<OptionKind> table{
      {"f, --file", raypro, {}, {}, {"path"}, FileName{AT(file)}, "", "", "scene to render (required)"},
      {"o, --output", raypro, {}, {}, {"path"}, FileName{AT(output)}, "", "",
       "image to write, a PNG (required)"},
      {"w, --width", raypro, {}, {}, {"n"}, Whole{AT(width), 1, most_pixels_a_side}, "", "",
       "width of the image in pixels"},
      {"h, --height", raypro, {}, {}, {"n"}, Whole{AT(height), 1, most_pixels_a_side}, "", "",
       "height of the image in pixels"},
      {"x, --aa-mult", raypro, {}, {}, {"n"}, Whole{AT(samples_a_side), 1, most_samples_a_side}, "", "",
       "n x n samples per pixel"},
      {"l, --ambient", raypro, {}, {}, {}, Flag{AT(ambient)}, "", "",
       "ambient light, by tracing paths over many bounces"},
      {"p, --cam-pos", raypro, {}, {}, {"x,y,z"}, Triple(AT(position)), "", "", "position of the camera"},
      {"a, --cam-axis", raypro, {}, {}, {"x,y,z"}, Triple(AT(axis)), "", "",
       "axis that the camera is turned about"},
      {"n, --cam-angle", raypro, {}, {}, {"degrees"}, Real{AT(angle), -highest, highest}, "", "",
       "by how much it is turned"},
      {"r, --aperture-radius", raypro, {}, {}, {"r"}, Real{AT(aperture), 0, highest}, "", "",
       "radius of the lens, 0 for a pinhole"},
      {"t, --focal-length", raypro, {}, {}, {"d"}, Real{AT(focus), 0, highest}, "", "",
       "focus distance of the lens"},
      {"q, --quality", raypro, {}, {}, {"n"}, Whole{AT(quality), 0, best_quality}, "", "",
       "each level halves the noise of soft shadows, ambient light and the lens"},
      {"one_sided, --one-sided", raypro, {}, {}, {}, Flag{AT(one_sided)}, "", "",
       "rays hit surfaces from their front only, except glass"},
  };
  return table;
}
// clang-format on

#undef AT

/// Returns "-x, --aa-mult".
std::string NamesOf(const OptionKind& option) { return std::string("-") + option.name; }
/// Returns the name before the comma: a letter, or raypro's own word.
std::string ShortNameOf(const OptionKind& option) { return std::string(option.name, std::strcspn(option.name, ",")); }
std::string LongNameOf(const OptionKind& option) { return std::strstr(option.name, "--"); }

bool IsFile(const OptionKind& option) { return std::holds_alternative<FileName>(option.value); }

const OptionKind& Known(const std::string& word) {
  std::string name = SplitOption(word).name;
  const bool is_long = word.starts_with("--");
  if (is_long) std::ranges::replace(name, '_', '-');
  for (const OptionKind& option : CourseOptions())
    if (is_long ? "--" + name == LongNameOf(option) : name == ShortNameOf(option)) return option;
  std::vector<std::string> names{"--help"};
  for (const OptionKind& option : CourseOptions()) names.push_back(LongNameOf(option));
  throw UsageError("unknown option " + Quoted(word) + DidYouMean(word, names) + " (--help lists them all)");
}

/// Returns the value of the option at the front of `words`, none or one, and removes its words.
std::vector<std::string> TakeValue(const OptionKind& option, std::span<const std::string>& words) {
  const auto attached = SplitOption(words[0]).attached;
  words = words.subspan(1);
  if (MostArguments(option) == 0) {
    if (attached) throw UsageError(NamesOf(option) + " takes no value");
    return {};
  }
  if (attached) return {*attached};
  if (words.empty() || LooksLikeOption(words[0]))
    throw UsageError(NamesOf(option) + " needs a value: " + option.arguments[0]);
  const std::string value = words[0];
  words = words.subspan(1);
  return {value};
}

Asked Read(std::span<const std::string> words) {
  Asked asked;
  std::vector<const OptionKind*> seen;
  while (!words.empty()) {
    const std::string word = words[0];
    if (!LooksLikeOption(word))
      throw UsageError("unexpected extra argument " + Quoted(word) + "; the scene is named by --file");
    const OptionKind& option = Known(word);
    if (std::ranges::find(seen, &option) != seen.end()) throw UsageError(NamesOf(option) + " is given twice");
    seen.push_back(&option);
    Store(option, TakeValue(option, words), asked);
  }
  std::string missing;
  for (const OptionKind& option : CourseOptions())
    if (IsFile(option) && asked.Show(option).empty()) missing += (missing.empty() ? "" : " and ") + NamesOf(option);
  if (!missing.empty()) throw UsageError("missing: " + missing + " (--help lists all options)");
  if (asked.axis == R3::Vector{} && asked.angle != 0)
    throw UsageError("-a, --cam-axis must not be 0,0,0 where --cam-angle is not 0");
  if (asked.aperture > 0 && !(asked.focus > 0))
    throw UsageError("-t, --focal-length must be above 0 with --aperture-radius");
  return asked;
}

/// Returns the equivalent raypro options. Random effects get 16 samples per pixel at quality 0, and 4 times as many,
/// half the noise, with each level: as shadow rays, or as camera rays if each of these makes its own random choice.
std::vector<std::string> RayprosWords(const Asked& asked) {
  const bool is_lens = asked.aperture > 0;
  const bool is_random = asked.ambient || is_lens;
  const std::int64_t samples_a_side = asked.samples_a_side * (is_random ? std::int64_t{4} << asked.quality : 1);
  const std::int64_t shadow_samples = is_random ? 1 : std::int64_t{16} << 2 * asked.quality;
  std::vector<std::string> words{"-width=" + std::to_string(asked.width), "-height=" + std::to_string(asked.height),
                                 "-samples=" + std::to_string(samples_a_side * samples_a_side),
                                 "-shadow_samples=" + std::to_string(shadow_samples)};
  if (asked.ambient) words.insert(words.end(), {"-mode=path", "-lights=all"});
  if (asked.one_sided) words.push_back("-one_sided");
  if (is_lens) words.insert(words.end(), {"-aperture=" + ToText(asked.aperture), "-focus=" + ToText(asked.focus)});
  words.insert(words.end(), {"--", asked.file, asked.output});
  return words;
}

bool IsHelp(const std::string& word) { return word == "--help"; }

bool IsAs(const std::string& word) { return LooksLikeOption(word) && SplitOption(word).name == "as"; }

/// Returns the number of words of a leading "-as comp30019"; 0 if it is missing.
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

RenderOptions ReadCommandLine(std::span<const std::string> words) {
  words = words.subspan(WordsOfRequest(words));
  if (std::ranges::any_of(words, IsHelp)) {
    RenderOptions options;
    options.request = FindOption(Program::raypro, "help");
    options.subject = "comp30019";
    return options;
  }
  const Asked asked = Read(words);
  RenderOptions options = ray::ReadCommandLine(Program::raypro, RayprosWords(asked));
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
  for (const OptionKind& option : CourseOptions()) {
    const std::string names = "  " + Synopsis(option), standard = Asked().Show(option);
    constexpr std::size_t column_of_help = 34;
    text += names + std::string(column_of_help - names.size(), ' ') + option.help +
            (standard.empty() ? "" : " [" + standard + "]") + "\n";
  }
  return text +
         "      --help                      print this help\n\n"
         "A value follows its option, or --option=value. Exit status: 0 on success, else 1.\n";
}

}  // namespace ray::comp30019
