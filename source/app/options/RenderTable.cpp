// raypro and rayview, and their options.
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

#include "source/accelerate/Accelerator.h"
#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/app/Status.h"
#include "source/app/files/LayerImages.h"
#include "source/app/options/AboutOptions.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/OptionEntry.h"
#include "source/app/options/OptionNeeds.h"
#include "source/app/options/Preset.h"
#include "source/app/options/RenderChecks.h"
#include "source/app/options/ViewerOptions.h"
#include "source/parse/Coordinate.h"
#include "source/parse/Format.h"
#include "source/parse/Variables.h"

namespace ray {
namespace {

constexpr int most_pixels_a_side = 1 << 30;
constexpr int most_bands = 255;  // one tone per level of a byte
constexpr int most_threads = 4096;
constexpr double most_memory = 1 << 20;
constexpr int deepest_include = 1'000'000;
constexpr const char* duration_range = "a duration such as 30s, 5m or 1h";

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

bool IsSomething(const std::string& word) { return !word.empty(); }

std::vector<std::string> SceneFormatNames() {
  std::vector<std::string> names;
  for (const SceneFormat* format : SceneFormats()) names.emplace_back(format->name);
  return names;
}

std::vector<std::string> ImageExtensionNames() {
  std::vector<std::string> names;
  for (const R2::ImageFormat& format : R2::ImageFormats())
    names.insert(names.end(), format.extensions.begin(), format.extensions.end());
  return names;
}

std::vector<std::string> PanelThemes() { return {panel_themes.begin(), panel_themes.end()}; }
std::vector<std::string> PreviewNames() { return {preview_names.begin(), preview_names.end()}; }

std::vector<std::string> ContextNames() { return {context_names.begin(), context_names.end()}; }

std::vector<std::string> LayerNames() { return {layer_names.begin(), layer_names.end()}; }

std::vector<std::string> LightCountNames() { return {"all", "one", "auto"}; }

std::vector<std::string> ProjectionNames() {
  const auto names = CameraKindNames();
  return {names.begin(), names.end()};
}

template <class T>
constexpr T highest = std::numeric_limits<T>::max();

using Numbers = std::span<const double>;

bool IsPlace(const R3::Vector& v) { return IsCoordinate(v.x) && IsCoordinate(v.y) && IsCoordinate(v.z); }

std::optional<R3::Vector> VectorOf(Numbers n) { return R3::Vector{n[0], n[1], n[2]}; }
std::vector<double> ShowVector(const R3::Vector& v) { return {v.x, v.y, v.z}; }

/// Makes an argument for a point or direction that replaces the scene's, if given.
template <class Triple>
std::optional<std::optional<Triple>> PlaceOf(Numbers n) {
  const R3::Vector v{n[0], n[1], n[2]};
  if (!IsPlace(v) || (std::is_same_v<Triple, R3::Vector> && v == R3::Vector{})) return {};
  return Triple{v.x, v.y, v.z};
}
template <class Triple>
std::vector<double> ShowPlace(const std::optional<Triple>& place) {
  return place ? std::vector{place->x, place->y, place->z} : std::vector<double>{};
}

std::optional<std::optional<double>> FieldOfViewOf(Numbers n) {
  if (!(n[0] > 0 && n[0] <= 360)) return {};
  return n[0];
}
std::vector<double> ShowFieldOfView(const std::optional<double>& fov) {
  return fov ? std::vector{*fov} : std::vector<double>{};
}

std::optional<ZBufferRange> ZBufferRangeOf(Numbers n) {
  if (!(n[0] >= 0 && (n[0] < n[1] || n[1] == 0))) return {};
  return ZBufferRange{n[0], n[1]};
}
std::vector<double> ShowZBufferRange(const ZBufferRange& range) { return {range.near, range.far}; }

std::optional<GoochTones> GoochTonesOf(Numbers n) { return GoochTones{n[0], n[1], n[2], n[3]}; }
std::vector<double> ShowGoochTones(const GoochTones& t) { return {t.blue, t.yellow, t.alpha, t.beta}; }

const Word samples_per_pixel{
    [](Options& options, const std::string& word) { return ReadSamples(word, As<RenderOptions>(options).render); },
    [](const Options& options) { return ShowSamples(As<RenderOptions>(options).render); },
    "a whole number, 1 to 2147483647, or 1/2, 1/4, 1/8 or 1/16",
    nullptr,
    false,
    true};

#define AT(member) AT_OF(RenderOptions, member)
#define AT_VIEW(member) AT_OF(ViewerOptions, member)

// clang-format would split entries over many lines.
// clang-format off
// One or two functions per topic. Options that are meaningless for an image that changes while it is viewed are
// `raypro`'s alone.
std::vector<OptionKind> CameraAndImageOptions() {
  using Whole = Number<int>;
  using enum Fact;
  using enum KnownTo;
  return {
      {"width", raypro, image | in_scenes | ElsewhereCalled{"w", "W", "x", "xres"},
       {}, {"n"}, Whole{AT(render.width), 1, most_pixels_a_side}, "pixels", "image",
       "width of the whole image; 1024 if neither it nor -height is given"},
      {"height", raypro, image | in_scenes | ElsewhereCalled{"H", "y", "yres"},
       {}, {"n"}, Whole{AT(render.height), 1, most_pixels_a_side}, "pixels", "image",
       "height of the whole image; 1024 if neither it nor -width is given"},
      {"width", rayview, window | in_scenes | ElsewhereCalled{"w", "W", "x", "xres"},
       {}, {"n"}, Whole{AT(render.width), 1, most_pixels_a_side}, "pixels", "image",
       "initial width of the window, and so of the traced image"},
      {"height", rayview, window | in_scenes | ElsewhereCalled{"H", "y", "yres"},
       {}, {"n"}, Whole{AT(render.height), 1, most_pixels_a_side}, "pixels", "image",
       "initial height of the window, and so of the traced image"},
      {"samples", both, samples | in_scenes | before_budgets | changes_on_resume | Needs{needs::samples_to_limit} |
       ElsewhereCalled{"spp", "s", "n", "aa", "antialias"},
       {}, {"n"}, samples_per_pixel, "camera rays per pixel", "image",
       "more make edges smoother; 16 if no size is given; 1/4: trace a fourth of the pixels"},
      {"denoise", both, image | ElsewhereCalled{"oidn"}, {}, {}, Flag{AT(render.denoise)}, "", "image",
       "filter out noise where that lowers the error, guided by surfaces; report the error left"},
      {"denoiser", both, image | Needs{needs::denoise},
       {}, {"name"}, OneOfEnum<Denoiser>(AT(render.denoiser)), "", "image",
       "filter for -denoise: regression, Intel's library, or the better of both (auto: if installed)"},
      {"crop", raypro, image | ElsewhereCalled{"cropwindow", "region"},
       {}, {"x0", "y0", "x1", "y1"}, Rectangle{AT(render.crop)}, "pixels", "image",
       "only columns x0..x1-1 from the left, rows y0..y1-1 from the bottom (as the image is stored)"},
      {"filter", both, image | in_scenes | Needs{needs::whole_samples},
       {}, {"name"}, OneOfEnum<FilterKind>(AT(render.filter), true), "", "image",
       "reconstruction filter (radius 0.5, 2, 2, 3 pixels)"},
      {"sampler", both, image | in_scenes | before_budgets,
       {}, {"name"}, OneOfEnum<SamplerKind>(AT(render.trace.sampler)), "", "image",
       "sample sequence (stratified: jittered)"},
      {"seed", both, image, {}, {"n"}, Number<std::uint64_t>{AT(render.seed), 0, highest<std::uint64_t>}, "", "image",
       "random seed; the same seed gives a bit-identical image"},
      {"eye", both, image | ElsewhereCalled{"lookat"}, {}, {"x", "y", "z"}, NumbersOf<PlaceOf<R3::Point>, ShowPlace<R3::Point>>(AT(parse.camera.eye), "three numbers"), "",
       "image", "camera position; overrides the scene's"},
      {"target", both, image, {}, {"x", "y", "z"}, NumbersOf<PlaceOf<R3::Point>, ShowPlace<R3::Point>>(AT(parse.camera.target), "three numbers"), "",
       "image", "point the camera looks at; by default the scene's viewing direction is kept"},
      {"up", both, image, {}, {"x", "y", "z"}, NumbersOf<PlaceOf<R3::Vector>, ShowPlace<R3::Vector>>(AT(parse.camera.up), "three numbers, not 0 0 0"), "", "image",
       "direction that points up in the image"},
      {"fov", both, image, {}, {"degrees"}, NumbersOf<FieldOfViewOf, ShowFieldOfView>(AT(parse.camera.fov), "degrees, above 0 and up to 360"), "", "image", "whole horizontal field of view"},
      {"projection", both, image, {}, {"name"}, OneOfNames(AT(parse.camera.projection), ProjectionNames), "", "image",
       "camera projection (raypro -list projections); overrides the scene's"},
      {"motion", both, image | in_scenes, {}, {"dx", "dy", "dz"}, NumbersOf<VectorOf, ShowVector>(AT(render.camera.motion), "three numbers"), "", "image",
       "camera movement while the shutter is open"},
      {"aperture", both, image | in_scenes | ElsewhereCalled{"dof", "fstop"},
       {}, {"r"}, Number<double>{AT(render.camera.aperture), 0, highest<double>}, "", "image",
       "lens radius; 0 is a pinhole"},
      {"focus", both, image | in_scenes | Needs{needs::lens} | ElsewhereCalled{"focal_length", "focal_distance"},
       {}, {"d"}, Number<double>{AT(render.camera.focus), 0, highest<double>}, "", "image",
       "focus distance, along the viewing direction"},
      {"lens", both, image | in_scenes | Needs{needs::lens, needs::grid},
       {}, {"name"}, OneOfEnum<LensPattern>(AT(render.camera.lens)), "", "image",
       "where on the lens rays start; spiral: at -lens_samples places for each of -sampler grid"},
      {"lens_samples", both, image | in_scenes | Needs{needs::lens, needs::grid, needs::spiral},
       {}, {"n"}, Whole{AT(render.camera.lens_samples), 1, highest<int>}, "places", "image",
       "lens samples for each sample position in the pixel (-lens spiral)"},
      {"shutter_samples", both, image | in_scenes | Needs{needs::grid},
       {}, {"n"}, Whole{AT(render.camera.shutter_samples), 1, highest<int>}, "moments",
       "image", "evenly spaced times for each position of -sampler grid; 1: random times"},
      {"clamp", both, image | in_scenes, {}, {"name"}, OneOfEnum<Clamp>(AT(render.clamp)), "", "image",
       "clamp to 0..1: the image when it is written, or each sample before it is added"},
      {"bytes", both, image | in_scenes | Needs{needs::format_of_bytes},
       {}, {"name"}, OneOfEnum<R2::Quantization>(AT(encoding.quantization)), "", "image",
       "conversion of a value v to a byte: 255 v rounded to the nearest integer, or truncated"},
      {"srgb", both, image | in_scenes, {}, {}, Flag{AT(encoding.srgb)}, "", "image",
       "linear workflow: decode 8-bit textures from sRGB, encode the image in sRGB"},
      {"layers", raypro, image | named_image, {}, {"list"}, WordOf<ReadLayerList, ShowLayerList>(AT(files.layers),
        "some of depth, normal, uv, albedo, id and flare, separated by commas", LayerNames, true), "", "image",
       "extra output layers (AOVs): channels of an EXR, or files next to the image, out.depth.png"},
      {"bits", both, image | Needs{needs::png},
       {}, {"n"}, OneNumberOf{AT(encoding.bits), {8, 16}}, "bits per channel", "image",
       "bit depth of a PNG"},
      {"jpeg_quality", both, image | Needs{needs::jpeg},
       {}, {"n"}, Whole{AT(encoding.jpeg_quality), 1, 100}, "", "image", "JPEG quality"},
  };
}

std::vector<OptionKind> ViewingOptions() {
  using enum Fact;
  using enum KnownTo;
  return {
      {"image", rayview, run | ElsewhereCalled{"o", "out", "output"},
       {}, {"file"}, FileName{AT(files.image), FileKind::image}, "", "viewer",
       "file that key S writes; by default the first of image1.jpg, image2.jpg... that does not exist"},
      {"output_image", rayview, run, {}, {"file"}, FileName{AT_VIEW(view.output_image), FileKind::image}, "", "viewer",
       "save the window's content when the program exits"},
      {"exit_immediately", rayview, run | Excludes{"events"},
       {}, {}, Flag{AT_VIEW(view.exit_immediately)}, "", "viewer", "draw once, save, exit"},
      {"headless", rayview, run | ElsewhereCalled{"b", "background"}, {}, {}, Flag{AT_VIEW(view.headless)}, "", "viewer",
       "draw without a window: run the script of -events, or draw once"},
      {"context", rayview, run, {}, {"name"}, OneOfNames(AT_VIEW(view.context), ContextNames), "", "viewer",
       "OpenGL context of -headless (auto: the first that works)"},
      {"events", rayview, run, {}, {"file"}, FileName{AT_VIEW(view.events)}, "", "viewer",
       "run a script of events, then exit; - reads standard input"},
      {"screenshot", rayview, run, {}, {"file"}, FileName{AT_VIEW(view.screenshot), FileKind::image}, "", "viewer",
       "save the drawing after the last event"},
      {"record", rayview, run, {}, {"file"}, FileName{AT_VIEW(view.record)}, "", "viewer",
       "record events as a script for -events"},
      {"reference", rayview, run, {}, {"file"}, FileName{AT_VIEW(view.reference), FileKind::image}, "", "viewer",
       "an image of the same scene to compare with"},
      {"rays", rayview, run, {}, {"file"}, FileName{AT_VIEW(view.rays)}, "", "viewer",
       "rays of another tracer, one per line: kind x y z x y z; the first that differs is named"},
      {"panels", rayview, run, {}, {"theme"}, OneOfNames(AT_VIEW(view.panels), PanelThemes), "", "viewer",
       "show panels from the start; key Tab toggles them"},
      {"preview", rayview, run, {}, {"name"}, OneOfNames(AT_VIEW(view.preview), PreviewNames), "", "viewer",
       "what a view at rest shows: the traced image, or OpenGL alone (auto: traced, but gl in scripts)"},
  };
}

std::vector<OptionKind> LightOptions() {
  using Whole = Number<int>;
  using enum Fact;
  using enum KnownTo;
  return {
      {"mode", both, image | in_scenes | ElsewhereCalled{"integrator", "m", "method", "renderer"},
       {}, {"name"}, OneOfEnum<RenderMode>(AT(render.mode)), "", "light",
       "whitted, path: light; heat, rays: cost per pixel, black = 1, white = 10,000; or a layer"},
      {"env", both, image | with_convert | ElsewhereCalled{"envmap", "environment", "hdri"},
       {}, {"file"}, FileName{AT(parse.environment), FileKind::image}, "", "light",
       "environment light: a latitude-longitude image, an angular probe or a cross of six faces"},
      {"one_sided", both, image, {}, {}, Flag{AT(parse.one_sided)}, "", "light",
       "rays hit surfaces from their front only, except glass"},
      {"max_depth", both, image | in_scenes | ElsewhereCalled{"bounces", "depth", "d", "max_bounces", "max-bounces"},
       {"maxreflections", "max_reflections"}, {"n"},
       Number<std::int64_t>{AT(render.trace.max_depth), 0, highest<std::int64_t>}, "bounces", "light",
       "maximum number of successive reflections and transmissions"},
      {"min_luminance", both, image | in_scenes, {"minluminance"}, {"x"},
       Number<double>{AT(render.trace.min_luminance), 0, highest<double>}, "", "light",
       "trace a secondary ray only if the luminance of its throughput is at least this"},
      {"shadow_samples", both, image | in_scenes, {}, {"n"}, Whole{AT(render.trace.shadow_samples), 1, highest<int>},
       "shadow rays per light", "light", "shadow rays to each light that has an area"},
      {"lights", both, image | in_scenes,
       {}, {"all|one|n"}, WordOf<ReadLightCount, ShowLightCount>(AT(render.trace.lights),
        "all, one, auto or a whole number above 0", LightCountNames), "", "light",
       "lights sampled at each point, by importance (auto: all; path, of more than 4, one)"},
      {"glossy", both, image | in_scenes, {}, {}, Flag{AT(render.trace.glossy)}, "", "light",
       "sample glossy reflections from the Phong lobe"},
      {"fresnel", both, image | in_scenes, {}, {}, Flag{AT(render.trace.fresnel)}, "", "light",
       "Fresnel reflection on refractive surfaces"},
      {"internal_reflection", both, image | in_scenes,
       {}, {"on|off"}, OnOff{AT(render.trace.internal_reflection)}, "", "light",
       "without -fresnel: whether total internal reflection reflects light (off: it is lost)"},
      {"roulette", both, image, {}, {"name"}, OneOfEnum<Roulette>(AT(render.trace.roulette)), "", "light",
       "Russian roulette, unbiased (auto: path on; whitted off, cut at -min_luminance)"},
      {"share", both, image | Needs{needs::mode_path, needs::shared_light},
       {}, {"name"}, OneOfEnum<Sharing>(AT(render.share)), "", "light",
       "path: whether pixels share light from two bounces on (auto: if it pays, as in rooms)"},
      {"strategy", both, image | Needs{needs::mode_path},
       {}, {"name"}, OneOfEnum<LightStrategy>(AT(render.trace.strategy)), "", "light",
       "path: mis, light sampling, BSDF sampling, or uniform for comparison"},
      {"emission", both, image | in_scenes | Needs{needs::mode_path},
       {}, {"radiance|color"}, OneOfEnum<Emission>(AT(render.trace.emission)), "", "light",
       "path: emission is a radiance, or as in mode whitted a lamp's full color, whatever its size"},
      {"emissive_solids", both, image | in_scenes | Needs{needs::colored_lamps},
       {}, {"on|off"}, OnOff{AT(render.trace.emissive_solids_light)}, "", "light",
       "whether emissive solids light the scene in mode whitted, as triangles do (mode path: always)"},
      {"emissive_meshes", both, image | in_scenes | Needs{needs::colored_lamps},
       {}, {"faces|whole"}, OneOfEnum<EmissiveMeshes>(AT(render.trace.emissive_meshes)), "",
       "light", "whether each triangle of an emissive mesh is a lamp in mode whitted, or the whole mesh is one"},
      {"shadows", both, image | in_scenes,
       {}, {"on|off"}, OnOff{AT(render.trace.shadows)}, "", "light", "whether objects cast shadows"},
  };
}

std::vector<OptionKind> DrawnModeOptions() {
  using Whole = Number<int>;
  using enum Fact;
  using enum KnownTo;
  return {
      {"zbuffer_range", both, image | in_scenes | Needs{needs::mode_zbuffer},
       {}, {"near", "far"}, NumbersOf<ZBufferRangeOf, ShowZBufferRange>(AT(render.trace.zbuffer),
        "two distances, near below far, or 0 0"), "", "light",
       "distances that -mode zbuffer shows white and black (0 0: nearest and farthest in the image)"},
      {"gooch", both, image | in_scenes | Needs{needs::mode_gooch},
       {}, {"b", "y", "alpha", "beta"}, NumbersOf<GoochTonesOf, ShowGoochTones>(AT(render.trace.gooch), "four numbers"), "", "light",
       "-mode gooch: blue and yellow of the tones, and the amount of surface color in each"},
      {"toon_bands", both, image | in_scenes | Needs{needs::mode_toon},
       {}, {"n"}, Whole{AT(render.trace.toon_bands), 1, most_bands}, "tones", "light",
       "-mode toon: number of tones besides black"},
      {"hatch_spacing", both, image | in_scenes | Needs{needs::mode_hatching},
       {}, {"w"}, Number<double>{AT(render.trace.hatch_spacing), 1, highest<double>}, "pixels", "light",
       "-mode hatching: distance between strokes"},
      {"outline", both, image | in_scenes,
       {}, {"w"}, Number<double>{AT(render.trace.outline.width), 0, highest<double>}, "pixels", "light",
       "draw black lines of this width along silhouettes and creases; 0: none"},
      {"flare", raypro, image | in_scenes | Needs{needs::mode_of_light},
       {}, {"s"}, Number<double>{AT(render.flare), 0, highest<double>}, "", "light",
       "brightness factor of lens flares around lamps in view; 0: none"},
  };
}

std::vector<OptionKind> QualityOptions() {
  using enum Fact;
  using enum KnownTo;
  return {
      {"quality", raypro, samples | ElsewhereCalled{"preset"},
       {}, {"name"}, OneOfNames(AT(quality), PresetNames), "", "quality",
       "a preset (raypro -list presets); other options override its settings"},
      {"time", raypro, budget | changes_on_resume | ElsewhereCalled{"T", "timeout"},
       {}, {"t"}, WordOf<ReadDuration, ShowDuration>(AT(render.budget.seconds), duration_range),
       "", "quality", "time limit, from the start of the program to the image written"},
      {"error", raypro, budget | ElsewhereCalled{"noise", "threshold"},
       {}, {"e"}, WordOf<ReadErrorTarget, ShowErrorTarget>(AT(render.budget.error),
        "an error above 0: 2 (255ths as displayed), 3% of the mean, 40dB or 0.01lin"), "", "quality",
       "stop when the upper bound of the estimated error is below this"},
      {"time", rayview, budget | changes_on_resume | ElsewhereCalled{"T", "timeout"},
       {}, {"t"}, WordOf<ReadDuration, ShowDuration>(AT(render.budget.seconds), duration_range),
       "", "quality", "time limit of the image that a view at rest shows, from each start"},
      {"error", rayview, budget | ElsewhereCalled{"noise", "threshold"},
       {}, {"e"}, WordOf<ReadErrorTarget, ShowErrorTarget>(AT(render.budget.error),
        "an error above 0: 2 (255ths as displayed), 3% of the mean, 40dB or 0.01lin"), "", "quality",
       "the image of a view at rest stops when the upper bound of its estimated error is below this"},
      {"confidence", both, budget | Needs{needs::reported_error},
       {}, {"c"}, Number<double>{AT(render.budget.confidence), 0.5, 0.9999}, "", "quality",
       "confidence level of the interval around an estimated error"},
      {"adaptive", both, budget | in_scenes | before_budgets |
       Needs{needs::error_of_tiles, needs::samples_of_neighbors},
       {}, {"name"}, OneOfEnum<Adaptive>(AT(render.budget.adaptive)), "", "quality",
       "auto, tile: with -error, more samples for noisy blocks; neighbors: only uneven blocks"},
      {"reference", raypro, run | one_image | whole_image,
       {}, {"file[,file2]"}, FileList{AT(files.reference), FileKind::image}, "", "quality",
       "print the true error against an image, or two independent ones, of the same scene"},
      {"replay", raypro, samples | one_image | Excludes{"time", "error"},
       {}, {"file.json"}, FileName{AT(files.replay), FileKind::json}, "", "quality",
       "reuse the sample allocation of that report: a bit-identical image"},
      {"advise", raypro, {}, {}, {}, Request{answer::Advise, true}, "", "quality",
       "probe the scene for a few seconds and report time, error and which settings help; no rendering"},
      {"checkpoint", raypro, run | named_image,
       {}, {"t"}, WordOf<ReadDuration, ShowDuration>(AT(checkpoint.seconds), duration_range),
       "", "quality", "write a checkpoint this often, next to the image; a signal always writes one"},
      {"resume", raypro, run | named_image | Excludes{"restart"} | ElsewhereCalled{"c", "continue"},
       {}, {}, Flag{AT(checkpoint.resume)}, "", "quality",
       "resume from the checkpoint, to a bit-identical image; with more -samples, add to them"},
      {"restart", raypro, run | named_image, {}, {}, Flag{AT(checkpoint.restart)}, "", "quality",
       "render from the start, and discard the checkpoint of an interrupted render"},
      {"keep_checkpoint", raypro, run | named_image | whole_image, {}, {}, Flag{AT(checkpoint.keep)}, "", "quality",
       "keep the checkpoint of a finished image, so that -resume can add samples"},
  };
}

std::vector<OptionKind> SpeedOptions() {
  using Whole = Number<int>;
  using enum Fact;
  using enum KnownTo;
  return {
      {"accel", both, speed | ElsewhereCalled{"accelerator"},
       {}, {"name"}, OneOfNames(AT(accelerator.name), AcceleratorNames), "", "speed",
       "acceleration structure; never changes the image"},
      {"accel_res", both, speed | Needs{needs::structure, needs::small_leaves},
       {"accelres"}, {"x"}, Number<double>{AT(accelerator.resolution), 0, 1e6}, "", "speed",
       "grid: cells per primitive; octree, bvh: primitives per leaf (bvh up to 8); 0: default"},
      {"accel_depth", both, speed | Needs{needs::octree},
       {}, {"n"}, Whole{AT(accelerator.depth), 0, most_octree_levels}, "levels", "speed",
       "octree: maximum depth; 0: default"},
      {"simd", both, speed, {}, {"name"}, OneOfNames(AT(accelerator.instruction_set), InstructionSetNames), "", "speed",
       "instruction set, if this machine has it; never changes the image"},
      {"node_boxes", both, speed | Needs{needs::graph}, {}, {"on|off"}, OnOff{AT(accelerator.node_boxes)}, "", "speed",
       "graph: skip nodes whose bounding box the ray misses"},
      {"front_to_back", both, speed | Needs{needs::graph},
       {}, {"on|off"}, OnOff{AT(accelerator.front_to_back)}, "", "speed",
       "graph: visit nearer nodes first"},
      {"last_hit", both, speed | Needs{needs::graph}, {}, {"on|off"}, OnOff{AT(accelerator.last_hit)}, "", "speed",
       "graph: test the primitive that the last ray hit first"},
      {"threads", both, speed | run | ElsewhereCalled{"j", "t", "p", "jobs", "cores", "nthreads"},
       {}, {"n"}, Whole{AT(render.threads), 0, most_threads}, "threads", "speed",
       "worker threads, 0 for as many as the machine has; never changes the image"},
      {"tile_size", raypro, speed, {}, {"n"}, Whole{AT(render.tile_size), 0, most_pixels_a_side}, "pixels", "speed",
       "tile size, 0 for the whole image"},
      {"memory", both, run, {}, {"x"}, Number<double>{AT(memory), 0, most_memory}, "GiB", "speed",
       "refuse to use more memory than this; 0: three quarters of this machine's"},
  };
}

std::vector<OptionKind> SceneOptions() {
  using Whole = Number<int>;
  using enum Fact;
  using enum KnownTo;
  return {
      {"format", both, reading | with_convert,
       {}, {"name"}, OneOfNames(AT(parse.format), SceneFormatNames), "", "scene",
       "scene format; by default chosen by the file's extension, for JSON by its keys"},
      {"include_depth", both, reading | with_convert,
       {}, {"n"}, Whole{AT(parse.include_depth), 1, deepest_include}, "files", "scene",
       "maximum nesting depth of included scene files"},
      {"allow_path", both, reading | with_convert | ElsewhereCalled{"L"},
       {}, {"folder"}, Repeated{AT(parse.allowed_folders), IsSomething, "a folder name", FileKind::folder}, "", "scene",
       "let the scene also read files below this folder; may be repeated"},
      {"define", both, image | reading | with_convert,
       {}, {"name=value"}, Repeated{AT(parse.definitions), IsDefinition, "such as t=0.5"}, "", "scene",
       "value of $name in a .scn scene; may be repeated"},
      {"files", raypro, {}, {}, {}, Request{answer::Files, true}, "", "scene",
       "print the files that the scene is read from, one per line, without rendering"},
      {"check", raypro, ElsewhereCalled{"validate", "verify", "lint"},
       {"dry-run"}, {}, Request{answer::Check, true}, "", "scene",
       "describe the scene and point out likely mistakes, without rendering"},
      {"convert", raypro, {},
       {}, {"out.scn"}, Request{answer::Convert, true, Request::always, nullptr, FileKind::scn}, "", "scene",
       "convert the scene from any format to a .scn that renders to the same image; no rendering"},
  };
}

std::vector<OptionKind> BatchOptions() {
  using enum Fact;
  using enum KnownTo;
  return {
      {"out_folder", raypro, run, {}, {"folder"}, FileName{AT(out_folder), FileKind::folder}, "", "batch",
       "render every scene named, each to an image of its name in this folder"},
      {"out_format", raypro, run | Needs{needs::out_folder},
       {}, {"extension"}, OneOfNames(AT(out_format), ImageExtensionNames), "", "batch",
       "format of the images in -out_folder"},
      {"part", raypro, run | one_image | named_image | Excludes{"missing", "parts"},
       {}, {"i/n"}, WordOf<ReadPart, ShowPart>(AT(render.part), "i/n with i from 1 to n, such as 3/8"),
       "", "batch", "render one of n parts, to out.png.part-i-of-n: on any machine, in any order"},
      {"missing", raypro, run | one_image | named_image,
       {}, {"n"}, Number<int>{AT(missing), 0, most_image_parts}, "parts", "batch",
       "print which of n parts are still to be rendered; with -error or -time, plan the next round"},
      {"parts", raypro, run | one_image | named_image, {}, {"pattern"}, FileName{AT(parts)}, "", "batch",
       "assemble the parts with matching names, and render the missing ones: a bit-identical image"},
  };
}

std::vector<OptionKind> MessageOptions() {
  using enum Fact;
  using enum KnownTo;
  return {
      {"quiet", both, messages | with_convert | Excludes{"verbose"} | ElsewhereCalled{"q", "silent"},
       {}, {}, Flag{AT(quiet)}, "", "messages", "print errors and warnings only"},
      {"verbose", both, messages,
       {"v"}, {}, Flag{AT(verbose)}, "", "messages", "report each step and how long it took"},
      {"explain", raypro, messages, {}, {}, Flag{AT(explain)}, "", "messages",
       "report the acceleration structure, why it was chosen, and its size"},
      {"stats", raypro, messages | whole_image,
       {}, {}, Flag{AT(stats)}, "", "messages", "print statistics of the render"},
      {"debugpixel", raypro, ElsewhereCalled{"debug", "pixel"},
       {}, {"x", "y"}, PixelRequest{AT(pixel), answer::RaysOfPixel}, "", "messages",
       "print the ray tree of a pixel (x from the left, y from the bottom); -verbose: all digits"},
      {"report", raypro, messages | one_image | whole_image | ElsewhereCalled{"json", "log"},
       {}, {"file.json"}, FileName{AT(files.report), FileKind::json}, "", "messages",
       "write settings and statistics as JSON"},
      {"keep_times", both, messages, {}, {}, Flag{AT(keep_times)}, "", "messages",
       "store seconds and threads in the image; without it, the same command gives the same bytes"},
  };
}
// clang-format on

#undef AT_VIEW
#undef AT

template <const Program& program>
const std::vector<OptionKind>& Table() {
  static const std::vector<OptionKind> table = [] {
    std::vector<OptionKind> rows;
    for (const auto& part : {CameraAndImageOptions(), ViewingOptions(), LightOptions(), DrawnModeOptions(),
                             QualityOptions(), SpeedOptions(), SceneOptions(), BatchOptions(), MessageOptions()})
      rows.insert(rows.end(), part.begin(), part.end());
    return WithAboutOptions<program>(std::move(rows));
  }();
  return table;
}

template <class Own>
std::unique_ptr<Options> Defaults() {
  return std::make_unique<Own>();
}

void CompleteRaypro(Options& options, std::span<const std::string> words) {
  CompleteCommandLine(As<RenderOptions>(options), words);
}

void CompleteRayview(Options& options, std::span<const std::string> words) {
  auto& all = As<ViewerOptions>(options);
  if (all.view.context != ViewOptions().context && !all.view.headless)
    throw UsageError("-context has no effect without -headless; a window has its own context");
  CompleteCommandLine(all, words);
}

constexpr const char* bad_scene = "The scene, or a file that it names, is wrong or missing.";

}  // namespace

const Program Program::raypro{
    .name = "raypro",
    .file_names = "scene image",
    .summary = "render a scene by ray tracing",
    .description =
        "Renders a scene file; the extensions choose the formats (raypro -list). The name - is standard input as a "
        "scene,\n"
        "in .scn, and standard output as an image, in PNG. A scene or a mesh that is named alone is rendered to a "
        "PNG of\nits name in its folder.\n"
        "An image has 1024 x 1024 pixels of 16 samples each, unless the scene or an option says otherwise.\n",
    .examples =
        "  raypro scenes/hello.scn hello.jpg\n"
        "  raypro scenes/hello.scn hello.jpg -width 1920 -height 1080 -samples 64\n"
        "  raypro scenes/hello.scn part.png -crop 100 100 160 140 -bits 16\n"
        "  raypro scenes/hello.scn scenes/glass.scn -out_folder images\n"
        "  raypro - - < scenes/hello.scn > hello.png\n"
        "  raypro scenes/hello.scn -check\n"
        "  raypro scenes/hello.scn -samples 1 -debugpixel 512 400\n",
    .statuses = {{"0", "Success."},
                 {"1", "Failed while rendering."},
                 {"2", "Wrong arguments."},
                 {"3", bad_scene},
                 {"4", "The image cannot be written."},
                 {"129, 130, 143, 152", "Stopped by SIGHUP, SIGINT, SIGTERM or SIGXCPU; the image so far is saved."}},
    .failed = status::failed,
    .options = Table<Program::raypro>,
    .commands = [] { return std::span<const CommandKind>(); },
    .defaults = Defaults<RenderOptions>,
    .complete = CompleteRaypro};

const Program Program::rayview{
    .name = "rayview",
    .file_names = "scene",
    .summary = "view a scene, and ray trace the view",
    .description =
        "Shows a scene file in a window; key H there lists the keys and what the mouse does. Key S traces the view.\n"
        "Scenes in .scn can be changed there, by the panel Scene of key Tab, and saved by Control+S.\n",
    .examples =
        "  rayview scenes/hello.scn -image hello.png -samples 16\n"
        "  rayview scenes/hello.scn -headless -events tour.txt -screenshot end.png\n"
        "  rayview scenes/hello.scn -headless -exit_immediately -output_image first.png\n",
    .statuses = {{"0", "Success."},
                 {"1", "There is nothing to draw with, or drawing failed."},
                 {"2", "Wrong arguments."},
                 {"3", bad_scene},
                 {"4", "A file cannot be written."}},
    .failed = status::failed,
    .options = Table<Program::rayview>,
    .commands = [] { return std::span<const CommandKind>(); },
    .defaults = Defaults<ViewerOptions>,
    .complete = CompleteRayview};

}  // namespace ray
