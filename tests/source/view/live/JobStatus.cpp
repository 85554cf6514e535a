#include "source/view/live/JobStatus.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/source/view/live/Gate.h"

namespace ray {
namespace {

using Order = RenderJob::Order;

RenderSettings Small() {
  RenderSettings settings;
  settings.width = settings.height = 16;
  settings.threads = 1;
  settings.mode = RenderMode::depth;  // one ray a pixel
  return settings;
}

bool Begins(const std::string& text, const std::string& with) { return text.starts_with(with); }
bool Contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(JobStatus, TellsTheClaimWithItsIntervalAndTheSamples) {
  RenderResult result;
  result.samples.mean = 64;
  EXPECT_EQ(ClaimOf(result), "64 samples");
  ErrorEstimate error;
  error.estimate = 1.8;
  error.low = 1.7;
  error.high = 1.9;
  result.error = error;
  result.two_streams = true;
  EXPECT_EQ(ClaimOf(result), "estimated error 1.8/255 (1.7 to 1.9), 64 samples");
  result.two_streams = false;  // then the two halves are not independent
  EXPECT_EQ(ClaimOf(result), "estimated error at most 1.8/255 (1.7 to 1.9), 64 samples");
}

TEST(JobStatus, TellsSamplesPercentAndTimeLeftIfKnown) {
  RenderSettings settings = Small();
  settings.samples = 8;
  const testing::Gated gated(16 * 16 * 2);
  RenderJob job(gated.scene, settings, Order::coarse_first);
  while (job.Samples() != 2 || gated.gate->Waiting() == 0) std::this_thread::yield();
  EXPECT_TRUE(Begins(StatusOf(job), "2 of 8 samples 25 % ")) << StatusOf(job);
  EXPECT_TRUE(Contains(StatusOf(job), " Mrays/s ")) << StatusOf(job);
  EXPECT_TRUE(StatusOf(job).ends_with(" s left")) << StatusOf(job);
  gated.gate->Open(1 << 20);
  while (!job.HasEnded()) std::this_thread::yield();
  EXPECT_TRUE(Begins(StatusOf(job), "8 samples ")) << StatusOf(job);
  EXPECT_TRUE(StatusOf(job).ends_with(" Mrays/s")) << StatusOf(job);
}

TEST(JobStatus, OfRowsNamesTheRow) {
  const testing::Gated gated(16 * 8);  // a row of blocks
  RenderJob job(gated.scene, Small(), Order::rows);
  while (job.RowsDone() != 8 || gated.gate->Waiting() == 0) std::this_thread::yield();
  EXPECT_TRUE(Begins(StatusOf(job), "row 8 of 16 50 % ")) << StatusOf(job);
  gated.gate->Open(1 << 20);
}

}  // namespace
}  // namespace ray
