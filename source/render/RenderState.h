#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "source/film/Film.h"
#include "source/integrate/RayCounts.h"
#include "source/render/Pass.h"

namespace ray {

/// A render between two samples: all that is needed to go on to the same picture, bit for bit.
struct RenderState {
  std::vector<Film::Block> blocks;
  std::vector<std::uint32_t> targets;  // samples a pixel and stream that the blocks are on their way to
  std::vector<double> squares_before;  // errors of the blocks when the last pass was decided on; empty before the first
  std::uint32_t end = 0;               // of the pass they are in
  std::vector<Pass> passes;            // that are over
  RayCounts rays;
};

/// Why a checkpoint cannot be gone on from, in words.
struct CheckpointError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The bytes of a checkpoint. `identity`: lines "name value" that say of which picture it is.
std::vector<unsigned char> Encoded(const RenderState& state, const std::string& identity);

/// Throws CheckpointError for anything but what Encoded gave for the same identity and a film of the same blocks; the
/// message names the first line of the identity that differs. `film` is an empty one of the picture that goes on.
RenderState DecodedState(std::span<const unsigned char> bytes, const std::string& identity, const Film& film);

}  // namespace ray
