#include "source/app/options/OptionTable.h"

#include <algorithm>
#include <limits>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/app/files/LayerPictures.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/Listing.h"
#include "source/app/options/Manual.h"
#include "source/app/options/Preset.h"
#include "source/text/EnumNames.h"

namespace ray {
namespace {

constexpr int most_pixels_a_side = 1 << 30;
constexpr int most_threads = 4096;
constexpr int deepest_include = 1'000'000;

std::vector<std::string> AcceleratorNames() {
  std::vector<std::string> names;
  for (const AcceleratorKind* kind : AcceleratorKinds()) names.emplace_back(kind->name);
  return names;
}

std::vector<std::string> InstructionSetNames() {
  std::vector<std::string> names{"best"};
  names.insert(names.end(), instruction_set_names.begin(), instruction_set_names.end());
  return names;
}

std::vector<std::string> ContextNames() { return {context_names.begin(), context_names.end()}; }

/// A word of a closed set, kept as the enumerator it names.
template <class Enum, class Lambda>
OneNameOf OneOfEnum(Lambda, bool by_number = false) {
  return {[] { return std::vector<std::string>(NamesOf(Enum{}).begin(), NamesOf(Enum{}).end()); },
          [](const Options& options) { return std::string(NameOf(Lambda{}(options))); },
          [](Options& options, const std::string& name) { Lambda{}(options) = *Named<Enum>(name); }, by_number};
}

/// A word of an open set, kept as it is.
template <class Lambda>
OneNameOf OneOfNames(Lambda, std::vector<std::string> (*choices)()) {
  return {choices, [](const Options& options) { return Lambda{}(options); },
          [](Options& options, const std::string& name) { Lambda{}(options) = name; }};
}

std::vector<std::string> Shells() { return {"bash", "zsh", "fish"}; }

template <Program program>
std::vector<std::string> HelpSubjects() {
  std::vector<std::string> subjects = OptionTopics(program);
  subjects.emplace_back("markdown");
  return subjects;
}

template <Program program>
std::vector<std::string> SubjectsOfList() {
  return ListSubjects(program);
}

template <class T>
constexpr T highest = std::numeric_limits<T>::max();

// One entry stays one thought.
// clang-format off
// One lambda that reads a const Options and writes another.
#define AT(member) [](auto& o) -> auto& { return o.member; }

/// The one table. What is `raypro`'s alone makes no sense beside a picture that changes while it is looked at.
template <Program program>
std::vector<OptionKind> MakeTable() {
  using Whole = Number<int>;
  using enum KnownTo;
  return {
      {"width", raypro, {}, {"n"}, Whole{AT(render.width), 1, most_pixels_a_side}, "pixels", "picture",
       "width of the whole picture"},
      {"height", raypro, {}, {"n"}, Whole{AT(render.height), 1, most_pixels_a_side}, "pixels", "picture",
       "height of the whole picture"},
      {"width", rayview, {}, {"n"}, Whole{AT(render.width), 1, most_pixels_a_side}, "pixels", "picture",
       "width of the window at first, and so of what is traced"},
      {"height", rayview, {}, {"n"}, Whole{AT(render.height), 1, most_pixels_a_side}, "pixels", "picture",
       "height of the window at first, and so of what is traced"},
      {"samples", both, {}, {"n"}, Whole{AT(render.samples), 1, highest<int>}, "camera rays a pixel", "picture",
       "more samples, smoother edges and shadows"},
      {"crop", raypro, {}, {"x0", "y0", "x1", "y1"}, Rectangle{AT(render.crop)}, "pixels", "picture",
       "only columns x0..x1-1 from the left, rows y0..y1-1 from the bottom (as the image is stored)"},
      {"filter", both, {}, {"name"}, OneOfEnum<FilterKind>(AT(render.filter), true), "", "picture",
       "what samples count for a pixel: up to .5, 2, 2 and 3 pixels away"},
      {"sampler", both, {}, {"name"}, OneOfEnum<SamplerKind>(AT(render.trace.sampler)), "", "picture",
       "how the samples of a pixel are spread over all they choose"},
      {"seed", both, {}, {"n"}, Number<std::uint64_t>{AT(render.seed), 0, highest<std::uint64_t>}, "", "picture",
       "which random numbers; the same seed gives the same picture"},
      {"motion", both, {}, {"dx", "dy", "dz"}, Triple{AT(render.camera.motion)}, "", "picture",
       "how far the camera moves while the shutter is open"},
      {"aperture", both, {}, {"r"}, Number<double>{AT(render.camera.aperture), 0, highest<double>}, "", "picture",
       "radius of the lens; 0 is a pinhole"},
      {"focus", both, {}, {"d"}, Number<double>{AT(render.camera.focus), 0, highest<double>}, "", "picture",
       "distance of what a lens sees sharply, along the view"},
      {"srgb", both, {}, {}, Flag{AT(encoding.srgb)}, "", "picture",
       "light is linear: decode 8-bit textures from sRGB, encode the picture to it"},
      {"layers", raypro, {}, {"list"},
       Word<std::vector<Layer>>{AT(layers), ReadLayerList, ShowLayerList,
        "some of depth, normal, uv, albedo and id, with commas between"}, "", "picture",
       "what else to keep: channels of an EXR, or pictures beside, out.depth.png"},
      {"bits", both, {}, {"n"}, OneNumberOf{AT(encoding.bits), {8, 16}}, "bits a channel", "picture", "depth of a PNG"},
      {"jpeg_quality", both, {}, {"n"}, Whole{AT(encoding.jpeg_quality), 1, 100}, "", "picture", "quality of a JPEG"},

      {"image", rayview, {}, {"file"}, FileName{AT(picture)}, "", "viewer",
       "what key S writes; image1.jpg, image2.jpg... unless given, whichever is not there yet"},
      {"output_image", rayview, {}, {"file"}, FileName{AT(view.output_image)}, "", "viewer",
       "save what the window shows when the program ends"},
      {"exit_immediately", rayview, {}, {}, Flag{AT(view.exit_immediately)}, "", "viewer", "draw once, save, end"},
      {"headless", rayview, {}, {}, Flag{AT(view.headless)}, "", "viewer",
       "draw without a window: what -events says, or once"},
      {"context", rayview, {}, {"name"}, OneOfNames(AT(view.context), ContextNames), "", "viewer",
       "what -headless draws with (auto: the first that works)"},
      {"events", rayview, {}, {"file"}, FileName{AT(view.events)}, "", "viewer",
       "do what a script says, then end; - reads standard input"},
      {"screenshot", rayview, {}, {"file"}, FileName{AT(view.screenshot)}, "", "viewer",
       "save the drawing after the last event"},
      {"record", rayview, {}, {"file"}, FileName{AT(view.record)}, "", "viewer",
       "write what happens as a script for -events"},
      {"reference", rayview, {}, {"file"}, FileName{AT(view.reference)}, "", "viewer",
       "a picture of the same scene to compare with"},

      {"mode", both, {}, {"name"}, OneOfEnum<RenderMode>(AT(render.mode)), "", "light",
       "whitted, path: light; heat, rays: costs a pixel, black 1 to white 10000; or a layer seen first"},
      {"env", both, {}, {"file"}, FileName{AT(parse.environment)}, "", "light",
       "light from all around: a latitude-longitude picture, an angular probe or a cross of six faces"},
      {"max_depth", both, {"maxreflections", "max_reflections"}, {"n"},
       Number<std::int64_t>{AT(render.trace.max_depth), 0, highest<std::int64_t>}, "bounces", "light",
       "how many reflections and transmissions may follow one another"},
      {"min_luminance", both, {"minluminance"}, {"x"},
       Number<double>{AT(render.trace.min_luminance), 0, highest<double>}, "", "light",
       "follow a ray only while its weight in the picture is at least this"},
      {"shadow_samples", both, {}, {"n"}, Whole{AT(render.trace.shadow_samples), 1, highest<int>},
       "shadow rays a light", "light", "rays to each light that has an area"},
      {"lights", both, {}, {"all|one|n"}, Word<int>{AT(render.trace.lights), ReadLightCount, ShowLightCount,
        "all, one, auto or a whole number above 0"}, "", "light",
       "lights chosen at each point, by importance (auto: whitted all, path one)"},
      {"glossy", both, {}, {}, Flag{AT(render.trace.glossy)}, "", "light",
       "reflections are spread over the Phong lobe"},
      {"fresnel", both, {}, {}, Flag{AT(render.trace.fresnel)}, "", "light",
       "what is clear and bends light reflects it as well, by Fresnel's equations"},
      {"roulette", both, {}, {"name"}, OneOfEnum<Roulette>(AT(render.trace.roulette)), "", "light",
       "follow faint rays by chance, without bias (auto: path on; whitted off, cut at -min_luminance)"},
      {"strategy", both, {}, {"name"}, OneOfEnum<LightStrategy>(AT(render.trace.strategy)), "", "light",
       "path: mis, light sampling, BSDF sampling, or uniform for comparison"},
      {"shadows", both, {}, {"on|off"}, OnOff{AT(render.trace.shadows)}, "", "light", "whether things cast shadows"},

      {"quality", raypro, {}, {"name"}, OneOfNames(AT(quality), PresetNames), "", "trade",
       "a row of the table of presets; every option given besides overrides its part"},
      {"time", raypro, {}, {"t"},
       Word<double>{AT(render.budget.seconds), ReadDuration, ShowDuration, "a time such as 30s, 5m or 1h"},
       "", "trade", "stop so that the picture is written this long after the start"},
      {"error", raypro, {}, {"e"},
       Word<std::optional<ErrorTarget>>{AT(render.budget.error), ReadErrorTarget, ShowErrorTarget,
        "an error above 0: 2 (255ths of what is shown), 3% (of the mean), 40dB or 0.01lin"},
       "", "trade", "stop when the picture's own estimate of its error is surely below"},
      {"confidence", raypro, {}, {"c"}, Number<double>{AT(render.budget.confidence), 0.5, 0.9999}, "", "trade",
       "how sure the interval around an estimated error is to hold the truth"},
      {"adaptive", raypro, {}, {"name"}, OneOfEnum<Adaptive>(AT(render.budget.adaptive)), "", "trade",
       "tile: with -error, only blocks still above it go on (auto: tile with -error)"},
      {"reference", raypro, {}, {"file[,file2]"}, FileList{AT(reference)}, "", "trade",
       "tell the true error beside a picture, or two independent ones, of the same scene"},
      {"replay", raypro, {}, {"file.json"}, FileName{AT(replay)}, "", "trade",
       "share samples out as the render did that wrote this report: the same bits"},

      {"checkpoint", raypro, {}, {"t"},
       Word<double>{AT(checkpoint), ReadDuration, ShowDuration, "a time such as 30s, 5m or 1h"},
       "", "trade", "keep what is done this often, beside the picture; a signal always keeps it"},
      {"resume", raypro, {}, {}, Flag{AT(resume)}, "", "trade",
       "go on from what was kept, to the same picture bit for bit"},

      {"accel", both, {}, {"name"}, OneOfNames(AT(accelerator.name), AcceleratorNames), "", "speed",
       "how rays find what they hit; never changes the picture"},
      {"accel_res", both, {"accelres"}, {"x"}, Number<double>{AT(accelerator.resolution), 0, 1e6}, "", "speed",
       "grid: cells a primitive; octree, bvh: primitives a leaf (bvh up to 8); 0: the usual"},
      {"accel_depth", both, {}, {"n"}, Whole{AT(accelerator.depth), 0, most_octree_levels}, "levels", "speed",
       "octree: most levels; 0 for the usual"},
      {"accel_quality", both, {}, {"name"}, OneOfEnum<BvhQuality>(AT(accelerator.quality)), "", "speed",
       "bvh: high cuts large slanted triangles first; builds longer"},
      {"simd", both, {}, {"name"}, OneOfNames(AT(accelerator.instruction_set), InstructionSetNames), "", "speed",
       "the instruction set to use, if this machine has it; never changes the picture"},
      {"node_boxes", both, {}, {"on|off"}, OnOff{AT(accelerator.node_boxes)}, "", "speed",
       "graph: skip nodes whose box the ray misses"},
      {"front_to_back", both, {}, {"on|off"}, OnOff{AT(accelerator.front_to_back)}, "", "speed",
       "graph: visit nearer nodes first"},
      {"last_hit", both, {}, {"on|off"}, OnOff{AT(accelerator.last_hit)}, "", "speed",
       "graph: ask first what the last ray hit"},
      {"threads", both, {}, {"n"}, Whole{AT(render.threads), 0, most_threads}, "threads", "speed",
       "how many work at once, 0 for as many as the machine has; never changes the picture"},
      {"tile_size", raypro, {}, {"n"}, Whole{AT(render.tile_size), 0, most_pixels_a_side}, "pixels", "speed",
       "side of the squares that threads take, 0 for the whole picture"},

      {"include_depth", both, {}, {"n"}, Whole{AT(parse.include_depth), 1, deepest_include}, "files", "scene",
       "how deep scene files may include one another"},
      {"allow_path", both, {}, {"folder"}, FolderList{AT(parse.allowed_folders)}, "", "scene",
       "let the scene also read files below this folder; may be repeated"},
      {"check", raypro, {"dry-run"}, {}, Request{Task::check}, "", "scene",
       "read the scene, describe it and point out likely mistakes; render nothing"},

      {"quiet", both, {}, {}, Flag{AT(quiet)}, "", "messages", "print errors and warnings only"},
      {"verbose", both, {"v"}, {}, Flag{AT(verbose)}, "", "messages", "tell each step and how long it took"},
      {"explain", raypro, {}, {}, Flag{AT(explain)}, "", "messages",
       "say which accelerator is used, why, and what was built"},
      {"stats", raypro, {}, {}, Flag{AT(stats)}, "", "messages", "print what the picture cost"},
      {"debugpixel", raypro, {}, {"x", "y"}, PixelRequest{AT(pixel), Task::debug_pixel}, "", "messages",
       "print the tree of a pixel's rays (x from the left, y from the bottom); render nothing"},
      {"report", raypro, {}, {"file.json"}, FileName{AT(report)}, "", "messages",
       "write what the picture cost, for programs"},

      {"help", both, {"h"}, {"topic"}, Request{Task::help, Request::perhaps, HelpSubjects<program>}, "", "about",
       "print this, or one topic of it"},
      {"version", both, {}, {}, Request{Task::version}, "", "about", "print the version and what is built in"},
      {"list", both, {}, {"what"}, Request{Task::list, Request::perhaps, SubjectsOfList<program>}, "", "about",
       "list what this program knows"},
      {"info", raypro, {}, {"picture"}, Request{Task::info, Request::always}, "", "about",
       "print how a picture was made, from the picture itself"},
      {"complete", both, {}, {"shell"}, Request{Task::complete, Request::always, Shells}, "", "about",
       "print the completion script of a shell"},
      {"man", both, {}, {"page"}, Request{Task::manual, Request::perhaps, ManualPages}, "", "about",
       "print the manual page, or that of the scene language"},
  };
}

#undef AT
// clang-format on

template <Program program>
std::vector<OptionKind> OptionsOf() {
  std::vector<OptionKind> table = MakeTable<program>();
  const KnownTo other = program == Program::raypro ? KnownTo::rayview : KnownTo::raypro;
  std::erase_if(table, [&](const OptionKind& option) { return option.known_to == other; });
  return table;
}

}  // namespace

Options Defaults(Program program) {
  Options options;
  options.program = program;
  if (program == Program::raypro) return options;
  options.task = Task::view;
  options.render.width = options.render.height = 512;  // the course's window
  return options;
}

std::span<const OptionKind> OptionTable(Program program) {
  static const std::vector<OptionKind> of_raypro = OptionsOf<Program::raypro>();
  static const std::vector<OptionKind> of_rayview = OptionsOf<Program::rayview>();
  return program == Program::raypro ? of_raypro : of_rayview;
}

const OptionKind* FindOption(Program program, const std::string& name) {
  for (const OptionKind& option : OptionTable(program)) {
    const auto is_name = [&](const char* candidate) { return name == candidate; };
    if (is_name(option.name) || std::ranges::any_of(option.aliases, is_name)) return &option;
  }
  return nullptr;
}

std::vector<std::string> OptionTopics(Program program) {
  std::vector<std::string> topics;
  for (const OptionKind& option : OptionTable(program))
    if (topics.empty() || topics.back() != option.topic) topics.emplace_back(option.topic);
  return topics;
}

}  // namespace ray
