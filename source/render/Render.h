#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "source/accelerate/Accelerator.h"
#include "source/accelerate/World.h"
#include "source/film/Film.h"
#include "source/integrate/RayCounts.h"
#include "source/render/RenderInputs.h"
#include "source/render/RenderSettings.h"
#include "source/render/RenderState.h"
#include "source/render/SampleCounts.h"

namespace ray {

/// The phase of a render: samples, then, if the image is denoised, its guides and the filters.
enum class RenderPhase { samples, guides, filters };

/// The progress of a phase of a render.
struct RenderProgress {
  // samples, as predicted with an error budget; milliseconds with a time limit
  std::int64_t done = 0, total = 0;
  std::uint64_t rays = 0;  // of all kinds, so far; counted for samples only
  // in other phases `done` and `total` count their parts
  RenderPhase phase = RenderPhase::samples;
};

/// The callbacks and inputs that a render gets from its caller.
struct RenderMonitor {
  const std::atomic<bool>* stop = nullptr;               // checked before every few rays; may be null
  std::function<void(const RenderProgress&)> tile_done;  // called from any thread, one at a time; may be empty
  double seconds_before = 0;                             // run time of the program before the render
  /// Saves a state from which the render can resume. Called by one thread at a time, every `save_every` seconds and
  /// when the render is stopped. May be empty.
  std::function<void(const RenderState&)> save;
  double save_every = 0;        // 0: only when stopped
  bool saves_finished = false;  // also at the end of the render, so that samples can be added later
  /// Returns the state to resume from, made for a film like this empty one. Called once, before the first sample. May
  /// be empty, and throw.
  std::function<RenderState(const Film&)> resume;
  /// Encodes an image as it will be written, to measure the time that takes. Used only with a time limit. May be empty.
  std::function<void(const R2::Image&)> encode;
  /// Receives the image between two passes, once all pixels have a sample, and its samples per pixel and stream. Called
  /// by the rendering thread while no other renders. May be empty; otherwise samples are doubled pass by pass in any
  /// mode. That changes no bit of the result, except in mode heat, where an accelerator remembers the last hit: each
  /// pass begins without.
  std::function<void(const R2::Image&, std::uint32_t)> pass_done;
  /// Receives the film, and the blocks that have reached the samples of the current pass since the last call; at the
  /// beginning of the pass, those that have them from a state to resume from. Called from any thread, one at a time,
  /// while others take samples of other blocks. May be empty; otherwise blocks begin in rows from the bottom, and
  /// passes after which nothing is decided are skipped. That changes no bit of the result.
  std::function<void(const Film&, std::span<const int> blocks)> blocks_done;
};

/// Returns the image of a film of these settings so far. Costs are shown by colors.
R2::Image ImageOf(const Film& film, const RenderSettings& settings);

/// The results of a render apart from its image.
struct RenderSummary {
  std::int64_t pixels_done = 0, pixels_total = 0;  // pixels with at least one sample; all pixels
  RayCounts rays;
  // The throughput of paths that settings ended, relative to a camera ray's: the missing share of the image's light if
  // the light there is as bright as the image.
  double share_cut = 0;
  /// Returns true if users should know of the light that is missing.
  bool MissesLight() const {
    constexpr double least = 0.02;  // five of 255 levels, in white
    return share_cut > least;
  }
  Stop stop = Stop::samples;
  SampleCounts samples;
  std::vector<std::uint32_t> block_samples;  // per pixel and stream, by blocks of the film
  std::vector<std::uint8_t> block_places;    // places looked at in blocks without samples, otherwise 0
  // samples per pixel for which strata and camera rays were laid out
  std::uint32_t planned_samples = 1;
  bool two_streams = false;  // half of the samples are a second, independent sequence
  bool shares_light = false;  // see RenderSettings
  std::vector<Pass> passes;
  std::optional<ErrorEstimate> error;                   // of the image; std::nullopt below two samples
  std::optional<ErrorEstimate> error_before_denoising;  // only if it was denoised
  std::string denoised_by;                              // names of the filters; empty if it was not denoised
  // why denoising failed; the image is then unfiltered
  std::string denoise_failure;
  // denoising was requested; the image is unfiltered
  bool had_no_time_to_denoise = false;
  bool is_better_noisy = false;  // its error target is reached, and would not be with the image denoised
  double denoise_seconds = 0, guide_seconds = 0;  // guide_seconds is a part of denoise_seconds
  std::uint64_t guide_rays = 0;                   // a part of `rays`
  // a part of `rays`: those of the state from which the render resumed
  std::uint64_t rays_before = 0;
  // std::nullopt without denoising or without a clock
  std::optional<Refinement> refinement;
  UnseenLight unseen;         // included in the interval of the error
  bool has_outliers = false;  // they contain most of the error, and no block was stopped early

  bool IsComplete() const { return stop != Stop::request; }
};

struct RenderResult : RenderSummary {
  R2::Image image;  // of the crop, or of the whole image; filled where nothing was rendered yet
};

/// Renders the world through its scene's camera, or the view of the settings. The image is the same, bit for bit, for
/// any thread count and tile size.
RenderResult Render(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                    const RenderMonitor& monitor = {});
/// Renders with a given integrator, so that many small parts of an image need not each create their own. The settings
/// must not request denoising.
RenderResult Render(const World& world, const Integrator& integrator, const RenderSettings& settings,
                    const RenderMonitor& monitor = {});

/// Renders the blocks of settings.part alone, from the state of monitor.resume, for one round (Parts.h). Passes each
/// state to monitor.save, the last one always. Both callbacks are required.
///   returns   true if the round is complete; false if a signal or the time limit ended the render
bool RenderPart(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                const RenderMonitor& monitor);

/// Decides on the next round, from a state in which every block has the samples of this round. The decision depends on
/// the blocks and on monitor.seconds_before, which counts from the beginning of the first round. Returns std::nullopt
/// if the image is done.
std::optional<RenderState> NextRound(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                     RenderState state, const RenderMonitor& monitor = {});

}  // namespace ray
