#include "source/render/Parts.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

#include "source/render/Tiles.h"

namespace ray {
namespace {

/// Returns a square's place in the lattice, as a fraction of 2^32.
std::uint32_t PlaceInLattice(int square, int columns) {
  // 1 / g and 1 / g^2, where g^3 = g + 1.
  constexpr std::uint32_t step_of_column = 3'242'174'889u, step_of_row = 2'447'445'414u;
  return static_cast<std::uint32_t>(square % columns) * step_of_column +
         static_cast<std::uint32_t>(square / columns) * step_of_row;
}

bool AreEqual(const std::vector<WeightedSum>& a, const std::vector<WeightedSum>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

bool IsAtTarget(const RenderState& round, std::size_t block, bool has_two_streams) {
  return round.blocks[block].SamplesPerStream(has_two_streams) >= round.schedule.targets.samples[block];
}

bool Agree(const Film::Block& a, const Film::Block& b) {
  for (int part = 0; part < Film::parts; ++part)
    if (a.samples[part] != b.samples[part]) return true;  // of other samples: one progressed further
  for (int part = 0; part < Film::parts; ++part)
    if (!AreEqual(a.sums[part].Sums(), b.sums[part].Sums())) return false;
  return true;
}

}  // namespace

std::vector<int> PartsOfBlocks(const Film& film, int of) {
  const Tiles squares(film, film.Together() * Film::block_side);
  const auto count = static_cast<std::size_t>(squares.Count());
  std::vector<int> order(count), parts(static_cast<std::size_t>(film.Blocks()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {},
                    [&](int square) { return std::pair(PlaceInLattice(square, squares.Columns()), square); });
  for (std::size_t rank = 0; rank < count; ++rank)
    for (const int block : squares.BlocksOf(order[rank]))
      parts[static_cast<std::size_t>(block)] = 1 + static_cast<int>(rank * static_cast<std::size_t>(of) / count);
  return parts;
}

RenderState FirstRound(const RenderSettings& settings, const Film& film) {
  Schedule schedule(settings, {film.Columns(), film.AreasInRegion(), film.Together()}, false);
  schedule.SkipToRound();
  RenderState state;
  state.schedule = schedule.State();
  state.planned_samples = PlannedSamples(settings);
  for (int i = 0; i < film.Blocks(); ++i) state.blocks.push_back(film[i]);
  return state;
}

bool IsOfOneRound(const RenderSettings& settings, const Film& film) {
  Schedule schedule(settings, {film.Columns(), film.AreasInRegion(), film.Together()}, false);
  schedule.SkipToRound();
  return !schedule.NeedsWholeImage();
}

void CheckPart(const RenderState& state, int part, std::span<const int> parts) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] != part && (state.blocks[i].Samples() > 0 || !state.blocks[i].first_samples.empty()))
      throw CheckpointError("it has blocks of other parts");
}

void TakeBlocks(RenderState& whole, RenderState&& of_part, int part, std::span<const int> parts) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] == part) whole.blocks[i] = std::move(of_part.blocks[i]);
}

bool Agree(const RenderState& a, const RenderState& b) {
  for (std::size_t i = 0; i < a.blocks.size(); ++i)
    if (!Agree(a.blocks[i], b.blocks[i])) return false;
  return true;
}

double SamplesOf(const RenderState& state) {
  double sum = 0;
  for (const Film::Block& block : state.blocks) sum += block.Samples();
  return sum;
}

std::vector<int> MissingParts(const RenderState& round, const RenderSettings& settings, std::span<const int> parts) {
  std::vector<int> missing;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!IsAtTarget(round, i, HasTwoStreams(settings))) missing.push_back(parts[i]);
  std::ranges::sort(missing);
  const auto repeated = std::ranges::unique(missing);
  missing.erase(repeated.begin(), repeated.end());
  return missing;
}

RenderState ForPartFile(RenderState&& state) {
  RenderState kept = std::move(state);
  kept.passes.clear();
  kept.differences = {};
  return kept;
}

RenderState WithoutSamples(RenderState&& state, const Film& film) {
  RenderState kept = std::move(state);
  kept.rays = {};
  for (int i = 0; i < film.Blocks(); ++i) kept.blocks[static_cast<std::size_t>(i)] = film[i];
  return kept;
}

}  // namespace ray
