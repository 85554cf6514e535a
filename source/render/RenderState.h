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

/// A completed pass over the image.
struct Pass {
  std::uint32_t end = 0;  // samples per pixel and stream in the blocks that took part
  double samples = 0;     // per pixel, on average over the image
  double seconds = 0;     // since the render began
  std::optional<ErrorEstimate> error;
};

/// A render between two samples: the complete state from which it continues to the same image, bit for bit.
struct RenderState {
  std::vector<Film::Block> blocks;
  ScheduleState schedule;
  std::vector<Pass> passes;
  RayCounts rays;
  std::uint32_t planned_samples = 1;  // see PlannedSamples
  BlockErrors differences;            // see MeasureError; empty if none were measured
};

/// The reason why a render cannot resume from a checkpoint.
struct CheckpointError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The checkpoint is intact, but of another image, version or machine type, so it must not be overwritten.
struct OtherImageError : CheckpointError {
  using CheckpointError::CheckpointError;
};

/// Encodes a checkpoint. `identity`: lines "name value" that identify its image.
std::vector<unsigned char> Encoded(const RenderState& state, const std::string& identity);

/// Decodes a checkpoint. Throws CheckpointError for anything except the output of Encoded for the same identity and a
/// film with the same blocks; the message contains the first line of the identity that differs. `film` is an empty film
/// of the image to be continued.
RenderState DecodedState(std::span<const unsigned char> bytes, const std::string& identity, const Film& film);

/// Throws CheckpointError unless continuing from the state to the samples of the settings gives the image of a render
/// that planned them from the start, to the last bit.
void CheckPlan(const RenderState& state, const RenderSettings& settings);

/// Throws CheckpointError for a state that no render with these settings reaches: a schedule must be able to choose its
/// targets and errors, and a film to contain its samples. Colors are not checked: only another render could verify
/// them.
void CheckState(const RenderState& state, const Film& film, const RenderSettings& settings);

}  // namespace ray
