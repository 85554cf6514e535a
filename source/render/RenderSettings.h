#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "source/film/BlockOrder.h"
#include "source/film/Filter.h"
#include "source/film/PixelRectangle.h"
#include "source/film/denoise/Denoiser.h"
#include "source/film/error/PictureError.h"
#include "source/integrate/CameraRays.h"
#include "source/integrate/Integrators.h"
#include "source/integrate/TraceSettings.h"
#include "source/render/ImagePart.h"

namespace ray {

/// An error that a picture is to stay below.
struct ErrorTarget {
  double value = 0;
  ErrorUnit unit = ErrorUnit::display;
  friend bool operator==(const ErrorTarget&, const ErrorTarget&) = default;
};

/// off: every pixel takes as many samples. tile: only blocks of 8x8 pixels whose error, or a neighbor's, is above the
/// target go on. automatic: tile where there is a target. neighbors: without a budget, after one sample only blocks go
/// on, to all of their samples, in which neighboring pixels differ.
enum class Adaptive { automatic, off, tile, neighbors };
inline constexpr std::array adaptive_names{"auto", "off", "tile", "neighbors"};
constexpr const auto& NamesOf(Adaptive) { return adaptive_names; }

/// What is clamped to what a screen can show, [0, 1] in each channel: the picture when it is written, or each sample
/// before it counts, which takes bright edges' stairs away and light with them.
enum class Clamp { picture, samples };
inline constexpr std::array clamp_names{"picture", "samples"};
constexpr const auto& NamesOf(Clamp) { return clamp_names; }

/// When to stop. Whatever is reached first ends the render.
struct Budget {
  double seconds = 0;                // from the start of the program to the picture written; 0: no limit
  double seconds_to_finish = 0;      // of them, that a picture takes to be written of which nothing is known
  double seconds_to_filter = 0;      // of them, that filters would take alone; see SecondsToFilter
  std::optional<ErrorTarget> error;  // stop when the upper end of the error's interval is below
  double confidence = 0.95;          // of that interval, in (0, 1)
  Adaptive adaptive = Adaptive::automatic;

  bool IsOpen() const { return seconds > 0 || error; }
};

/// What is left of it for a picture that takes all its samples: which blocks may do with one.
inline Budget WithoutLimits(const Budget& budget) {
  Budget none;
  if (budget.adaptive == Adaptive::neighbors) none.adaptive = Adaptive::neighbors;
  return none;
}

/// How many rays guides may take at edges besides those of the samples' own camera rays, where there is a clock; else
/// they are in proportion to the samples, see GatherGuides.
struct Refinement {
  std::uint64_t rays = 0;  // of all kinds, about
  // Camera rays of a pixel, or as many as its samples. 32 had a tenth more error on the scenes of
  // script/denoise_table.sh, 256 hardly less.
  std::uint32_t samples = 128;
};

/// The sample allocation of an earlier render, so that it can be rendered again bit by bit though it was stopped by a
/// clock or by its error.
struct Replay {
  bool two_streams = false;
  std::uint32_t planned_samples = 1;       // see RenderResult
  std::vector<std::uint32_t> ends;         // samples per pixel and stream at which passes ended, ascending
  std::vector<std::uint32_t> samples;      // per pixel and stream of each block; empty when all have the last of `ends`
  std::vector<std::uint8_t> places;        // looked at, of blocks that have none; empty when all have some
  bool denoised = true;                    // where that is asked for: else there was no time
  std::optional<Refinement> refinement{};  // nothing: in proportion to the samples
  bool looked_at_error = false;            // decided by it, so that how it fell bears on what it claims
};

/// What picture to make of a scene, and how the work is spread; the latter never changes a bit of the former.
struct RenderSettings {
  int width = 256, height = 256;       // of the whole picture
  std::optional<PixelRectangle> crop;  // the part that is rendered: pixels of the whole, but for CropDifferences
  int samples = 1;                     // camera rays per pixel, >= 1; a ceiling where there is a budget, unless it is 1
  // How many of a block's 64 pixels are traced, in BlockOrder, where `samples` is 1; the others are filled from those,
  // see FillGaps. A power of two.
  int places = BlockOrder::places;
  std::uint64_t seed = 0;
  RenderMode mode = RenderMode::whitted;
  FilterKind filter = FilterKind::box;
  Clamp clamp = Clamp::picture;
  R2::Quantization quantization = R2::Quantization::rounded;  // of the picture once it is written
  CameraEffects camera;
  std::optional<Camera> view;  // to look from instead of the scene's own camera
  TraceSettings trace;
  Budget budget;
  std::optional<Replay> replay;
  std::optional<ImagePart> part;  // of which alone blocks are rendered, see RenderPart
  bool denoise = false;           // filter the picture of light once it is complete; takes two streams
  Denoiser denoiser = Denoiser::regression;
  double flare = 0;  // how bright lens flares are that are added to the finished picture, see AddFlare; 0: none
  bool srgb = false;                 // the picture will be sRGB encoded, so display errors are counted after that
  bool wants_passes = false;         // measure the error pass by pass, to see it fall

  int threads = 0;     // 0: as many as the machine has
  int tile_size = 32;  // side of a work item in pixels, rounded up to whole blocks of the film; 0: the whole picture
};

/// Whether emission is a radiance and everything that emits a lamp; else it is a color, as mode whitted reads it.
inline bool EmitsRadiance(const RenderSettings& settings) {
  return settings.mode == RenderMode::path && settings.trace.emission == Emission::radiance;
}

/// Whether some pixels are to have no sample at all.
inline bool IsSubsampled(const RenderSettings& settings) {
  return settings.samples == 1 && settings.places < BlockOrder::places;
}

/// The part of the picture that is rendered.
inline PixelRectangle RegionOf(const RenderSettings& settings) {
  return settings.crop.value_or(PixelRectangle{0, 0, settings.width, settings.height});
}

/// Whether blocks of like pixels get one sample alone; so they have in a replay, which says it of each block.
inline bool HasSamplesWhereNeighborsDiffer(const RenderSettings& settings) {
  return settings.budget.adaptive == Adaptive::neighbors && !settings.budget.IsOpen() && !ShowsCosts(settings.mode);
}
/// Whether neighbors decide about it.
inline bool SamplesWhereNeighborsDiffer(const RenderSettings& settings) {
  return HasSamplesWhereNeighborsDiffer(settings) && !settings.replay;
}

/// How many pixels around that part are rendered, so that what depends on neighbors is as in the whole image: the
/// denoiser, and the comparison of the pixels of blocks. Blocks that a wide filter reaches the part from are compared
/// too.
inline int SurroundingsOf(const RenderSettings& settings) {
  if (HasSamplesWhereNeighborsDiffer(settings)) return BlockOrder::side + Filter(settings.filter).Apron();
  return settings.denoise ? denoise_reach : 0;
}
/// The part that is rendered and, as far as there is a picture, what is made around it.
inline PixelRectangle MadeRegionOf(const RenderSettings& settings) {
  return Common({0, 0, settings.width, settings.height}, Grown(RegionOf(settings), SurroundingsOf(settings)));
}

}  // namespace ray
