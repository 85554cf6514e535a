#include "source/app/options/CommandLine.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/app/Status.h"
#include "source/app/options/Help.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/Preset.h"
#include "source/text/EnumNames.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

const OptionKind& Known(Program program, const std::string& word) {
  const std::string name = SplitOption(word).name;
  if (const OptionKind* option = FindOption(program, name)) return *option;
  std::string hint;
  if (const OptionKind* option = FindOption(TheOther(program), name)) {
    hint = "; -" + std::string(option->name) + " is an option of " + NameOf(TheOther(program));
  } else {
    std::vector<std::string> names;
    for (const OptionKind& known : OptionTable(program)) names.push_back("-" + std::string(known.name));
    hint = DidYouMean("-" + name, names);
  }
  throw UsageError("unknown option " + Quoted(word) + hint + " (" + NameOf(program) + " -help lists them all)");
}

/// The arguments of the option at the front of `words`, and how many words they and the option take.
struct Arguments {
  std::vector<std::string> values;
  std::size_t words_taken = 1;
};

Arguments TakeArguments(const OptionKind& option, std::span<const std::string> words) {
  const std::string synopsis = Synopsis(option);
  Arguments arguments;
  if (const auto attached = SplitOption(words[0]).attached) {
    if (MostArguments(option) != 1)
      throw UsageError(Quoted(words[0]) + ": '=' joins one argument only; type " + synopsis);
    arguments.values.push_back(*attached);
    return arguments;
  }
  while (arguments.values.size() < MostArguments(option) && arguments.words_taken < words.size() &&
         !LooksLikeOption(words[arguments.words_taken]))
    arguments.values.push_back(words[arguments.words_taken++]);
  if (arguments.values.size() >= FewestArguments(option)) return arguments;
  const bool at_end = arguments.words_taken == words.size();
  const std::string where = at_end ? "" : " before " + Quoted(words[arguments.words_taken]);
  throw UsageError("-" + std::string(option.name) + " needs " + Counted(MostArguments(option), "argument") + ", got " +
                   std::to_string(arguments.values.size()) + where + "; type " + synopsis);
}

/// Which options came already, and how they were spelled.
using Seen = std::map<const OptionKind*, std::string>;

void RefuseRepetition(const OptionKind& option, const std::string& word, Seen& seen) {
  const auto [first, is_new] = seen.emplace(&option, word);
  if (is_new || MayBeRepeated(option)) return;
  throw UsageError(Quoted(word) + " repeats " + Quoted(first->second) + "; an option may be given once");
}

void RefuseSecondTask(const OptionKind& option, const std::string& word, const Options& options) {
  if (!IsSetting(option) && options.task != Defaults(options.program).task)
    throw UsageError(Quoted(word) + " cannot be combined with another request");
}

void TakeName(const std::string& word, Options& options) {
  if (word.empty()) throw UsageError("a file name is empty");
  const bool takes_picture = options.program == Program::raypro;
  if (options.scene.empty())
    options.scene = word;
  else if (takes_picture && options.picture.empty())
    options.picture = word;
  else
    throw UsageError(Quoted(word) + " is one name too many, after the scene " + Quoted(options.scene) +
                     (takes_picture ? " and the picture " + Quoted(options.picture) : ""));
}

/// -help anywhere is answered, whatever else is wrong. (The course's program then exits with failure; we succeed, as
/// users of other programs expect.)
std::optional<Options> HelpAnywhere(Program program, std::span<const std::string> words) {
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const OptionKind* option = LooksLikeOption(words[i]) ? FindOption(program, SplitOption(words[i]).name) : nullptr;
    const auto* request = option ? std::get_if<Request>(&option->value) : nullptr;
    if (!request || request->task != Task::help) continue;
    Options options = Defaults(program);
    options.task = Task::help;
    // Among other words, what follows -help is as likely a file as a topic, and plain help is never wrong.
    const bool has_topic = SplitOption(words[i]).attached || (i == 0 && words.size() == 2);
    if (has_topic) Store(*option, TakeArguments(*option, words.subspan(i)).values, options);
    return options;
  }
  return {};
}

bool NeedsScene(Task task) {
  return task == Task::render || task == Task::view || task == Task::check || task == Task::debug_pixel;
}

void CheckNames(const Options& options) {
  if (!NeedsScene(options.task)) {
    if (!options.scene.empty()) throw UsageError(Quoted(options.scene) + " is one name too many");
    return;
  }
  const std::string usage = " (usage: " + Usage(options.program) + ")";
  if (options.scene.empty()) throw UsageError("no scene is named" + usage);
  if (options.task == Task::check && !options.report.empty())
    throw UsageError("-report needs a picture that is rendered; -check renders none");
  if (options.task == Task::render && options.picture.empty()) throw UsageError("no picture is named" + usage);
  if (options.task == Task::render && options.picture == options.report)
    throw UsageError("the picture and the report are the same file, " + Quoted(options.report));
}

/// A single pixel has no picture, no cost worth a table and no error.
void CheckPixel(const Options& options, const std::vector<std::string>& given) {
  if (options.task != Task::debug_pixel) return;
  if (!options.picture.empty())
    throw UsageError(Quoted(options.picture) + " is one name too many; -debugpixel makes no picture");
  for (const char* name : {"layers", "time", "error", "reference", "replay", "checkpoint", "resume", "stats", "report"})
    if (std::ranges::find(given, name) != given.end())
      throw UsageError("-" + std::string(name) + " needs a picture that is rendered; -debugpixel renders none");
  const auto& [x, y] = *options.pixel;
  const auto& [width, height] = std::tie(options.render.width, options.render.height);
  if (x >= 0 && x < width && y >= 0 && y < height) return;
  throw UsageError("-debugpixel " + std::to_string(x) + " " + std::to_string(y) + ": a picture of " +
                   std::to_string(width) + " x " + std::to_string(height) + " has columns 0 to " +
                   std::to_string(width - 1) + " and rows 0 to " + std::to_string(height - 1));
}

void CheckView(const ViewOptions& view) {
  if (view.context != ViewOptions().context && !view.headless)
    throw UsageError("-context needs -headless; a window brings its own");
  if (view.exit_immediately && !view.events.empty())
    throw UsageError("-exit_immediately and -events contradict each other");
}

void CheckSize(const RenderSettings& render) {
  const std::int64_t pixels = std::int64_t{render.width} * render.height;
  if (pixels > R2::max_pixels)
    throw UsageError("-width " + std::to_string(render.width) + " and -height " + std::to_string(render.height) +
                     " make " + Counted(static_cast<std::uint64_t>(pixels), "pixel") + "; at most " +
                     std::to_string(R2::max_pixels) + " are allowed");
}

void CheckCrop(const RenderSettings& render) {
  if (!render.crop) return;
  const PixelRectangle& c = *render.crop;
  const bool is_inside = c.x0 >= 0 && c.y0 >= 0 && c.x1 <= render.width && c.y1 <= render.height;
  if (is_inside && c.x0 < c.x1 && c.y0 < c.y1) return;
  const OptionKind& option = *FindOption(Program::raypro, "crop");
  Options given;
  given.render = render;
  throw UsageError("-crop " + Show(option, given) + ": it must be " + Range(option) + " of " +
                   std::to_string(render.width) + " x " + std::to_string(render.height));
}

void CheckEffects(const CameraEffects& camera) {
  if (camera.HasLens() && !(camera.focus > 0)) throw UsageError("-aperture needs -focus, the distance that is sharp");
}

void CheckBudget(const Options& options) {
  const Budget& budget = options.render.budget;
  if (!options.replay.empty() && budget.IsOpen()) throw UsageError("-replay and -time or -error contradict each other");
  if (!options.replay.empty() && options.resume) throw UsageError("-replay and -resume contradict each other");
  if (ShowsCosts(options.render.mode) && budget.error)
    throw UsageError(std::string("-error is an error of light; -mode ") + NameOf(options.render.mode) + " shows costs");
}

}  // namespace

Options ReadCommandLine(Program program, std::span<const std::string> words) {
  if (const auto help = HelpAnywhere(program, words)) return *help;

  Options options = Defaults(program);
  Seen seen;
  bool only_names = false;
  for (std::size_t i = 0; i < words.size();) {
    const std::string& word = words[i];
    if (!only_names && word == "--") {
      only_names = true;
      ++i;
    } else if (only_names || !LooksLikeOption(word)) {
      TakeName(word, options);
      ++i;
    } else {
      const OptionKind& option = Known(program, word);
      RefuseRepetition(option, word, seen);
      RefuseSecondTask(option, word, options);
      const Arguments arguments = TakeArguments(option, words.subspan(i));
      Store(option, arguments.values, options);
      i += arguments.words_taken;
    }
  }

  std::vector<std::string> given;
  for (const auto& [option, spelled] : seen) given.emplace_back(option->name);
  ApplyPreset(options, given);
  CheckNames(options);
  CheckEffects(options.render.camera);
  CheckBudget(options);
  CheckSize(options.render);
  CheckCrop(options.render);
  CheckPixel(options, given);
  CheckView(options.view);
  if (options.quiet && options.verbose) throw UsageError("-quiet and -verbose contradict each other");
  const R2::ImageFormat* format = R2::FormatForName(options.picture);
  options.render.srgb = options.encoding.srgb && !(format && format->is_linear);
  options.render.wants_passes = !options.report.empty() && options.render.samples > 1 && options.replay.empty();
  options.parse.decode_srgb = options.encoding.srgb;  // a linear workflow is linear from end to end
  return options;
}

void CheckMachine(const Options& options) {
  const std::string& name = options.accelerator.instruction_set;
  const std::vector<std::string> present = InstructionSets();
  if (name == "best" || std::find(present.begin(), present.end(), name) != present.end()) return;
  std::string list = "best";
  for (const std::string& one : present) list += ", " + one;
  throw UsageError("-simd " + name + ": this machine has " + list);
}

}  // namespace ray
