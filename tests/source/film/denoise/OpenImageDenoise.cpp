#include "source/film/denoise/OpenImageDenoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "source/film/denoise/Denoise.h"
#include "source/sample/Random.h"
#include "tests/Folder.h"

namespace ray {
namespace {

constexpr int extent = 40;

/// A fake library, for behavior that no real one can be made to have. Its filters return `factor` times the color.
struct FakeLibrary {
  std::set<std::string> missing;
  bool has_former_names = false, has_device = true;
  std::string fault;  // answer to each query for errors
  float factor = 1;
  std::map<std::string, int> device_settings;
  std::set<std::string> filter_settings;
  std::map<std::string, float*> images;
  int devices = 0, filters = 0;  // created and not released
};
FakeLibrary fake;

void* NewDevice(int) { return fake.has_device ? (++fake.devices, &fake) : nullptr; }
void ReleaseDevice(void*) { --fake.devices; }
void SetDeviceBool(void*, const char* name, bool value) { fake.device_settings[name] = value; }
void SetDeviceInt(void*, const char* name, int value) { fake.device_settings[name] = value; }
int GetDeviceInt(void*, const char* name) { return name == std::string("versionMajor") ? 9 : 0; }
int GetDeviceError(void*, const char** message) {
  *message = fake.fault.c_str();
  return fake.fault.empty() ? 0 : 4;
}
void Commit(void*) {}
void* NewFilter(void*, const char*) { return ++fake.filters, &fake; }
void ReleaseFilter(void*) { --fake.filters; }
void SetSharedFilterImage(void*, const char* name, void* pixels, int, std::size_t, std::size_t, std::size_t,
                          std::size_t, std::size_t) {
  fake.images[name] = static_cast<float*>(pixels);
}
void SetFilterBool(void*, const char* name, bool) { fake.filter_settings.insert(name); }
void ExecuteFilter(void*) {
  for (int i = 0; i < 3 * extent * extent; ++i) fake.images["output"][i] = fake.factor * fake.images["color"][i];
}

template <typename Function>
void* Address(Function* function) {
  return reinterpret_cast<void*>(function);
}

void* FindInFake(const char* name) {
  const std::map<std::string, void*> now{{"oidnSetDeviceBool", Address(SetDeviceBool)},
                                         {"oidnSetDeviceInt", Address(SetDeviceInt)},
                                         {"oidnGetDeviceInt", Address(GetDeviceInt)},
                                         {"oidnSetFilterBool", Address(SetFilterBool)}};
  const std::map<std::string, void*> formerly{{"oidnSetDevice1b", Address(SetDeviceBool)},
                                              {"oidnSetDevice1i", Address(SetDeviceInt)},
                                              {"oidnGetDevice1i", Address(GetDeviceInt)},
                                              {"oidnSetFilter1b", Address(SetFilterBool)}};
  std::map<std::string, void*> all{{"oidnNewDevice", Address(NewDevice)},
                                   {"oidnReleaseDevice", Address(ReleaseDevice)},
                                   {"oidnGetDeviceError", Address(GetDeviceError)},
                                   {"oidnCommitDevice", Address(Commit)},
                                   {"oidnNewFilter", Address(NewFilter)},
                                   {"oidnReleaseFilter", Address(ReleaseFilter)},
                                   {"oidnSetSharedFilterImage", Address(SetSharedFilterImage)},
                                   {"oidnCommitFilter", Address(Commit)},
                                   {"oidnExecuteFilter", Address(ExecuteFilter)}};
  all.merge(std::map(fake.has_former_names ? formerly : now));
  return fake.missing.contains(name) || !all.contains(name) ? nullptr : all.at(name);
}

std::string FaultOfLoading() {
  return project::MessageOf<DenoiserError>([] { OpenImageDenoise(FindInFake, 0); });
}

/// Gray with even noise.
Pixels<Rgb> NoisyGray(std::uint64_t seed) {
  Pixels<Rgb> pixels(extent, extent);
  for (int y = 0; y < extent; ++y)
    for (int x = 0; x < extent; ++x)
      for (std::uint64_t k = 0; k < 3; ++k) {
        const RandomKey key = RandomKey(seed).Child(static_cast<std::uint64_t>(extent * y + x)).Child(k);
        pixels.At(x, y)[k] = static_cast<float>(0.5 + 0.2 * (key.Number() - 0.5));
      }
  return pixels;
}

Guides BlankGuides() {
  Guides guides;
  for (auto* set : {guides.of_stream, guides.best}) set[0] = set[1] = Pixels<PixelGuide>(extent, extent);
  return guides;
}

double Deviation(const Pixels<Rgb>& pixels) {
  double sum = 0;
  for (int y = 0; y < extent; ++y)
    for (int x = 0; x < extent; ++x)
      for (const float channel : pixels.At(x, y)) sum += std::pow(channel - 0.5, 2);
  return std::sqrt(sum / (3 * extent * extent));
}

class OpenImageDenoiseOf : public testing::Test {
 protected:
  void SetUp() override { fake = {}; }

  static DenoisedImage Denoised() {
    return Denoise(ImageOf(NoisyGray(1)), ImageOf(NoisyGray(2)), BlankGuides(),
                   DenoiseFilters(false, std::make_unique<OpenImageDenoise>(FindInFake, 0)));
  }
};

class InstalledOpenImageDenoise : public testing::Test {
 protected:
  void SetUp() override {
    if (!OpenImageDenoise::IsPresent()) GTEST_SKIP() << "this machine has no Open Image Denoise";
  }
};

TEST_F(OpenImageDenoiseOf, AVersionWithoutAFunctionIsRefusedByName) {
  for (const char* name : {"oidnNewDevice", "oidnSetFilterBool", "oidnExecuteFilter"}) {
    fake.missing = {name};
    EXPECT_EQ(FaultOfLoading(), "the installed Open Image Denoise has no function " + std::string(name));
    EXPECT_EQ(fake.devices, 0);
  }
}

TEST_F(OpenImageDenoiseOf, Version1WorksByItsFunctionNames) {
  fake.has_former_names = true;
  EXPECT_EQ(FaultOfLoading(), "");
}

TEST_F(OpenImageDenoiseOf, AnUnsupportedMachineReportsTheLibrarysError) {
  fake.has_device = false;
  EXPECT_EQ(FaultOfLoading(), "Open Image Denoise: no device");
  fake.fault = "unsupported CPU";
  EXPECT_EQ(FaultOfLoading(), "Open Image Denoise: unsupported CPU");
  fake.has_device = true;
  EXPECT_EQ(FaultOfLoading(), "Open Image Denoise: unsupported CPU");
  EXPECT_EQ(fake.devices, 0);
}

TEST_F(OpenImageDenoiseOf, AFailingFilterIsReportedAndReleased) {
  {
    const OpenImageDenoise library(FindInFake, 0);
    fake.fault = "out of memory";
    EXPECT_EQ(project::MessageOf<DenoiserError>([&] { library.Filtered(NoisyGray(1), BlankGuides().best[0]); }),
              "Open Image Denoise: out of memory");
  }
  EXPECT_EQ(std::pair(fake.devices, fake.filters), std::pair(0, 0));
}

TEST_F(OpenImageDenoiseOf, RunsOnTheRequestedThreadsAndPinsNone) {
  const OpenImageDenoise library(FindInFake, 3);
  EXPECT_EQ(fake.device_settings.at("numThreads"), 3);
  EXPECT_EQ(fake.device_settings.at("setAffinity"), 0);
}

TEST_F(OpenImageDenoiseOf, GetsHdrLightAndCleanGuides) {
  OpenImageDenoise(FindInFake, 0).Filtered(NoisyGray(1), BlankGuides().best[0]);
  EXPECT_EQ(fake.filter_settings, (std::set<std::string>{"hdr", "cleanAux"}));
  EXPECT_TRUE(fake.images.contains("albedo") && fake.images.contains("normal"));
}

TEST_F(OpenImageDenoiseOf, ItsNameContainsItsVersion) {
  EXPECT_EQ(DenoiseFilters(false, std::make_unique<OpenImageDenoise>(FindInFake, 0)).Name(),
            "Open Image Denoise 9.0.0");
  EXPECT_EQ(DenoiseFilters(true, std::make_unique<OpenImageDenoise>(FindInFake, 0)).Name(),
            "regression and Open Image Denoise 9.0.0");
}

TEST_F(OpenImageDenoiseOf, AFilterThatChangesNothingChangesNoBit) {
  const DenoisedImage image = Denoised();
  EXPECT_TRUE(image.of_stream[0] == ImageOf(NoisyGray(1)));
  EXPECT_TRUE(image.of_stream[1] == ImageOf(NoisyGray(2)));
}

TEST_F(OpenImageDenoiseOf, AFilterThatMakesTheImageWorseIsNotUsed) {
  fake.factor = 0.3F;
  EXPECT_TRUE(Denoised().of_stream[0] == ImageOf(NoisyGray(1)));
}

TEST_F(OpenImageDenoiseOf, AMachineWithoutItFailsOnlyOnRequest) {
  if (OpenImageDenoise::IsPresent()) GTEST_SKIP() << "this machine has Open Image Denoise";
  EXPECT_EQ(Resolved(Denoiser::automatic), Denoiser::regression);
  EXPECT_NE(project::MessageOf<DenoiserError>([] { DenoiseFilters(Denoiser::oidn); }).find("libOpenImageDenoise.so.2"), std::string::npos);
  EXPECT_NE(project::MessageOf<DenoiserError>([] { DenoiseFilters(Denoiser::both); }).find("not installed"), std::string::npos);
}

// The effect of a trained filter can only be measured: version 2.5.1 leaves 1 / 7 of this noise.
TEST_F(InstalledOpenImageDenoise, NoiseOfAFlatSurfaceFallsByHalfAndMore) {
  const OpenImageDenoise library(0);
  EXPECT_LT(Deviation(library.Filtered(NoisyGray(1), BlankGuides().best[0])), 0.5 * Deviation(NoisyGray(1)));
}

TEST_F(InstalledOpenImageDenoise, NoBitDependsOnThreads) {
  const auto filtered = [](int threads) {
    return ImageOf(OpenImageDenoise(threads).Filtered(NoisyGray(1), BlankGuides().best[0]));
  };
  EXPECT_TRUE(filtered(1) == filtered(3));
}

TEST_F(InstalledOpenImageDenoise, AutomaticCombinesItWithRegression) {
  EXPECT_EQ(Resolved(Denoiser::automatic), Denoiser::both);
  EXPECT_EQ(DenoiseFilters(Denoiser::automatic).Name(), DenoiseFilters(Denoiser::both).Name());
}

}  // namespace
}  // namespace ray
