#include "source/render/PassRunner.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>

#include "source/render/Threads.h"

namespace ray {
namespace {

constexpr int least_looks = 512;            // number of blocks looked at before a pause
constexpr std::uint32_t most_at_once = 64;  // samples per pixel between two states of a block that can be saved

/// Returns the end of the step that begins with `done` samples. It depends on nothing else, so that a block is added up
/// in the same order whether it reached its target in one pass or in several.
std::uint32_t StepEnd(std::uint32_t done) {
  return done < most_at_once ? std::bit_ceil(done + 1) : (done / most_at_once + 1) * most_at_once;
}

/// Balances the parts of a block with one stream: the second part contains the samples since the last power of two.
void MergeParts(Film::Block& block) {
  block.sums[0] += block.sums[1];
  block.samples[0] += block.samples[1];
  block.sums[1] = {};
  block.samples[1] = 0;
}

}  // namespace

PassRunner::PassRunner(const PassWork& work)
    : work_(work),
      tiles_(work.film, SharesLight() ? work.film.Together() * Film::block_side : work.tile_size),
      threads_(ThreadsFor(work.threads)) {}

bool PassRunner::IsStepEnd(std::uint32_t samples) { return samples == 0 || StepEnd(samples - 1) == samples; }

bool PassRunner::IsAtTarget(int block) const {
  const std::uint32_t samples = SamplesOf(block), target = TargetOf(block);
  if (target > 0 || samples > 0) return samples >= target;
  return work_.film[block].first_samples.size() >= static_cast<std::size_t>(targets_->PlacesOf(block));
}

PassRunner::End PassRunner::Run(const PassTargets& targets, std::optional<Clock::time_point> pause_at) {
  targets_ = &targets;
  pause_at_ = pause_at;
  progress_ = tiles_started_ = 0;
  least_progress_ = targets.places.empty() ? 1 : least_looks;
  pixels_done_ = 0;
  std::vector<int> done;
  for (int i = 0; i < work_.film.Blocks(); ++i)
    if (IsDone(i)) pixels_done_ += work_.film.PixelsOf(i).Area(), done.push_back(i);
  if (work_.blocks_done) work_.blocks_done(done);
  ForEachOnThreads(threads_, tiles_.Count(), [&](int i) { RunTile(i); });
  if (pixels_done_ == work_.film.Sampled().Area()) return End::complete;
  return IsStopped() ? End::stopped : End::paused;
}

/// Returns the tile to render when the i-th one begins. First looks are spread over the whole image, so that an
/// interrupted pass shows all of it, whichever thread came first; listeners for rows get them in order.
int PassRunner::NextTile(int i) {
  if (!targets_->places.empty()) return tiles_.Spread(tiles_started_++);
  return work_.blocks_done ? tiles_started_++ : i;
}

// Rays that take milliseconds must not delay the end of a render: after half a second any progress suffices.
std::optional<PassRunner::Clock::time_point> PassRunner::Deadline() const {
  constexpr auto patience = std::chrono::milliseconds(500);
  if (!pause_at_ || progress_ == 0) return {};
  return progress_ >= least_progress_ ? *pause_at_ : *pause_at_ + patience;
}

void PassRunner::RunTile(int i) {
  if (IsStopped() || IsPauseDue()) return;
  Worker& worker = workers_.local();
  TraceState& state = worker.state;
  state.rays = {};
  state.stop = work_.stop;
  std::int64_t pixels = 0;
  std::vector<int> done;
  std::vector<int> due = tiles_.BlocksOf(NextTile(i));
  std::erase_if(due, [this](int block) { return IsDone(block); });
  for (const std::span<const int> blocks : WorkOf(due)) {
    if (!(TargetOf(blocks[0]) > 0 ? Advance(blocks, worker) : Look(blocks[0], worker))) break;
    for (const int block : blocks) pixels += work_.film.PixelsOf(block).Area();
    done.insert(done.end(), blocks.begin(), blocks.end());
  }
  const std::lock_guard lock(mutex_);
  if (targets_->places.empty()) {
    rays_ += state.rays;
    if (SharesLight()) rays_of_looks_ = {};
  } else {
    rays_of_looks_ += state.rays;
  }
  pixels_done_ += pixels;
  // A callback may compute an image on many threads. While this thread waits for them, it must not start another tile,
  // which would wait for the lock that this thread holds.
  tbb::this_task_arena::isolate([&] {
    if (work_.blocks_done && !done.empty()) work_.blocks_done(done);
    if (work_.tile_done) work_.tile_done(pixels_done_, Rays());
  });
}

/// Divides the blocks of a tile into those that are worked on together.
std::vector<std::span<const int>> PassRunner::WorkOf(std::span<const int> blocks) const {
  std::vector<std::span<const int>> work;
  const bool together = SharesLight() && !blocks.empty() && TargetOf(blocks[0]) > 0;
  const std::size_t each = together ? blocks.size() : 1;
  for (std::size_t i = 0; i < blocks.size(); i += each) work.push_back(blocks.subspan(i, each));
  return work;
}

/// Takes blocks to their targets, or to the largest of these if their paths share light, in steps after which they can
/// be saved. Returns true if they reached them.
bool PassRunner::Advance(std::span<const int> blocks, Worker& worker) {
  TraceState& state = worker.state;
  state.workspace.ForgetLastHits();
  while (!AreAtTarget(blocks)) {
    if (IsPauseDue()) return false;
    state.deadline = Deadline();
    const R3::SearchLimit limit(state.stop, state.deadline);
    const std::uint32_t done = SamplesOf(blocks[0]);
    const std::uint32_t end = SharesLight() ? done + 1 : std::min(TargetOf(blocks[0]), StepEnd(done));
    std::vector<Film::Block> next;
    for (const int block : blocks) next.push_back(work_.film[block]);
    const RayCounts rays_before = state.rays;
    for (int part = 0; part < Film::parts; ++part) {
      if (!work_.has_two_streams && part != (done == 0 ? 0 : 1)) continue;
      if (!TakeSamples(blocks, next, part, end, worker)) {
        state.rays = rays_before;
        return false;
      }
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      next[i].first_samples.clear();
      work_.film[blocks[i]] = std::move(next[i]);
    }
    ++progress_;
  }
  return true;
}

/// Adds the samples before `end` to one part of `blocks`, of which `next` are copies. First samples that share light
/// are taken again.
bool PassRunner::TakeSamples(std::span<const int> blocks, std::span<Film::Block> next, int part, std::uint32_t end,
                             Worker& worker) {
  const std::uint32_t done = SamplesOf(blocks[0]);
  const int stream = work_.has_two_streams ? part : 0;
  std::vector<PixelRectangle> pixels;
  std::vector<BlockSums*> sums;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!work_.has_two_streams && std::has_single_bit(done)) MergeParts(next[i]);
    if (next[i].sums[part].IsEmpty()) next[i].sums[part] = work_.film.EmptySums(blocks[i]);
    next[i].samples[part] += end - done;
    pixels.push_back(work_.film.PixelsOf(blocks[i]));
    sums.push_back(&next[i].sums[part]);
  }
  if (SharesLight())
    return RenderTogether(work_.source, pixels, stream, done, work_.film.filter(), worker.state, worker.batch, sums);
  SamplesDue due{pixels[0], stream, done, end};
  if (part == 0) due.first_samples = next[0].first_samples;
  return RenderBlock(work_.source, due, work_.film.filter(), worker.state, worker.batch, *sums[0]);
}

/// Takes a block within its first sample to its target. Returns true if it reached the target.
bool PassRunner::Look(int block, Worker& worker) {
  TraceState& state = worker.state;
  state.workspace.ForgetLastHits();
  const RayCounts rays_before = state.rays;
  state.deadline = Deadline();
  const R3::SearchLimit limit(state.stop, state.deadline);
  if (!LookAtPlaces(work_.source, work_.film.PixelsOf(block), targets_->PlacesOf(block), state, worker.batch,
                    work_.film[block].first_samples)) {
    state.rays = rays_before;
    return false;
  }
  ++progress_;
  return true;
}

}  // namespace ray
