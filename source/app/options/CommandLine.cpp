#include "source/app/options/CommandLine.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/app/Status.h"
#include "source/app/manual/Help.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/FileNames.h"
#include "source/app/options/ForeignOption.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/PictureName.h"
#include "source/app/options/Preset.h"
#include "source/app/options/RayimgTable.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/Memory.h"
#include "source/film/denoise/DenoiseFilters.h"
#include "source/text/EnumNames.h"
#include "source/text/LookAlike.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// "; -crop is an option of raypro", or the option that was meant.
std::string HintAt(Program program, const std::string& word) {
  if (std::string hint = ForeignHint(program, word); !hint.empty()) return hint;
  const std::string name = SplitOption(word).name;
  for (const Program other : programs)
    if (const OptionKind* option = FindOption(other, name))
      return "; -" + std::string(option->name) + " is an option of " + NameOf(other);
  std::vector<std::string> names;
  for (const OptionKind& known : OptionTable(program)) names.push_back("-" + std::string(known.name));
  return DidYouMean("-" + name, names);
}

const OptionKind& Known(Program program, const std::string& word) {
  const std::string name = SplitOption(word).name;
  if (const OptionKind* option = FindOption(program, name)) return *option;
  // A phrase says what to do; a guess may be wrong, and then the help has the answer.
  if (const std::string answer = ForeignHint(program, word); !answer.empty() && !answer.starts_with("; did you mean"))
    throw UsageError("unknown option " + Quoted(word) + answer);
  throw UsageError("unknown option " + Quoted(word) + HintAt(program, word) + " (" + NameOf(program) +
                   " -help lists them all)");
}

/// Refuses "–width", which begins with another dash than options do and would be the name of a file.
void RefuseLookAlikes(Program program, std::span<const std::string> words) {
  for (const std::string& word : words) {
    if (word == "--") return;
    const std::string plain = WithoutLookAlikes(word);
    if (plain == word || LooksLikeOption(word) || !LooksLikeOption(plain)) continue;
    if (FindOption(program, SplitOption(plain).name))
      throw UsageError("unknown option " + Quoted(word) + "; " + LookAlikeHint(word));
  }
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
    if (MostArguments(option) == 0) throw UsageError(Quoted(words[0]) + ": " + Quoted(synopsis) + " takes no value");
    if (MostArguments(option) != 1) throw UsageError(Quoted(words[0]) + ": '=' takes exactly one value: " + synopsis);
    arguments.values.push_back(*attached);
    return arguments;
  }
  while (arguments.values.size() < MostArguments(option) && arguments.words_taken < words.size() &&
         !LooksLikeOption(words[arguments.words_taken]))
    arguments.values.push_back(words[arguments.words_taken++]);
  if (arguments.values.size() >= FewestArguments(option)) return arguments;
  if (arguments.values.empty())
    throw UsageError("-" + std::string(option.name) +
                     (MostArguments(option) == 1 ? " needs a value: " : " needs values: ") + synopsis);
  throw UsageError("-" + std::string(option.name) + " needs " + Counted(MostArguments(option), "value") + ", got " +
                   std::to_string(arguments.values.size()) + ": " + synopsis);
}

Task TaskOf(const OptionKind& option) {
  if (const auto* pixel = std::get_if<PixelRequest>(&option.value)) return pixel->task;
  return std::get<Request>(option.value).task;
}

/// The name of the option that asked for the task.
std::string NameOfRequest(Task task, Program program) {
  for (const OptionKind& option : OptionTable(program))
    if (!IsSetting(option) && TaskOf(option) == task) return option.name;
  return {};
}

void RefuseSecondTask(const OptionKind& option, const std::string& word, const Options& options) {
  if (IsSetting(option) || options.task == Defaults(options.program).task || options.task == TaskOf(option)) return;
  throw UsageError(Quoted(word) + " cannot be combined with -" + NameOfRequest(options.task, options.program));
}

const CommandKind& KnownCommand(Program program, const std::string& word) {
  if (const CommandKind* command = FindCommand(program, word)) return *command;
  const std::vector<std::string> names = CommandNamesOf(program);
  const std::string hint = DidYouMean(word, names);
  throw UsageError("unknown command " + Quoted(word) + (hint.empty() ? "; it must be " + OneOf(names) : hint));
}

void TakeName(const std::string& word, Options& options) {
  if (word.empty()) throw UsageError("a file name is empty");
  if (options.program == Program::raygrade) {
    options.grade.names.push_back(word);
  } else if (options.command) {
    if (options.image.names.size() == options.command->most)
      RefuseName(word, UsageOf(options.program, options.command));
    options.image.names.push_back(word);
  } else if (!CommandsOf(options.program).empty()) {
    options.command = &KnownCommand(options.program, word);
  } else if (options.program == Program::raypro) {
    options.scenes.push_back(word);
  } else if (options.files.scene.empty()) {
    options.files.scene = word;
  } else {
    RefuseName(word, UsageOf(options.program, options.command));
  }
}

/// "-h 512" was meant to be a height.
void RefuseHeight(const OptionKind& option, std::span<const std::string> words) {
  const auto [name, attached] = SplitOption(words[0]);
  const std::string value = attached ? *attached : words.size() > 1 ? words[1] : "";
  const auto height = ParseWhole(value);
  if (name == option.name || height.problem || height.value < 1) return;
  throw UsageError(Quoted("-" + name + " " + value) + ": -" + name + " is -" + option.name +
                   "; did you mean '-height " + value + "'?");
}

/// -help anywhere is answered, whatever else is wrong. (The course's program then exits with failure; we succeed, as
/// users of other programs expect.)
std::optional<Options> HelpAnywhere(Program program, std::span<const std::string> words) {
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const OptionKind* option = LooksLikeOption(words[i]) ? FindOption(program, SplitOption(words[i]).name) : nullptr;
    const auto* request = option ? std::get_if<Request>(&option->value) : nullptr;
    if (!request || request->task != Task::help) continue;
    RefuseHeight(*option, words.subspan(i));
    Options options = Defaults(program);
    options.task = Task::help;
    // Among other words, what follows -help is as likely a file as a topic, and plain help is never wrong.
    const bool has_topic = SplitOption(words[i]).attached || (i == 0 && words.size() == 2);
    if (has_topic)
      Store(*option, TakeArguments(*option, words.subspan(i)).values, options);
    else if (FindCommand(program, words[0]))
      options.subject = words[0];
    return options;
  }
  return {};
}

void CheckCommand(const Options& options) {
  if (options.task != Task::command) {
    if (options.command) RefuseName(options.command->name, "");
    return;
  }
  if (!options.command)
    throw UsageError("no command is named; it must be " + OneOf(CommandNamesOf(options.program)) +
                     UsageOf(options.program));
  const CommandKind& command = *options.command;
  for (const std::string& name : options.given)
    if (const OptionKind* option = FindOption(options.program, name); !Takes(command, *option))
      throw UsageError("-" + name + " is an option of " + NameOf(options.program) + " " +
                       OneOf({option->commands.begin(), option->commands.end()}) + ", not of " + command.name);
  if (options.image.names.size() < command.fewest)
    throw UsageError(std::string(command.name) + " needs " + Counted(command.fewest, "file name") + ", got " +
                     std::to_string(options.image.names.size()) + UsageOf(options.program, options.command));
  rayimg::CheckTogether(command, options.image);
}

/// What only renders has no effect; what decides how the scene is read has.
void CheckConvert(const Options& options) {
  if (options.task != Task::convert) return;
  if (!options.files.picture.empty()) RefuseName(options.files.picture, "; -convert writes no image");
  for (const std::string& name : options.given) {
    const OptionKind& option = *FindOption(options.program, name);
    if (IsSetting(option) && !option.facts.Has(Fact::with_convert))
      throw UsageError("-" + name + " has no effect with -convert, which renders nothing");
  }
}

void CheckPixelIsInPicture(const Options& options) {
  if (!options.pixel) return;
  const auto& [x, y] = *options.pixel;
  const auto& [width, height] = std::tie(options.render.width, options.render.height);
  if (x >= 0 && x < width && y >= 0 && y < height) return;
  throw UsageError("-debugpixel " + std::to_string(x) + " " + std::to_string(y) + ": an image of " +
                   std::to_string(width) + " x " + std::to_string(height) + " has columns 0 to " +
                   std::to_string(width - 1) + " and rows 0 to " + std::to_string(height - 1));
}

void CheckView(const ViewOptions& view) {
  if (view.context != ViewOptions().context && !view.headless)
    throw UsageError("-context has no effect without -headless; a window has its own context");
}

void CheckContradictions(const Options& options) {
  for (const OptionKind& option : OptionTable(options.program))
    for (const char* other : option.facts.excludes)
      if (options.IsGiven(option.name) && options.IsGiven(other))
        throw UsageError("-" + std::string(option.name) + " and -" + other + " contradict each other");
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
  throw UsageError("-crop " + given.Show(option) + ": it must be " + Range(option) + " of " +
                   std::to_string(render.width) + " x " + std::to_string(render.height));
}

void CheckEffects(const CameraEffects& camera) {
  if (camera.HasLens() && !(camera.focus > 0)) throw UsageError("-aperture needs -focus, the focus distance");
}

/// Light has noise, and two streams tell what is noise.
void CheckDenoise(const Options& options) {
  const RenderSettings& render = options.render;
  if (!render.denoise) return;
  if (render.mode != RenderMode::whitted && render.mode != RenderMode::path)
    throw UsageError(std::string("-denoise has no effect with -mode ") + NameOf(render.mode) +
                     "; it is for whitted and path");
  if (render.samples < 2 && !render.budget.IsOpen() && options.files.replay.empty())
    throw UsageError("-denoise needs -samples 2 or more, -error or -time");
}

/// A library that is asked for must be there before the first ray.
void CheckDenoiser(const RenderSettings& render) {
  if (!render.denoise || render.denoiser == Denoiser::automatic) return;
  try {
    DenoiseFilters(render.denoiser, render.threads);
  } catch (const DenoiserError& error) {
    throw UsageError(std::string("-denoiser ") + NameOf(render.denoiser) + ": " + error.what());
  }
}

/// Square grids in pixels need square numbers of camera rays.
void CheckGrid(const RenderSettings& render) {
  if (!IsGrid(render.trace.sampler)) return;
  const std::string sampler = std::string("-sampler ") + NameOf(render.trace.sampler);
  if (render.budget.IsOpen() || render.denoise)
    throw UsageError(
        sampler +
        " takes all its samples; it cannot be combined with -time, -error or -denoise, as -sampler sobol can");
  const auto samples = static_cast<std::uint32_t>(render.samples), each = render.camera.SamplesOfOnePlace();
  const std::int64_t side = GridSide(samples / each);
  const std::int64_t fewer = side * side * each, more = (side + 1) * (side + 1) * each;
  if (fewer == samples) return;
  const int moments = render.camera.shutter_samples, places = static_cast<int>(each) / moments;
  const std::string lens = places > 1 ? " times -lens_samples " + std::to_string(places) : "";
  const std::string shutter = moments > 1 ? " times -shutter_samples " + std::to_string(moments) : "";
  throw UsageError("-samples " + std::to_string(samples) + ": " + sampler + " needs a square number" + lens + shutter +
                   ", such as " + std::to_string(fewer) +
                   (more <= std::numeric_limits<int>::max() ? " or " + std::to_string(more) : ""));
}

/// Budgets decide by errors.
void CheckNeighbors(const RenderSettings& render) {
  if (render.budget.adaptive != Adaptive::neighbors) return;
  if (render.budget.seconds > 0 || render.budget.error || render.denoise)
    throw UsageError(
        "-adaptive neighbors takes one sample or all of them; it cannot be combined with -time, -error or -denoise");
}

/// What is decided by errors needs samples of every pixel, and costs and numbers of primitives have no mean.
void CheckSubsampling(const RenderSettings& render) {
  if (!IsSubsampled(render)) return;
  const std::string samples = "-samples " + ShowSamples(render) + " leaves pixels out; it cannot be combined with ";
  if (render.budget.error) throw UsageError(samples + "-error");
  if (render.denoise) throw UsageError(samples + "-denoise");
  if (render.budget.adaptive == Adaptive::neighbors) throw UsageError(samples + "-adaptive neighbors");
  if (ShowsCosts(render.mode) || render.mode == *Named<RenderMode>("id"))
    throw UsageError(samples + "-mode " + NameOf(render.mode));
}

void CheckBudget(const Options& options) {
  const Budget& budget = options.render.budget;
  if (!options.files.replay.empty() && budget.IsOpen())
    throw UsageError("-replay and -time or -error contradict each other");
  if (ShowsCosts(options.render.mode) && budget.error)
    throw UsageError(std::string("-error has no effect with -mode ") + NameOf(options.render.mode) +
                     ", which shows costs");
}

/// -part, -missing and -parts, with each other and with what only a finished image has.
void CheckParts(const Options& options) {
  const bool is_part = options.render.part.has_value(), assembles = !options.parts.empty() && options.missing == 0;
  if (assembles && options.checkpoint.resume)
    throw UsageError("-parts and -resume contradict each other: the checkpoint of an assembled image has the parts");
  if (!is_part && options.missing == 0) return;
  for (const std::string& name : options.given)
    if (FindOption(options.program, name)->facts.Has(Fact::whole_image))
      throw UsageError("-" + name + " needs the whole image; it cannot be combined with -" +
                       (is_part ? "part" : "missing"));
}

/// Everything that is wrong together, though each word is right by itself.
void CheckTogether(const Options& options) {
  CheckBudget(options);
  CheckSize(options.render);
  CheckConvert(options);
  CheckView(options.view);
  CheckContradictions(options);
  CheckParts(options);
}

/// What follows from other options.
void Derive(Options& options) {
  RenderSettings& render = options.render;
  render.srgb = options.encoding.srgb;  // as displayed, though a format of light keeps light
  render.quantization = options.encoding.quantization;
  render.wants_passes = !options.files.report.empty() && render.samples > 1;
  options.parse.problem_of = ProblemOf;
  options.parse.max_texture_bytes = MemoryLimit(options.memory);
  options.parse.aspect = static_cast<double>(options.render.width) / options.render.height;
  options.parse.decode_srgb = options.encoding.srgb;  // a linear workflow is linear from end to end
}

}  // namespace

Options ReadCommandLine(Program program, std::span<const std::string> words) {
  if (const auto help = HelpAnywhere(program, words)) return *help;

  RefuseLookAlikes(program, words);
  Options options = Defaults(program);
  std::set<const OptionKind*> seen;
  const bool renders = CommandsOf(program).empty();
  bool only_names = false;
  for (std::size_t i = 0; i < words.size();) {
    const std::string& word = words[i];
    if (!only_names && word == "--") {
      only_names = true;
      ++i;
    } else if (only_names || !(LooksLikeOption(word) || (renders && IsOfPovRay(word)))) {
      TakeName(word, options);
      ++i;
    } else {
      const OptionKind& option = Known(program, word);
      seen.insert(&option);
      RefuseSecondTask(option, word, options);
      const Arguments arguments = TakeArguments(option, words.subspan(i));
      Store(option, arguments.values, options);
      i += arguments.words_taken;
    }
  }

  for (const OptionKind* option : seen) options.given.emplace_back(option->name);
  ApplyPreset(options);
  if (options.task == Task::as_course) throw UsageError("-as " + options.subject + " must come before all else");
  CheckCommand(options);
  ShareNames(options, words);
  CheckTogether(options);
  Derive(options);
  return options;
}

void CompleteForScene(Options& options) {
  if (options.render.denoise) options.render.denoiser = Resolved(options.render.denoiser);
  CheckEffects(options.render.camera);
  CheckSubsampling(options.render);
  CheckDenoise(options);
  CheckGrid(options.render);
  CheckNeighbors(options.render);
  CheckSize(options.render);
  CheckCrop(options.render);
  CheckPixelIsInPicture(options);
  Derive(options);
}

void CheckMachine(const RenderSettings& render, const AcceleratorSettings& accelerator) {
  CheckDenoiser(render);
  const std::string& name = accelerator.instruction_set;
  const std::vector<std::string> present = InstructionSets();
  if (name == "best" || std::find(present.begin(), present.end(), name) != present.end()) return;
  std::string list = "best";
  for (const std::string& one : present) list += ", " + one;
  throw UsageError("-simd " + name + ": this machine has " + list);
}

}  // namespace ray
