#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "source/film/BlockOrder.h"
#include "source/film/Filter.h"
#include "source/film/PixelRectangle.h"
#include "source/film/denoise/Denoiser.h"
#include "source/film/error/ImageError.h"
#include "source/integrate/CameraRays.h"
#include "source/integrate/Integrators.h"
#include "source/integrate/TraceSettings.h"

namespace ray {

/// One of `of` parts of an image that several machines render together. Each block of the film belongs to one part, see
/// PartsOfBlocks.
struct ImagePart {
  int index = 1, of = 1;  // 1-based, index <= of
  friend bool operator==(const ImagePart&, const ImagePart&) = default;
};
inline constexpr int most_image_parts = 1 << 20;

/// A limit of an image's error.
struct ErrorTarget {
  double value = 0;
  ErrorUnit unit = ErrorUnit::display;
  friend bool operator==(const ErrorTarget&, const ErrorTarget&) = default;
};

/// The distribution of samples over the image.
///   off         every pixel takes equally many samples
///   tile        only blocks of 8x8 pixels continue that need more samples, in proportion to their samples' deviation
///   automatic   tile with a target, otherwise off
///   neighbors   without a budget, after one sample only those blocks continue, to all of their samples, in which
///               neighboring pixels differ
enum class Adaptive { automatic, off, tile, neighbors };
inline constexpr std::array adaptive_names{"auto", "off", "tile", "neighbors"};
constexpr const auto& NamesOf(Adaptive) { return adaptive_names; }

/// The values that are clamped to the range of a screen, [0, 1] in each channel: those of the image when it is written,
/// or each sample before averaging, which removes the stairs of bright edges, and light with them.
enum class Clamp { image, samples };
inline constexpr std::array clamp_names{"picture", "samples"};
constexpr const auto& NamesOf(Clamp) { return clamp_names; }

/// Sharing of light by the paths of neighboring pixels, see SharedPaths; automatic: if that makes the render more
/// efficient.
enum class Sharing { automatic, on, off };
inline constexpr std::array sharing_names{"auto", "on", "off"};
constexpr const auto& NamesOf(Sharing) { return sharing_names; }

/// Conditions that end a render. The first one that is met ends it.
struct Budget {
  double seconds = 0;                // from the start of the program to the written image; 0: no limit
  double seconds_to_finish = 0;      // part of `seconds`: time to write an image that is still unknown
  double seconds_to_filter = 0;      // part of `seconds`: time of the filters alone, see SecondsToFilter
  std::optional<ErrorTarget> error;  // stop when the upper end of the error's interval is below
  double confidence = 0.95;          // of that interval, in (0, 1)
  Adaptive adaptive = Adaptive::automatic;

  bool IsOpen() const { return seconds > 0 || error; }
};

/// Returns the part of a budget that applies to an image that takes all its samples: which blocks may have one sample.
inline Budget WithoutLimits(const Budget& budget) {
  Budget none;
  if (budget.adaptive == Adaptive::neighbors) none.adaptive = Adaptive::neighbors;
  return none;
}

/// The number of additional rays for guides at edges, in a render with a time limit. Without a limit, their number is
/// in proportion to the samples, see GatherGuides.
struct Refinement {
  std::uint64_t rays = 0;  // of all kinds, approximately
  // The limit of camera rays per pixel; pixels with more samples may have as many as these. 32 had a tenth more error
  // on the scenes of script/denoise_table.sh, 256 hardly less.
  std::uint32_t samples = 128;
};

/// The sample allocation of an earlier render, with which it can be repeated bit for bit even if a clock or its error
/// ended it.
struct Replay {
  bool two_streams = false;
  std::uint32_t planned_samples = 1;       // see RenderSummary
  std::vector<std::uint32_t> ends;         // samples per pixel and stream at which passes ended, ascending
  // per pixel and stream of each block; empty if all have the last of `ends`
  std::vector<std::uint32_t> samples;
  // places looked at in blocks without samples; empty if all blocks have samples
  std::vector<std::uint8_t> places;
  bool denoised = true;                    // false if the requested denoising was omitted
  std::optional<Refinement> refinement{};  // std::nullopt: in proportion to the samples
  // the error decided, so its history affects the estimate
  bool looked_at_error = false;
  bool shares_light = false;
};

/// The image to render from a scene, and the distribution of the work. The latter never changes a bit of the image.
struct RenderSettings {
  int width = 256, height = 256;  // of the whole image
  // the rendered part: pixels of the whole image, except for CropDifferences
  std::optional<PixelRectangle> crop;
  // camera rays per pixel, >= 1; an upper limit with a budget, unless it is 1
  int samples = 1;
  // The number of a block's 64 pixels that are traced, in BlockOrder, if `samples` is 1; the others are filled from
  // those, see FillGaps. A power of two.
  int places = BlockOrder::places;
  std::uint64_t seed = 0;
  RenderMode mode = RenderMode::whitted;
  FilterKind filter = FilterKind::box;
  Clamp clamp = Clamp::image;
  R2::Quantization quantization = R2::Quantization::rounded;  // of the written image
  Sharing share = Sharing::automatic;
  bool shares_light = false;  // the decision, see SharesLight
  CameraEffects camera;
  std::optional<Camera> view;  // replaces the scene's own camera
  TraceSettings trace;
  Budget budget;
  std::optional<Replay> replay;
  std::optional<ImagePart> part;  // renders the blocks of this part alone, see RenderPart
  bool denoise = false;           // filters the complete image of light; requires two streams
  Denoiser denoiser = Denoiser::regression;
  // brightness of lens flares in the finished image, see AddFlare; 0: none
  double flare = 0;
  // the image will be sRGB encoded, so display errors are measured after that
  bool srgb = false;
  bool wants_passes = false;  // measure the error pass by pass, to report its history

  int threads = 0;     // 0: as many as the machine has
  // side of a work item in pixels, rounded up to whole blocks of the film; 0: the whole image
  int tile_size = 32;
};

/// Returns true if emission is a radiance and all emissive shapes are lights; false if it is a color, as in mode
/// whitted.
inline bool EmitsRadiance(const RenderSettings& settings) {
  return settings.mode == RenderMode::path && settings.trace.emission == Emission::radiance;
}

/// Returns true if some pixels have no samples.
inline bool IsSubsampled(const RenderSettings& settings) {
  return settings.samples == 1 && settings.places < BlockOrder::places;
}

/// Returns the rendered part of the image.
inline PixelRectangle RegionOf(const RenderSettings& settings) {
  return settings.crop.value_or(PixelRectangle{0, 0, settings.width, settings.height});
}

/// Returns true if blocks with similar pixels get a single sample. True in a replay as well, which contains the
/// decision for each block.
inline bool HasSamplesWhereNeighborsDiffer(const RenderSettings& settings) {
  return settings.budget.adaptive == Adaptive::neighbors && !settings.budget.IsOpen() && !ShowsCosts(settings.mode);
}
/// Returns true if neighboring pixels decide about it, which excludes replays.
inline bool SamplesWhereNeighborsDiffer(const RenderSettings& settings) {
  return HasSamplesWhereNeighborsDiffer(settings) && !settings.replay;
}

/// Returns the number of pixels rendered around that part, so that results that depend on neighbors are those of the
/// whole image: of the denoiser, and of comparing the pixels of blocks. Blocks from which a wide filter reaches the
/// part are compared too.
inline int SurroundingsOf(const RenderSettings& settings) {
  if (HasSamplesWhereNeighborsDiffer(settings)) return BlockOrder::side + Filter(settings.filter).Apron();
  return settings.denoise ? denoise_reach : 0;
}
/// Returns the rendered part with its surroundings, clipped to the image.
inline PixelRectangle MadeRegionOf(const RenderSettings& settings) {
  return Common({0, 0, settings.width, settings.height}, Grown(RegionOf(settings), SurroundingsOf(settings)));
}

}  // namespace ray
