#include "source/app/report/Memory.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "source/accelerate/World.h"
#include "source/app/Status.h"
#include "source/app/report/Resources.h"
#include "tests/BlackPng.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

using List = std::vector<std::string>;

constexpr const char* scene =
    "camera 0 1 6  0 0 -1  0 1 0  0.3  0.1 100\nsphere -1  0 0 0  1\npoint_light 1 1 1 3 3 3 1 0 0\n";

struct Place : SceneFolder {
  Place() : SceneFolder(scene) {}
  Finished Run(const List& more) const { return RunProgram(With({Scene(), *this / "out.png", "-quiet"}, more)); }
};

std::int64_t PeakOf(const Place& place, const List& more) {
  List words{"-report", place / "r.json"};
  words.insert(words.end(), more.begin(), more.end());
  EXPECT_EQ(place.Run(words).status, 0);
  const std::string report = ReadFile(place / "r.json"), key = "\"peak_memory_bytes\": ";
  const std::size_t at = report.find(key);
  return at == std::string::npos ? 0 : std::strtoll(report.c_str() + at + key.size(), nullptr, 10);
}

/// A PNG of 1 bit per pixel, 16384x16384, in 32 KB; decoded it takes 3 GiB.
const std::string& Bomb() {
  static const std::string bytes = BlackPng(16384, 16384);
  return bytes;
}

TEST(Memory, TheLimitIsThreeQuartersOfTheMachineUnlessGiven) {
  EXPECT_LT(MemoryLimit(0), MachineMemory());
  EXPECT_GT(MemoryLimit(0), MachineMemory() / 2);
  EXPECT_EQ(MemoryLimit(1.5), std::int64_t{3} << 29);
}

TEST(Memory, ATinyLimitIsNotShownAsZero) {
  const Scene nothing;
  const World world(nothing);
  try {
    CheckMemory(world, ImageBytes({}, {}, false), 1e-8);
    FAIL() << "it was allowed";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("more than the limit of 10 bytes:"), std::string::npos) << error.what();
  }
}

// The system's own count of the process's memory is the oracle.
TEST(Extremes, K13_AnImageTakesNoMoreThanItsEstimate) {
  NEEDS_THE_PROGRAM();
  NEEDS_NO_SANITIZER("freed memory is kept, and every byte has shadow memory");
  const Place place;
  const std::int64_t none = PeakOf(place, {"-width", "8", "-height", "8"});
  for (const auto& [filter, kind] : {std::pair{"box", FilterKind::box}, {"lanczos", FilterKind::lanczos}}) {
    RenderSettings render;
    render.width = render.height = 1500;
    render.filter = kind;
    const List words{"-width", "1500", "-height", "1500", "-samples", "2", "-filter", filter};
    const std::int64_t estimate = ImageBytes(render, {}, false), measured = PeakOf(place, words) - none;
    EXPECT_LE(measured, estimate) << filter;
    EXPECT_GE(2 * measured, estimate) << filter;  // and the estimate refuses no more than necessary
  }
}

TEST(Extremes, K13_ExceedingTheMemoryLimitIsRefusedBeforeBuilding) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished large = place.Run({"-width", "4000", "-height", "4000", "-memory", "0.5"});
  EXPECT_EQ(large.status, 2);
  EXPECT_NE(large.error.find("more than the limit of 0.50 GiB"), std::string::npos) << large.error;
  EXPECT_EQ(place.Run({"-width", "40", "-height", "40", "-memory", "0.5"}).status, 0);
  std::string many = scene;
  for (int i = 0; i < 400'000; ++i) many += "sphere -1 " + std::to_string(i) + " 0 0 1\n";
  WriteFile(place / "in.scn", many);
  const Finished crowded = place.Run({"-width", "8", "-height", "8", "-memory", "0.3"});
  EXPECT_EQ(crowded.status, 2);
  EXPECT_NE(crowded.error.find("its structure may need 0.07 GiB"), std::string::npos) << crowded.error;
}

TEST(Extremes, K4_AnImageBombIsRefusedByItsHeader) {
  NEEDS_THE_PROGRAM();
  const Place place;
  WriteFile(place / "bomb.png", Bomb());
  WriteFile(place / "in.scn", std::string("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 bomb.png\n") + scene);
  const Finished texture = place.Run({"-memory", "0.5"});
  EXPECT_EQ(texture.status, 3);
  EXPECT_NE(texture.error.find("textures take 3072 MiB decoded, more than the limit of 512 MiB"), std::string::npos)
      << texture.error;
  WriteFile(place / "in.scn", scene);
  const Finished reference = place.Run({"-reference", place / "bomb.png", "-memory", "0.5"});
  EXPECT_EQ(reference.status, 2);
  EXPECT_NE(reference.error.find("is 16384x16384, the image 1024x1024"), std::string::npos) << reference.error;
  const Finished info = RunProgram({"-info", place / "bomb.png"});
  EXPECT_EQ(info.status, 0) << info.error;
  EXPECT_NE(info.output.find("png, 16384x16384"), std::string::npos) << info.output;
}

}  // namespace
}  // namespace ray::testing
