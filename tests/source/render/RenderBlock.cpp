#include "source/render/RenderBlock.h"

#include <gtest/gtest.h>
#include <signal.h>
#if defined(__x86_64__) && defined(__linux__)
#include <ucontext.h>
#include <x86intrin.h>
#endif

#include <algorithm>
#include <atomic>

#include "tests/Sanitizers.h"

namespace ray {
namespace {

#if defined(__x86_64__) && defined(__linux__)
constexpr bool can_step = true;
constexpr unsigned long long trap_flag = 0x100;  // a signal after each instruction

std::atomic<bool> asked_to_stop = false;
std::atomic<int> steps_left = 0;

void OnStep(int, siginfo_t*, void* context) {
  if (--steps_left > 0) return;
  asked_to_stop = true;
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_EFL] &= ~static_cast<greg_t>(trap_flag);
}

/// Has this thread asked to stop once it has executed so many further instructions.
void StopAfter(int instructions) {
  struct sigaction action = {};
  action.sa_sigaction = OnStep;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGTRAP, &action, nullptr);
  asked_to_stop = false;
  steps_left = instructions;
  __writeeflags(__readeflags() | trap_flag);
}

void StopStepping() {
  steps_left = 0;  // the next signal, if there is one, is the last
  signal(SIGTRAP, SIG_DFL);
}
#else
constexpr bool can_step = false;
std::atomic<bool> asked_to_stop = false;
void StopAfter(int) {}
void StopStepping() {}
#endif

/// Light of one color everywhere, whether or not anybody asks to stop.
class Uniform : public Integrator {
 public:
  void Li(std::span<const CameraSample>, std::span<R2::Color> radiances, TraceState&) const override {
    std::ranges::fill(radiances, R2::Color{1, 2, 3});
  }
};

// The viewer's threads once looked twice whether they were to stop, and where that was asked for in between they showed
// samples that nobody had made: they read behind the end of an array.
TEST(BatchTracer, GivesOnlyWhatWasTracedWheneverItIsToStop) {
  if (!can_step) GTEST_SKIP() << "only on x86 under Linux can a thread be interrupted after any instruction";
  const Uniform integrator;
  const CameraRays camera(Camera(), CameraEffects(), false, 8, 8, SamplerKind::sobol, 1);
  const SampleSource source{integrator, camera, RandomKey(1)};
  TraceState state;
  state.stop = &asked_to_stop;
  int given = 0, wrong = 0, broken_off = 0;
  const auto splat = [&](int, int, const CameraSample&, const R2::Color& radiance) {
    ++given;
    wrong += radiance != R2::Color{1, 2, 3};
  };
  // Instructions; the first look is among them, and so is the beginning of the tracing. ThreadSanitizer adds many.
  constexpr int most = project::has_thread_sanitizer ? 1200 : 120;
  for (int instructions = 1; instructions <= most; ++instructions) {
    BatchTracer tracer(source, state, splat);
    tracer.Add(source.FirstSample(3, 4));
    StopAfter(instructions);
    broken_off += !tracer.Finish();
    StopStepping();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(broken_off, most);
  EXPECT_GT(given, 0) << "where it was asked for after the look";
  EXPECT_LT(given, most) << "where it was asked for before";
}

}  // namespace
}  // namespace ray
