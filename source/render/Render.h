#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
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

/// What a render is at: samples, then, for a picture that is denoised, its guides and the filters.
enum class RenderPhase { samples, guides, filters };

/// How far a phase of a render has come.
struct RenderProgress {
  std::int64_t done = 0, total = 0;  // samples, with an error budget as predicted; with a time, milliseconds
  std::uint64_t rays = 0;            // of all kinds, so far; 0 but for samples
  RenderPhase phase = RenderPhase::samples;  // else `done` and `total` are parts of it
};

/// What a render needs from its caller.
struct RenderMonitor {
  const std::atomic<bool>* stop = nullptr;               // looked at before each few rays; may be null
  std::function<void(const RenderProgress&)> tile_done;  // called from any thread, one at a time; may be empty
  double seconds_before = 0;                             // that the program has run when the render begins
  /// Keeps a state from which the render can resume; called by one thread at a time, every `save_every` seconds and
  /// when the render is stopped. May be empty.
  std::function<void(const RenderState&)> save;
  double save_every = 0;        // 0: only when stopped
  bool saves_finished = false;  // and when the render is over, so that samples can be added to it
  /// Gives the state to resume from, made for a film like this empty one; called once, before the first sample. May be
  /// empty, and throw.
  std::function<RenderState(const Film&)> resume;
  /// Encodes an image as it will be written, so that it is known how long that takes. May be empty; only where there is
  /// a time limit.
  std::function<void(const R2::Image&)> encode;
  /// Sees the picture between two passes, once all pixels have a sample, and the samples per pixel and stream it has;
  /// called by the thread that renders, while no other does. May be empty; else samples are doubled pass by pass in any
  /// mode, which changes no bit of the result (but of heat, where an accelerator remembers the last hit: each pass
  /// begins without).
  std::function<void(const R2::Image&, std::uint32_t)> pass_done;
  /// Sees the film, and which more of its blocks have all the samples of the pass that runs; at its beginning those
  /// that have them from a state to resume from. Called from any thread, one at a time, while others take samples of
  /// other blocks. May be empty; else blocks are begun in rows from the bottom, and passes are left out that nothing is
  /// decided after, which changes no bit of the result.
  std::function<void(const Film&, std::span<const int> blocks)> blocks_done;
};

/// The image that a film of these settings has so far. Costs are shown by colors.
R2::Image ImageOf(const Film& film, const RenderSettings& settings);

/// What a render gives.
struct RenderSummary {
  std::int64_t pixels_done = 0, pixels_total = 0;  // with at least one sample; in all
  RayCounts rays;
  // How much of what the samples might find was cut off by settings, as throughput. Where that is as bright as the
  // picture is, so much of the picture's light is missing.
  double share_cut = 0;
  /// Returns true if users should know of the light that is missing.
  bool MissesLight() const { return share_cut > 0.02; }
  Stop stop = Stop::samples;
  SampleCounts samples;
  std::vector<std::uint32_t> block_samples;  // per pixel and stream, by blocks of the film
  std::vector<std::uint8_t> block_places;    // looked at, of blocks without samples; else 0
  std::uint32_t planned_samples = 1;         // samples per pixel that strata and camera rays were laid out for
  bool two_streams = false;                  // half of the samples are another, independent sequence
  std::vector<Pass> passes;
  std::optional<ErrorEstimate> error;                   // of the image; nothing below two samples
  std::optional<ErrorEstimate> error_before_denoising;  // only where it was denoised
  std::string denoised_by;                              // the name of the filters; empty where it was not denoised
  std::string denoise_failure;          // why it was not, though it should be; the image is as it was rendered then
  bool had_no_time_to_denoise = false;  // though it was asked for; then, too, the image is as it was rendered
  double denoise_seconds = 0, guide_seconds = 0;  // the latter a part of the former
  std::uint64_t guide_rays = 0;                   // a part of `rays`
  std::uint64_t rays_before = 0;                  // a part of `rays` too: of the state that it went on from
  std::optional<Refinement> refinement;           // nothing where it was not denoised, or without a clock
  UnseenLight unseen;                             // the error's interval allows for it
  bool has_outliers = false;                      // they hold most of the error, and no block was stopped early

  bool IsComplete() const { return stop != Stop::request; }
};

struct RenderResult : RenderSummary {
  R2::Image image;  // of the crop, or of the whole; filled where nothing was rendered yet
};

/// Renders the world through its scene's camera, or the view of the settings. The image is the same, bit for bit, for
/// any thread count and tile size.
RenderResult Render(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                    const RenderMonitor& monitor = {});
/// Renders with an integrator made before, so that many small parts of an image need not each make their own. The image
/// must not be one to denoise.
RenderResult Render(const World& world, const Integrator& integrator, const RenderSettings& settings,
                    const RenderMonitor& monitor = {});

/// Renders the blocks of settings.part alone, from the state that monitor.resume gives, for one round (Parts.h), and
/// gives each state to monitor.save, the last one always; both are needed.
///   returns   whether the round is over; else a signal or the time limit ended the render
bool RenderPart(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                const RenderMonitor& monitor);

/// Decides on the next round from a state in which every block has the samples of this one. It depends on the blocks
/// and on monitor.seconds_before, which counts from when the first round began. Nothing when the image is done.
std::optional<RenderState> NextRound(const World& world, const Accelerator& accelerator, const RenderSettings& settings,
                                     RenderState state, const RenderMonitor& monitor = {});

}  // namespace ray
