#include "source/film/denoise/DenoiseFilters.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "source/app/Status.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/RenderChecks.h"
#include "tests/source/app/Place.h"

namespace ray {
namespace {

using testing::Finished;
using testing::Has;
using testing::List;
using testing::Place;
using testing::ReadFile;
using testing::RunProgram;
using testing::With;
using testing::WriteFile;

RenderOptions OptionsOfDenoiser(const List& more) {
  return ReadCommandLine(Program::raypro, With({"in.scn", "out.ppm"}, more));
}

TEST(Denoiser, IsOursByDefaultAndAutoIsResolvedBeforeRendering) {
  EXPECT_EQ(OptionsOfDenoiser({"-denoise", "-samples", "4"}).render.denoiser, Denoiser::regression);
  RenderOptions options = OptionsOfDenoiser({"-denoise", "-samples", "4", "-denoiser", "auto"});
  CompleteForScene(options);
  EXPECT_EQ(options.render.denoiser, OpenImageDenoise::IsPresent() ? Denoiser::both : Denoiser::regression);
}

TEST(Denoiser, ThatIsMissingIsReportedBeforeTheFirstRay) {
  NEEDS_THE_PROGRAM();
  if (OpenImageDenoise::IsPresent()) GTEST_SKIP() << "this machine has Open Image Denoise";
  const Place place;
  for (const char* name : {"oidn", "both"}) {
    const Finished run = place.Run("a.png", {"-samples", "4", "-denoise", "-denoiser", name});
    EXPECT_EQ(run.status, status::wrong_arguments);
    EXPECT_TRUE(Has(run.error, "-denoiser " + std::string(name) + ": Open Image Denoise is not installed"))
        << run.error;
    EXPECT_FALSE(std::filesystem::exists(place / "a.png"));
  }
  EXPECT_EQ(place.Run("a.pfm", {"-samples", "4", "-denoise", "-denoiser", "auto"}).status, status::done);
  EXPECT_EQ(place.Run("b.pfm", {"-samples", "4", "-denoise"}).status, status::done);
  EXPECT_TRUE(ReadFile(place / "a.pfm") == ReadFile(place / "b.pfm"));
}

// Some other library in its place is refused for what it lacks, so it has been loaded.
TEST(Denoiser, OfThePythonPackageIsFound) {
  NEEDS_THE_PROGRAM();
  if (OpenImageDenoise::IsPresent()) GTEST_SKIP() << "this machine has Open Image Denoise";
  Dl_info info{};
  ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, "jpeg_std_error"), &info), 0);
  const Place place;
  const std::filesystem::path folder = place / "lib/python3.11/site-packages/pyoidn/oidn/lib";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(info.dli_fname, folder / "libOpenImageDenoise.so.2");
  const List words{place.Scene(), place / "a.png", "-samples", "4", "-denoise", "-denoiser", "both"};
  const Finished run = RunProgram(words, {.environment = {{"VIRTUAL_ENV", std::string(place / ".")}}});
  EXPECT_TRUE(Has(run.error, "the installed Open Image Denoise has no function oidnNewDevice")) << run.error;
}

TEST(Denoiser, WithoutDenoisingIsWarnedOfAndNotLoaded) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished run = place.Run("a.png", {"-denoiser", "oidn"});
  EXPECT_EQ(run.status, status::done);
  EXPECT_TRUE(Has(run.error, "-denoiser has no effect without -denoise")) << run.error;
  EXPECT_FALSE(Has(ReadFile(place / "a.png"), "denoised_by")) << "nothing has";
}

// Only its name explains why the same command made another image on another machine.
TEST(Denoiser, OfALibraryIsRecordedAndRequiredByReplay) {
  NEEDS_THE_PROGRAM();
  if (!OpenImageDenoise::IsPresent()) GTEST_SKIP() << "this machine has no Open Image Denoise";
  const Place place;
  const List settings{"-denoise", "-denoiser", "oidn"};
  const Finished run = RunProgram(With({place.Scene(), place / "a.png", "-width", "40", "-height", "30"},
                                       With(settings, {"-samples", "4", "-report", place / "r.json"})));
  const std::string name = DenoiseFilters(Denoiser::oidn).Name();
  EXPECT_TRUE(Has(run.output, " denoised by " + name + ", ")) << run.output << run.error;
  EXPECT_TRUE(Has(ReadFile(place / "a.png"), name));
  std::string report = ReadFile(place / "r.json");
  ASSERT_TRUE(Has(report, "\"denoised_by\": \"" + name + "\"")) << report;
  EXPECT_EQ(place.Run("b.png", With(settings, {"-replay", place / "r.json"})).status, status::done);
  report.replace(report.find(name), name.size(), "Open Image Denoise 1.2.3");
  WriteFile(place / "other.json", report);
  const Finished other = place.Run("b.png", With(settings, {"-replay", place / "other.json"}));
  EXPECT_TRUE(Has(other.error, "the report was made with \"Open Image Denoise 1.2.3\", not '" + name + "'"))
      << other.error;
}

}  // namespace
}  // namespace ray
