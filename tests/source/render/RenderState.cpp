#include "source/render/RenderState.h"

#include <gtest/gtest.h>

#include <cstring>
#include <new>

#include "source/render/Render.h"

namespace ray {
namespace {

/// Creates a state in memory whose bytes were all `filling`.
struct PassIn {
  alignas(Pass) unsigned char bytes[sizeof(Pass)];
  explicit PassIn(int filling) { std::memset(bytes, filling, sizeof bytes); }

  Pass& Make() {
    Pass& pass = *new (bytes) Pass;
    pass.error.emplace();
    pass.error->estimate = 3;
    pass.error->worst_block_at = {8, 16, 24, 32};
    return pass;
  }
};

std::vector<unsigned char> BytesOf(const RenderSettings& settings, int filling) {
  PassIn memory(filling);
  RenderState state;
  const Film film = EmptyFilmOf(settings);
  for (int i = 0; i < film.Blocks(); ++i) state.blocks.push_back(film[i]);
  state.schedule.targets.samples.assign(state.blocks.size(), 4);
  state.passes.push_back(memory.Make());
  return Encoded(state, "x");
}

// Equal states once gave different checkpoints, since the padding between the fields of an error was written.
TEST(RenderState, CheckpointsContainOnlyTheState) {
  const RenderSettings settings;
  EXPECT_TRUE(BytesOf(settings, 0x00) == BytesOf(settings, 0xff));
}

TEST(RenderState, AnErrorComesBackFromACheckpointFieldByField) {
  const RenderSettings settings;
  const Film film = EmptyFilmOf(settings);
  RenderState state;
  for (int i = 0; i < film.Blocks(); ++i) state.blocks.push_back(film[i]);
  state.schedule.targets.samples.assign(state.blocks.size(), 4);
  const ErrorEstimate error{ErrorUnit::linear, 1, 2, 3, 4, {5, 6, 7, 8}, 9, 10};
  state.passes = {{1, 2, 3, error}, {4, 5, 6, {}}};
  const std::vector<Pass> passes = DecodedState(Encoded(state, "x"), "x", film).passes;
  ASSERT_EQ(passes.size(), 2u);
  ASSERT_TRUE(passes[0].error);
  EXPECT_EQ(passes[0].error->unit, error.unit);
  EXPECT_EQ(passes[0].error->estimate, error.estimate);
  EXPECT_EQ(passes[0].error->low, error.low);
  EXPECT_EQ(passes[0].error->high, error.high);
  EXPECT_EQ(passes[0].error->worst_block, error.worst_block);
  EXPECT_EQ(passes[0].error->worst_block_at, error.worst_block_at);
  EXPECT_EQ(passes[0].error->outlier_share, error.outlier_share);
  EXPECT_EQ(passes[0].error->freedom, error.freedom);
  EXPECT_FALSE(passes[1].error);
  EXPECT_EQ(passes[1].end, 4u);
}

}  // namespace
}  // namespace ray
