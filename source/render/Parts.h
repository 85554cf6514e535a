#pragma once

#include <span>
#include <vector>

#include "source/render/ImagePart.h"
#include "source/render/RenderState.h"

/// Rendering an image in parts and joining them. A round is as many samples as can be taken before a decision needs the
/// whole film; without a budget and without -adaptive neighbors, one round is the whole render.
namespace ray {

/// The part, 1-based, that each block belongs to. Neighboring blocks go to different parts, and parts differ by at most
/// one block in size, so that all take about as long.
///   source   Roberts, The unreasonable effectiveness of quasirandom sequences (2018), for the lattice
std::vector<int> PartsOfBlocks(const Film& film, int of);

/// A render before its first sample, which is due those of the first round.
RenderState FirstRound(const RenderSettings& settings, const Film& film);

/// Whether nothing is decided that needs the whole film.
bool IsOfOneRound(const RenderSettings& settings, const Film& film);

/// Throws CheckpointError when a block has samples that does not belong to the part.
///   parts   of each block, as from PartsOfBlocks; here and below
void CheckPart(const RenderState& state, int part, std::span<const int> parts);

/// Moves the part's blocks to `whole`, in place of those that are there. The rays of `whole` are left as they are.
void TakeBlocks(RenderState& whole, RenderState&& of_part, int part, std::span<const int> parts);

/// Whether two renders agree: blocks that have equally many samples must have equal sums, bit for bit.
bool Agree(const RenderState& a, const RenderState& b);
/// Samples of all blocks, to tell which of two renders of a part got further.
double SamplesOf(const RenderState& state);

/// The parts, 1-based and ascending, that lack samples which the round is due.
std::vector<int> MissingParts(const RenderState& round, const RenderSettings& settings, std::span<const int> parts);

/// What a file of a part keeps: blocks, rays and targets, but no times, so that its bytes do not depend on the
/// machine's speed.
RenderState ForPartFile(RenderState&& state);
/// What the next round begins with: everything but the samples, which the parts have.
RenderState WithoutSamples(RenderState&& state, const Film& film);

}  // namespace ray
