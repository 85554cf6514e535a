#include "source/app/options/RenderChecks.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>

#include "source/accelerate/twolevel/InstructionSet.h"
#include "source/app/Status.h"
#include "source/app/options/BudgetWords.h"
#include "source/app/options/FileNames.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/Preset.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/report/Memory.h"
#include "source/film/denoise/DenoiseFilters.h"
#include "source/text/EnumNames.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Rejects options that affect only rendering; those that affect reading the scene are allowed.
void CheckConvert(const RenderOptions& options) {
  if (!options.Asks("convert")) return;
  if (!options.files.image.empty()) RefuseName(options.files.image, "; -convert writes no image");
  for (const std::string& name : options.given) {
    const OptionKind& option = *FindOption(*options.program, name);
    if (IsSetting(option) && !option.facts.Has(Fact::with_convert))
      throw UsageError("-" + name + " has no effect with -convert, which renders nothing");
  }
}

void CheckPixelIsInImage(const RenderOptions& options) {
  if (!options.pixel) return;
  const auto& [x, y] = *options.pixel;
  const auto& [width, height] = std::tie(options.render.width, options.render.height);
  if (x >= 0 && x < width && y >= 0 && y < height) return;
  throw UsageError("-debugpixel " + std::to_string(x) + " " + std::to_string(y) + ": an image of " +
                   std::to_string(width) + " x " + std::to_string(height) + " has columns 0 to " +
                   std::to_string(width - 1) + " and rows 0 to " + std::to_string(height - 1));
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
  RenderOptions given;
  given.render = render;
  throw UsageError("-crop " + given.Show(option) + ": it must be " + Range(option) + " of " +
                   std::to_string(render.width) + " x " + std::to_string(render.height));
}

void CheckEffects(const CameraEffects& camera) {
  if (camera.HasLens() && !(camera.focus > 0)) throw UsageError("-aperture needs -focus, the focus distance");
}

/// Checks -denoise, which is for light, the only content with noise, and needs two streams to measure it.
void CheckDenoise(const RenderOptions& options) {
  const RenderSettings& render = options.render;
  if (!render.denoise) return;
  if (render.mode != RenderMode::whitted && render.mode != RenderMode::path)
    throw UsageError(std::string("-denoise has no effect with -mode ") + NameOf(render.mode) +
                     "; it is for whitted and path");
  if (render.samples < 2 && !render.budget.IsOpen() && options.files.replay.empty())
    throw UsageError("-denoise needs -samples 2 or more, -error or -time");
}

/// Checks that the selected denoising library is available, before the first ray.
void CheckDenoiser(const RenderSettings& render) {
  if (!render.denoise || render.denoiser == Denoiser::automatic) return;
  try {
    DenoiseFilters(render.denoiser, render.threads);
  } catch (const DenoiserError& error) {
    throw UsageError(std::string("-denoiser ") + NameOf(render.denoiser) + ": " + error.what());
  }
}

/// Checks that square grids in pixels get square numbers of camera rays.
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

/// Checks -adaptive neighbors; budgets decide by errors.
void CheckNeighbors(const RenderSettings& render) {
  if (render.budget.adaptive != Adaptive::neighbors) return;
  if (render.budget.seconds > 0 || render.budget.error || render.denoise)
    throw UsageError(
        "-adaptive neighbors takes one sample or all of them; it cannot be combined with -time, -error or -denoise");
}

/// Checks subsampling: decisions by errors need samples in every pixel, and costs and numbers of primitives cannot be
/// interpolated.
void CheckSubsampling(const RenderSettings& render) {
  if (!IsSubsampled(render)) return;
  const std::string samples = "-samples " + ShowSamples(render) + " leaves pixels out; it cannot be combined with ";
  if (render.budget.error) throw UsageError(samples + "-error");
  if (render.denoise) throw UsageError(samples + "-denoise");
  if (render.budget.adaptive == Adaptive::neighbors) throw UsageError(samples + "-adaptive neighbors");
  if (ShowsCosts(render.mode) || render.mode == *Named<RenderMode>("id"))
    throw UsageError(samples + "-mode " + NameOf(render.mode));
}

void CheckBudget(const RenderOptions& options) {
  const Budget& budget = options.render.budget;
  if (!options.files.replay.empty() && budget.IsOpen())  // by -quality
    throw UsageError("-replay and -quality " + options.quality + " contradict each other");
  if (ShowsCosts(options.render.mode) && budget.error)
    throw UsageError(std::string("-error has no effect with -mode ") + NameOf(options.render.mode) +
                     ", which shows costs");
}

/// Checks -part, -missing and -parts with each other and with options that need a finished image.
void CheckParts(const RenderOptions& options) {
  const bool is_part = options.render.part.has_value(), assembles = !options.parts.empty() && options.missing == 0;
  if (assembles && options.checkpoint.resume)
    throw UsageError("-parts and -resume contradict each other: the checkpoint of an assembled image has the parts");
  if (!is_part && options.missing == 0) return;
  for (const std::string& name : options.given)
    if (FindOption(*options.program, name)->facts.Has(Fact::whole_image))
      throw UsageError("-" + name + " needs the whole image; it cannot be combined with -" +
                       (is_part ? "part" : "missing"));
}

/// Sets the values that follow from other options.
void Derive(RenderOptions& options) {
  RenderSettings& render = options.render;
  render.srgb = options.encoding.srgb;  // as displayed, although linear formats store linear light
  render.quantization = options.encoding.quantization;
  render.wants_passes = !options.files.report.empty() && render.samples > 1;
  options.parse.problem_of = ProblemOf;
  options.parse.max_texture_bytes = MemoryLimit(options.memory);
  options.parse.aspect = static_cast<double>(options.render.width) / options.render.height;
  options.parse.decode_srgb = options.encoding.srgb;  // a linear workflow is linear from end to end
}

}  // namespace

void CompleteCommandLine(RenderOptions& options, std::span<const std::string> words) {
  ApplyPreset(options);
  ShareNames(options, words);
  CheckBudget(options);
  CheckSize(options.render);
  CheckConvert(options);
  CheckParts(options);
  Derive(options);
}

void CompleteForScene(RenderOptions& options) {
  if (options.render.denoise) options.render.denoiser = Resolved(options.render.denoiser);
  CheckEffects(options.render.camera);
  CheckSubsampling(options.render);
  CheckDenoise(options);
  CheckGrid(options.render);
  CheckNeighbors(options.render);
  CheckSize(options.render);
  CheckCrop(options.render);
  CheckPixelIsInImage(options);
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
