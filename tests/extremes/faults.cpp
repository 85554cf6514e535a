// What goes wrong inside: an allocation that fails, wherever it is, and a thread that throws.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "tests/Draw.h"
#include "tests/Project.h"

namespace {

std::atomic<long> allocations_left = -1;  // until one fails; below 0: none does

bool Fails() { return allocations_left.load(std::memory_order_relaxed) >= 0 && allocations_left.fetch_sub(1) == 0; }

void* Allocate(std::size_t size, std::size_t alignment) {
  if (Fails()) return nullptr;
  // aligned_alloc takes whole multiples of the alignment.
  return std::aligned_alloc(alignment, (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment);
}

void* AllocateOrThrow(std::size_t size, std::size_t alignment) {
  if (void* memory = Allocate(size, alignment)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// Operators of the whole test program. The library's other operators call these; AddressSanitizer's would not, so that
// what std::stable_sort allocates without exceptions is allocated here. Operators that free memory are not inlined: in
// their callers g++ 12 would warn that std::free gets what a function of another name returned.
void* operator new(std::size_t size) { return AllocateOrThrow(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return AllocateOrThrow(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return Allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace {

const std::string scene_text =
    "camera 0 2 6  0 -.3 -1  0 1 0  .5  .1 100\nbackground .3 .4 .5\narea_light 1 1 1  0 4 1  0 -1 0  1  1 0 0\n"
    "material 0 0 0  .8 .8 .8  .2 .2 .2  .1 .1 .1  0 0 0  9 1.5 0\n"
    "begin 0  1 0 0 0  0 2 0 0  0 0 1 0  0 0 0 1  box 0  -4 -.1 -4  4 0 4  end\nsphere 0  0 .8 0  .8\n"
    "tri 0  0 0 1  1 0 1  0 1 1\ncone 0  -2 1 0  1 2\n";

/// From the text to the picture.
R2::Image Picture(const char* accelerator, ray::RenderMode mode) {
  const project::Stage stage(project::FromText(scene_text));
  ray::RenderSettings settings = project::Sized(10, 9);
  settings.samples = 2;
  settings.mode = mode;
  settings.threads = 1;
  settings.budget.error = ray::ErrorTarget{1e-9};  // with all that measures errors
  return project::Render(stage, settings, {accelerator}).image;
}

TEST(Extremes, L7_AnyFailedAllocationIsAnErrorWithoutLeaks) {
  // The library of threads keeps what it allocates in its first run.
  for (const char* accelerator : {"graph", "grid", "octree", "bvh"})
    for (const auto mode : {ray::RenderMode::whitted, ray::RenderMode::path}) {
      const R2::Image whole = Picture(accelerator, mode);
      const int step = Count(7, 1);
      int failures = 0;
      for (long n = 0;; n += step) {
        bool is_error = false;
        R2::Image picture;
        allocations_left = n;
        try {
          picture = Picture(accelerator, mode);
        } catch (const std::bad_alloc&) {
          is_error = true;
        } catch (const std::exception&) {  // one that was worded for the user
          is_error = true;
        }
        const bool has_failed = allocations_left < 0;
        allocations_left = -1;
        failures += is_error;
        EXPECT_TRUE(is_error || picture == whole) << accelerator << ": allocation " << n;
        if (!has_failed) break;
      }
      EXPECT_GT(failures, 50 / step) << accelerator;
    }
}

/// Throws at one pixel, of which every thread has some.
class Faulty : public ray::Integrator {
 public:
  void Li(std::span<const ray::CameraSample> samples, std::span<R2::Color> radiances, ray::TraceState&) const override {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (static_cast<int>(samples[i].x) % 40 == 33) throw std::runtime_error("a planted fault");
      radiances[i] = {1, 1, 1};
    }
  }
};

TEST(Extremes, L8_AThreadThatThrowsEndsTheRenderWithItsMessage) {
  const project::Stage stage(project::FromText(scene_text));
  ray::RenderSettings settings = project::Sized(120);
  settings.tile_size = 8;
  for (const int threads : {1, 2, 7}) {
    settings.threads = threads;
    try {
      ray::Render(stage.world, Faulty(), settings);
      ADD_FAILURE() << "nothing was thrown on " << threads << " threads";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "a planted fault");
    }
  }
}

}  // namespace
