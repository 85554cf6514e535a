#pragma once

#include <span>
#include <vector>

#include "source/render/RenderState.h"

/// Rendering an image in parts and joining them. A round takes as many samples as possible before a decision needs the
/// whole film. Without a budget and without -adaptive neighbors, one round is the whole render.
namespace ray {

/// Returns the part, 1-based, of each block. Neighboring blocks, or squares of blocks whose samples are taken together,
/// belong to different parts, and parts differ by at most one of them in size, so that all take about equally long.
///   source   Roberts, The unreasonable effectiveness of quasirandom sequences (2018), for the lattice
std::vector<int> PartsOfBlocks(const Film& film, int of);

/// Returns a render before its first sample, with the targets of the first round.
RenderState FirstRound(const RenderSettings& settings, const Film& film);

/// Returns true if no decision needs the whole film.
bool IsOfOneRound(const RenderSettings& settings, const Film& film);

/// Throws CheckpointError if a block that is not in the part has samples.
///   parts   the part of each block, from PartsOfBlocks; also in the functions below
void CheckPart(const RenderState& state, int part, std::span<const int> parts);

/// Moves the part's blocks to `whole`, replacing those that are there. The rays of `whole` are unchanged.
void TakeBlocks(RenderState& whole, RenderState&& of_part, int part, std::span<const int> parts);

/// Returns true if two renders agree: blocks with equal sample counts must have equal sums, bit for bit.
bool Agree(const RenderState& a, const RenderState& b);
/// Returns the number of samples of all blocks, to compare the progress of two renders of a part.
double SamplesOf(const RenderState& state);

/// Returns the parts, 1-based and ascending, that lack samples of the round.
std::vector<int> MissingParts(const RenderState& round, const RenderSettings& settings, std::span<const int> parts);

/// Returns the content of a part's file: blocks, rays and targets, but no times, so that its bytes do not depend on the
/// machine's speed.
RenderState ForPartFile(RenderState&& state);
/// Returns the initial state of the next round: everything except the samples, which the parts contain.
RenderState WithoutSamples(RenderState&& state, const Film& film);

}  // namespace ray
