// Files left behind when an image cannot be written, or when nobody reads the output.
#include "source/app/files/Outputs.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <unistd.h>

#include <memory>
#include <random>
#include <thread>

#include "R2/ImageFile.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Whether a new file is being written beside the target.
bool IsSaving(const TemporaryFolder& folder, const std::vector<std::string>& old) {
  std::error_code error;
  for (const std::string& name : folder.Others(old))
    if (fs::file_size(folder / name, error) > 0 && !error) return true;
  return false;
}

TEST(Extremes, L1_AKilledRunLeavesTheOldOrTheNewImage) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place("");
  const std::vector<std::string> words{place.Scene(), place / "out.ppm", "-width", "700", "-height", "700", "-quiet"};
  ASSERT_EQ(RunProgram(words).status, 0);
  const std::string whole = ReadFile(place / "out.ppm");  // a .ppm does not contain its time
  const auto start = std::chrono::steady_clock::now();
  RunProgram(words);
  const double whole_run = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::mt19937 random(1);
  int killed = 0, killed_while_saving = 0;
  for (int round = 0; round < Rounds("RAYTESTS_KILLS", 40); ++round) {
    const bool has_old = round % 2 == 0;
    fs::remove(place / "out.ppm");
    if (has_old) WriteFile(place / "out.ppm", "old");
    std::vector<std::string> old = place.Others({"out.ppm"});  // including the files that the previous round left
    old.emplace_back("out.ppm");
    Running running(words);
    // Half of the rounds wait for the short time in which the image is being saved.
    while (round % 4 < 2 && !running.IsOver() && !IsSaving(place, old)) std::this_thread::sleep_for(50us);
    const double longest = round % 4 < 2 ? 0.002 : whole_run;
    std::this_thread::sleep_for(std::chrono::duration<double>(std::uniform_real_distribution(0.0, longest)(random)));
    running.Send(SIGKILL);
    const bool was_saving = IsSaving(place, old);
    killed += running.Wait().signal == SIGKILL;
    killed_while_saving += was_saving;
    const std::string now = ReadFile(place / "out.ppm");
    const bool is_old = has_old ? now == "old" : !fs::exists(place / "out.ppm");
    EXPECT_TRUE(is_old || now == whole) << "round " << round << ": " << now.size() << " bytes";
  }
  EXPECT_GT(killed, 0);
  std::printf("%d killed, %d of them while saving\n", killed, killed_while_saving);

  ASSERT_EQ(RunProgram(words).status, 0);
  EXPECT_EQ(place.Others({"in.scn", "out.ppm"}), nothing);
}

/// Returns the bytes that an image of the small scene needs in addition to the existing files.
constexpr long image_bytes = 3 * 64 * 64 + 13;
const std::vector<std::string> image_size{"-width", "64", "-height", "64"};

TEST(Extremes, L2_AFileSizeLimitAnywhereLeavesTheOldImageComplete) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const auto words = With({place.Scene(), place / "out.ppm", "-quiet"}, image_size);
  ASSERT_EQ(RunProgram(words).status, 0);
  const std::string whole = ReadFile(place / "out.ppm");
  ASSERT_EQ(static_cast<long>(whole.size()), image_bytes);
  WriteFile(place / "out.ppm", "old");
  for (int i = 0; i < 64; ++i) {
    const long limit =
        i < 62 ? 512 + (image_bytes - 512) * i / 62 : image_bytes - 63 + i;  // the last: all but one, all
    const Finished done =
        RunProgram(words, {.file_size_limit = limit, .environment = {{"TMPDIR", place.Path().string()}}});
    const bool fits = limit >= image_bytes;
    EXPECT_EQ(done.status, fits ? 0 : 4) << limit << done.error;
    EXPECT_EQ(ReadFile(place / "out.ppm"), fits ? whole : "old") << limit;
    EXPECT_TRUE(fits || Has(done.error, "File too large; nor can it be kept as")) << done.error;
    EXPECT_EQ(place.Others({"in.scn", "out.ppm"}), nothing) << limit;
  }
}

/// A file system of 1 MiB in memory.
class SmallDisk {
 public:
  explicit SmallDisk(const std::string& at) : at_(at) {
    fs::create_directory(at);
    is_mounted_ = mount("raytests", at.c_str(), "tmpfs", 0, "size=1m") == 0;
  }
  ~SmallDisk() {
    if (is_mounted_) umount(at_.c_str());
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool IsMounted() const { return is_mounted_; }
  long BytesFree() const { return static_cast<long>(fs::space(at_).available); }

 private:
  std::string at_;
  bool is_mounted_ = false;
};

TEST(Extremes, L2_AFullDiskKeepsTheOldImageAndSavesElsewhere) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const TemporaryFolder refuge;
  const SmallDisk disk(place / "disk");
  if (!disk.IsMounted())
    GTEST_SKIP() << "a small file system can be mounted by root only; the file size limit was tried";
  const auto words = With({place.Scene(), place / "disk/out.ppm", "-quiet"}, image_size);
  ASSERT_EQ(RunProgram(words).status, 0);
  const std::string whole = ReadFile(place / "disk/out.ppm");
  WriteFile(place / "disk/out.ppm", "old");
  const long page = sysconf(_SC_PAGESIZE), pages_needed = (image_bytes + page - 1) / page;
  for (int i = 0; i < 64; ++i) {
    const long pages_free = i % (2 * pages_needed);  // from none to twice the need
    fs::remove(place / "disk/filler");
    WriteFile(place / "disk/filler", std::string(static_cast<std::size_t>(disk.BytesFree() - pages_free * page), 'x'));
    const Finished done = RunProgram(words, {.environment = {{"TMPDIR", refuge.Path().string()}}});
    const bool fits = pages_free >= pages_needed;
    EXPECT_EQ(done.status, fits ? 0 : 4) << pages_free << done.error;
    EXPECT_EQ(ReadFile(place / "disk/out.ppm"), fits ? whole : "old") << pages_free;
    const auto kept = refuge.Others({});
    ASSERT_EQ(kept.size(), fits ? 0u : 1u) << done.error;
    if (fits) {
      WriteFile(place / "disk/out.ppm", "old");
    } else {
      EXPECT_EQ(ReadFile(refuge / kept[0]), whole);
      fs::remove(refuge / kept[0]);
    }
  }
}

TEST(Extremes, L6_WithoutAReaderTheImageIsStillWritten) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  // -stats was requested: it is a failure if it cannot be written, but not if its reader has left.
  const struct {
    Surroundings silence;
    int status;
  } cases[] = {
      {{.close_output = true}, 4},
      {{.close_error = true}, 0},
      {{.close_output = true, .close_error = true}, 4},
      {{.break_output = true}, 0},
      {{.standard_output = "/dev/full", .standard_error = "/dev/full"}, 4},
  };
  const auto words = With({place.Scene(), place / "out.ppm", "-stats", "-verbose"}, image_size);
  std::string first;
  for (const auto& [silence, status] : cases) {
    fs::remove(place / "out.ppm");
    const Finished done = RunProgram(words, silence);
    EXPECT_EQ(done.status, status);
    const std::string image = ReadFile(place / "out.ppm");
    if (first.empty()) first = image;
    EXPECT_EQ(static_cast<long>(image.size()), image_bytes);
    EXPECT_TRUE(image == first);  // no text of the messages went into it
  }
}

TEST(Extremes, K11_UnwritableStatisticsFailOnlyIfAskedFor) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const auto words = With({place.Scene(), place / "out.ppm"}, image_size);
  const Finished asked = RunProgram(With(words, {"-stats"}), {.standard_output = "/dev/full"});
  EXPECT_EQ(asked.status, 4);
  EXPECT_TRUE(Has(asked.error, "cannot write 'standard output': No space left on device")) << asked.error;
  EXPECT_EQ(static_cast<long>(ReadFile(place / "out.ppm").size()), image_bytes);
  EXPECT_EQ(RunProgram(words, {.standard_output = "/dev/full"}).status, 0);
}

// A script that closed standard output would take lost output for output that arrived.
TEST(Extremes, L6_ClosedStandardOutputIsAnErrorWheneverOutputGoesThere) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place;
  const std::string image = place / "out.ppm";
  ASSERT_EQ(RunProgram(With({place.Scene(), image, "-quiet"}, image_size)).status, 0);
  struct Case {
    const char* program;
    std::vector<std::string> words;
  };
  std::vector<Case> cases{
      {"RAYPRO", With({place.Scene(), "-"}, image_size)},
      {"RAYPRO", {place.Scene(), "-check"}},
      {"RAYPRO", {place.Scene(), "-advise"}},
      {"RAYPRO", {place.Scene(), "-debugpixel", "1", "1"}},
      {"RAYPRO", {"-info", image}},
      {"RAYPRO", {"-list", "shapes"}},
      {"RAYPRO", {"-complete", "bash"}},
      {"RAYIMG", {"info", image}},
      {"RAYIMG", {"diff", image, image}},
  };
  for (const char* program : {"RAYPRO", "RAYIMG", "RAYVIEW"})
    for (const char* word : {"-help", "-man", "-version"})
      if (ProgramName(program)) cases.push_back({program, {word}});
  for (const Case& one : cases) {
    const Finished open = RunProgram(one.words, {.program = one.program});
    EXPECT_EQ(open.status, 0) << one.program << " " << one.words[0] << open.error;
    const Finished closed = RunProgram(one.words, {.program = one.program, .close_output = true});
    EXPECT_EQ(closed.status, 4) << one.program << " " << one.words[0];
    EXPECT_TRUE(Has(closed.error, "cannot write 'standard output': Bad file descriptor")) << closed.error;
  }
}

TEST(Extremes, L10_ManyRunsWithOneOutputLeaveOneCompleteImage) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const auto words = With({place.Scene(), place / "out.ppm", "-quiet"}, image_size);
  RunProgram(words);
  const std::string whole = ReadFile(place / "out.ppm");
  std::vector<std::unique_ptr<Running>> all;
  for (int i = 0; i < 10; ++i) all.push_back(std::make_unique<Running>(words));
  for (const auto& running : all) EXPECT_EQ(running->Wait().status, 0);
  EXPECT_TRUE(!whole.empty() && ReadFile(place / "out.ppm") == whole);
  EXPECT_EQ(place.Others({"in.scn", "out.ppm"}), nothing);
}

}  // namespace
}  // namespace ray::testing
