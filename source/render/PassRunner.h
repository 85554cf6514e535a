#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "source/integrate/RayCounts.h"
#include "source/render/RenderBlock.h"
#include "source/render/Schedule.h"
#include "source/render/Tiles.h"

namespace ray {

/// The inputs and listeners of passes. All must outlive them.
struct PassWork {
  const SampleSource& source;
  Film& film;
  bool has_two_streams = false;
  int threads = 0, tile_size = 0;           // as in RenderSettings
  const std::atomic<bool>* stop = nullptr;  // checked before every few rays; may be null
  /// Called after each tile, by one thread at a time, with the pixels at their targets and the rays of all passes. May
  /// be empty.
  std::function<void(std::int64_t pixels, const RayCounts& rays)> tile_done;
  std::vector<bool> left_alone{};  // blocks of other parts; empty if all are rendered
  /// Called with the blocks that reached their targets, each once in a Run, by one thread at a time. May be empty;
  /// otherwise blocks begin in rows from the bottom.
  std::function<void(std::span<const int> blocks)> blocks_done{};
};

/// Takes the samples that the blocks of a film are due, in tiles distributed to threads. The film is the same, bit for
/// bit, for any thread count and tile size, and however often a pass is interrupted and resumed.
class PassRunner {
 public:
  using Clock = std::chrono::steady_clock;
  enum class End { complete, paused, stopped };

  explicit PassRunner(const PassWork& work);

  /// Takes samples until each block has its target. Returns at once after a stop request, or at `pause_at` if there is
  /// any progress, and enough first looks for an image. In both cases the film can be saved and resumed.
  End Run(const PassTargets& targets, std::optional<Clock::time_point> pause_at);

  /// Returns true if samples up to this number are added up in the same way for any larger number of planned samples
  /// and any filter.
  static bool IsStepEnd(std::uint32_t samples);

  /// The rays of all passes whose samples the film contains, so that an interrupted render counts the same rays as an
  /// uninterrupted one.
  RayCounts Rays() const {
    RayCounts rays = rays_;
    return rays += rays_of_looks_;
  }
  bool IsLeftAlone(int block) const {
    return !work_.left_alone.empty() && work_.left_alone[static_cast<std::size_t>(block)];
  }
  /// Adds the rays that were traced before an interruption.
  ///   of_looks   true if no pixel had a whole sample
  void AddRays(const RayCounts& rays, bool of_looks) { (of_looks ? rays_of_looks_ : rays_) += rays; }

 private:
  /// Returns true if the samples of a tile's blocks are taken together.
  bool SharesLight() const { return work_.film.Together() > 1; }
  bool IsStopped() const { return work_.stop && work_.stop->load(std::memory_order_relaxed); }
  /// Returns the time at which tracing ends; std::nullopt until there is an image to show.
  std::optional<Clock::time_point> Deadline() const;
  bool IsPauseDue() const {
    const auto deadline = Deadline();
    return deadline && Clock::now() >= *deadline;
  }
  std::uint32_t TargetOf(int block) const { return targets_->samples[static_cast<std::size_t>(block)]; }
  std::uint32_t SamplesOf(int block) const { return work_.film[block].SamplesPerStream(work_.has_two_streams); }
  bool IsAtTarget(int block) const;
  bool IsDone(int block) const { return IsLeftAlone(block) || IsAtTarget(block); }
  bool AreAtTarget(std::span<const int> blocks) const {
    return std::ranges::all_of(blocks, [this](int block) { return IsAtTarget(block); });
  }
  void RunTile(int i);
  /// The working memory of a thread, kept between blocks.
  struct Worker {
    TraceState state;
    SampleBatch batch;
  };
  int NextTile(int i);
  std::vector<std::span<const int>> WorkOf(std::span<const int> blocks) const;
  bool Advance(std::span<const int> blocks, Worker& worker);
  bool TakeSamples(std::span<const int> blocks, std::span<Film::Block> next, int part, std::uint32_t end,
                   Worker& worker);
  bool Look(int block, Worker& worker);

  const PassWork work_;
  const Tiles tiles_;
  const int threads_;
  const PassTargets* targets_ = nullptr;
  std::optional<Clock::time_point> pause_at_;
  // Steps of blocks since Run began, and the number required before it may pause.
  std::atomic<int> progress_ = 0;
  int least_progress_ = 1;
  std::atomic<int> tiles_started_ = 0;  // since Run began
  tbb::enumerable_thread_specific<Worker> workers_;
  std::mutex mutex_;  // guards the counts below and tile_done; a block belongs to one tile and needs no guard
  std::int64_t pixels_done_ = 0;  // at their targets
  RayCounts rays_;
  RayCounts rays_of_looks_;  // until their samples, if pixels share light, are taken again
};

}  // namespace ray
