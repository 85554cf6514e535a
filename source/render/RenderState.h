#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "source/film/Film.h"
#include "source/integrate/RayCounts.h"
#include "source/render/Schedule.h"

namespace ray {

/// A pass over the picture that is over.
struct Pass {
  std::uint32_t end = 0;  // samples per pixel and stream, of the blocks that took part
  double samples = 0;     // per pixel, on average over the picture
  double seconds = 0;     // since the render began
  std::optional<ErrorEstimate> error;
};

/// A render between two samples: all that is needed to continue to the same image, bit for bit.
struct RenderState {
  std::vector<Film::Block> blocks;
  ScheduleState schedule;
  std::vector<Pass> passes;
  RayCounts rays;
  std::uint32_t planned_samples = 1;  // see PlannedSamples
  BlockErrors differences;            // see MeasureError; empty where none were measured
};

/// Why a render cannot resume from a checkpoint, in words.
struct CheckpointError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The checkpoint is whole, but of another image, version or machine type: nothing that may be rendered over.
struct OtherImageError : CheckpointError {
  using CheckpointError::CheckpointError;
};

/// The bytes of a checkpoint. `identity`: lines "name value" that say of which picture it is.
std::vector<unsigned char> Encoded(const RenderState& state, const std::string& identity);

/// Throws CheckpointError for anything but what Encoded gave for the same identity and a film of the same blocks; the
/// message names the first line of the identity that differs. `film` is an empty film of the image to be continued.
RenderState DecodedState(std::span<const unsigned char> bytes, const std::string& identity, const Film& film);

/// Throws CheckpointError when going on from the state to the samples of the settings would not give the picture of a
/// render that had them in view from the start, to the last bit.
void CheckPlan(const RenderState& state, const RenderSettings& settings);

/// Throws CheckpointError for a state that no render with these settings gets into: samples, targets and errors are
/// what a schedule may choose and a film may hold. Colors may be any: nothing but another render can tell.
void CheckState(const RenderState& state, const Film& film, const RenderSettings& settings);

}  // namespace ray
