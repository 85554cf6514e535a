// The program itself, from outside: exit statuses, and what is left behind when things go wrong.
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
using testing::Has;

const std::string small_scene = "camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\nsphere -1  0 0 0  1\n";
const std::vector<std::string> nothing;

/// A folder with a scene in it.
struct Place : TemporaryFolder {
  explicit Place(const std::string& text = small_scene) { WriteFile(*this / "in.scn", text); }
  std::string Scene() const { return *this / "in.scn"; }
};

R2::DecodedImage Decode(const std::string& file) {
  const std::string bytes = ReadFile(file);
  return R2::DecodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

std::vector<std::string> With(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Raypro, MakesAPictureAndSaysSoInOneLine) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished done = RunProgram({place.Scene(), place / "out.png", "-width", "32", "-height=16"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_TRUE(done.output.starts_with(place / "out.png" + " 32x16 1 spp ")) << done.output;
  EXPECT_TRUE(done.output.ends_with(" Mrays/s\n")) << done.output;
  EXPECT_EQ(done.error, "");
  EXPECT_EQ(Decode(place / "out.png").image.Width(), 32);
  EXPECT_EQ(place.Others({"in.scn", "out.png"}), nothing);
}

TEST(Raypro, QuietIsSilent) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished done = RunProgram({place.Scene(), place / "out.ppm", "-quiet"});
  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.output + done.error, "");
}

TEST(Raypro, ThePictureTellsHowItWasMade) {
  NEEDS_THE_PROGRAM();
  const Place place;
  for (const char* name : {"out.png", "out.jpg"}) {
    RunProgram({place.Scene(), place / name, "-width", "8", "-height", "8", "-seed", "7"});
    auto settings = Decode(place / name).settings;
    EXPECT_EQ(settings["seed"], "7") << name;
    EXPECT_EQ(settings["pixels"], "complete") << name;
    EXPECT_TRUE(Has(settings["command"], "-seed 7")) << name;
    const Finished info = RunProgram({"-info", place / name});
    EXPECT_TRUE(Has(info.output, "seed: 7\n")) << info.output;
    EXPECT_TRUE(Has(info.output, "8x8")) << info.output;
  }
}

TEST(Raypro, TheSamePictureIsTheSameBytesWhateverTheRun) {
  NEEDS_THE_PROGRAM();
  const Place place;
  for (const R2::ImageFormat& format : R2::ImageFormats()) {
    const std::string name = place / ("out." + std::string(format.extensions[0]));
    const std::vector<std::string> runs[] = {{place.Scene(), name, "-samples", "4", "-threads", "1"},
                                             {place.Scene(), name, "-samples=4", "-verbose", "-checkpoint", "1h"},
                                             {"--samples", "4", place.Scene(), name, "-threads", "3", "-resume"}};
    std::string first;
    for (const auto& words : runs) {
      ASSERT_EQ(RunProgram(words).status, 0);
      if (first.empty()) first = ReadFile(name);
      EXPECT_TRUE(!first.empty() && ReadFile(name) == first) << name;
    }
  }
}

TEST(Raypro, KeepsTimesInThePictureWhereAsked) {
  NEEDS_THE_PROGRAM();
  const Place place;
  ASSERT_EQ(RunProgram({place.Scene(), place / "out.png", "-keep_times", "-threads", "3"}).status, 0);
  auto settings = Decode(place / "out.png").settings;
  EXPECT_NE(settings["seconds"], "");
  EXPECT_EQ(settings["threads"], "3");
}

TEST(Raypro, ReadsASceneFromStandardInputWithPlacesForItsMistakes) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Surroundings from_scene{.standard_input = place.Scene()};
  ASSERT_EQ(RunProgram({place.Scene(), place / "named.pfm", "-width", "16", "-height", "16"}).status, 0);
  const Finished done = RunProgram({"-", place / "piped.pfm", "-width", "16", "-height", "16"}, from_scene);
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_TRUE(ReadFile(place / "piped.pfm") == ReadFile(place / "named.pfm"));
  EXPECT_TRUE(Has(RunProgram({"-", "-check"}, from_scene).output, "primitives"));

  const std::string bad = WriteFile(place / "bad.scn", "\n\n  spere 0 0 0 1\n");
  const Finished refused = RunProgram({"-", place / "out.png"}, {.standard_input = bad});
  EXPECT_EQ(refused.status, 3);
  EXPECT_TRUE(refused.error.starts_with("<stdin>:3:3: error: unknown command 'spere'")) << refused.error;
}

// Otherwise pictures of two scenes would pass for dependent, and one scene would resume the other.
TEST(Raypro, ScenesFromStandardInputAreToldApart) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const std::string other = WriteFile(place / "other.scn", "box -1  0 0 0  1 1 1\n");
  RunProgram({"-", place / "a.png", "-width", "8", "-height", "8"}, {.standard_input = place.Scene()});
  RunProgram({"-", place / "b.png", "-width", "8", "-height", "8"}, {.standard_input = other});
  const std::string hash = Decode(place / "a.png").settings["scene_hash"];
  EXPECT_NE(hash, Decode(place / "b.png").settings["scene_hash"]);
  RunProgram({place.Scene(), place / "a.png", "-width", "8", "-height", "8"});
  EXPECT_EQ(hash, Decode(place / "a.png").settings["scene_hash"]);
}

TEST(Raypro, WritesAPngAndNothingElseToStandardOutput) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished done = RunProgram({place.Scene(), "-", "-width", "16", "-height", "8", "-stats"});
  EXPECT_EQ(done.status, 0) << done.error;
  WriteFile(place / "out.png", done.output);
  EXPECT_EQ(Decode(place / "out.png").image.Width(), 16);
  EXPECT_STREQ(Decode(place / "out.png").format->name, "png");
  EXPECT_TRUE(Has(done.error, "<stdout> 16x8 1 spp")) << done.error;
  EXPECT_EQ(place.Others({"in.scn", "out.png"}), nothing);
  EXPECT_EQ(RunProgram({place.Scene(), "-", "-resume"}).status, 2);
}

TEST(Raypro, RendersSeveralScenesIntoAFolderAndOneThatFailsStopsNoOther) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const std::string bad = WriteFile(place / "bad.scn", "spere\n"), last = WriteFile(place / "last.scn", small_scene);
  fs::create_directory(place / "images");
  const std::vector<std::string> more{"-out_folder", place / "images", "-width", "8", "-height", "8"};
  const Finished done = RunProgram(With({place.Scene(), bad, place / "gone.scn", last}, more));
  EXPECT_EQ(done.status, 3) << done.error;
  EXPECT_TRUE(Has(done.error, "bad.scn:1:1") && Has(done.error, "gone.scn")) << done.error;
  EXPECT_EQ(Decode(place / "images/in.png").image.Width(), 8);
  EXPECT_EQ(Decode(place / "images/last.png").image.Width(), 8);
  EXPECT_EQ(RunProgram(With({last, "-out_format", "exr"}, more)).status, 0);
  EXPECT_STREQ(Decode(place / "images/last.exr").format->name, "exr");

  fs::remove_all(place / "images");
  EXPECT_EQ(RunProgram(With({last}, more)).status, 4);
  fs::create_directory(place / "images");
  const Finished twice = RunProgram(With({last, place / "images/../last.scn"}, more));
  EXPECT_EQ(twice.status, 2);
  EXPECT_TRUE(Has(twice.error, "would both be written to")) << twice.error;
  EXPECT_FALSE(fs::exists(place / "images/last.png"));
}

TEST(Raypro, ExitStatusSaysWhatWentWrongAndNoFileIsLeft) {
  NEEDS_THE_PROGRAM();
  const Place place;
  WriteFile(place / "bad.scn", "spere 0 0 0 1\n");
  const struct {
    std::vector<std::string> words;
    int status;
    const char* message;
  } cases[] = {
      {{}, 2, "no scene is named"},
      {{place.Scene()}, 2, "no picture is named"},
      {{place.Scene(), place / "out.xyz"}, 2, ".png"},
      {{place.Scene(), place / "out"}, 2, "extension"},
      {{place.Scene(), place / "out.ppm", "-widht", "3"}, 2, "-width"},
      {{place.Scene(), place / "out.ppm", "-samples", "0"}, 2, "-samples must be"},
      {{place / "missing.scn", place / "out.ppm"}, 3, "missing.scn"},
      {{place / "bad.scn", place / "out.ppm"}, 3, "bad.scn:1:1"},
      {{place.Path().string(), place / "out.ppm"}, 3, ""},
      {{"-info", place / "missing.png"}, 3, "missing.png"},
      {{"-info", place.Scene()}, 3, "in.scn"},
      {{place / "bad.scn", "-check"}, 3, "bad.scn:1:1"},
      {{place / "bad.scn", "-debugpixel", "1", "2"}, 3, "bad.scn:1:1"},
      {{place.Scene(), "-debugpixel", "256", "2"}, 2, "columns 0 to 255"},
      {{place.Scene(), place / "missing/out.ppm"}, 4, "does not exist"},
      {{place.Scene(), place / "out.ppm", "-report", place / "missing/r.json"}, 4, "does not exist"},
  };
  for (const auto& [words, status, message] : cases) {
    const Finished done = RunProgram(words);
    EXPECT_EQ(done.status, status) << done.error;
    EXPECT_TRUE(Has(done.error, message)) << done.error;
    EXPECT_EQ(done.output, "");
    EXPECT_EQ(place.Others({"in.scn", "bad.scn"}), nothing) << done.error;
  }
}

TEST(Raypro, DebugpixelWritesNoFile) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished alone = RunProgram({place.Scene(), "-debugpixel", "128", "128"});
  const Finished appended = RunProgram({place.Scene(), place / "out.png", "-report", place / "r.json", "-time", "5s",
                                        "-stats", "-resume", "-debugpixel", "128", "128"});
  for (const Finished& done : {alone, appended}) {
    EXPECT_EQ(done.status, 0) << done.error;
    EXPECT_EQ(done.error, "");
    EXPECT_NE(done.output, "");
  }
  EXPECT_EQ(place.Others({"in.scn"}), nothing);
}

TEST(Raypro, RequestsPrintToStandardOutputAndSucceed) {
  NEEDS_THE_PROGRAM();
  const Place place;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"-help"},
                                                {"-help", "light"},
                                                {"-version"},
                                                {"-list"},
                                                {"-list", "shapes"},
                                                {"-man"},
                                                {"-complete", "bash"},
                                                {place.Scene(), "-check"},
                                                {"nonsense", "-width", "abc", "-help"}}) {
    const Finished done = RunProgram(words);
    EXPECT_EQ(done.status, 0) << words[0] << done.error;
    EXPECT_NE(done.output, "") << words[0];
    EXPECT_EQ(done.error, "") << words[0];
  }
}

// A package's build must not install half a manual page and call it done.
TEST(Raypro, ARequestWhoseAnswerCannotBeWrittenFails) {
  NEEDS_THE_PROGRAM();
  EXPECT_EQ(RunProgram({"-man"}, {.standard_output = "/dev/full"}).status, 4);
}

TEST(Raypro, WarnsOnceOfWhatIsLikelyAMistake) {
  NEEDS_THE_PROGRAM();
  const Place place("camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\n" + small_scene + "sphere -1  0 0 6  1\n");
  const Finished done = RunProgram({place.Scene(), place / "out.ppm", "-width", "8", "-height", "8"});
  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.error, place.Scene() + ":2:1: warning: the scene has a camera already; the last one counts\n" +
                            place.Scene() + ": warning: the camera is inside 1 shape\n");
}

TEST(Raypro, WarnsOfOptionsThatDoNothing) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished done = RunProgram({place.Scene(), place / "out.ppm", "-bits", "16", "-max_depth", "1000000000"});
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(Has(done.error, "warning: -bits has no effect on the format ppm")) << done.error;
  EXPECT_TRUE(Has(done.error, "warning: -max_depth 1000000000 exceeds the hard limit of 1000 bounces")) << done.error;
}

TEST(Raypro, ASizeThatTheFormatCannotHoldIsRefusedBeforeRendering) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Finished done = RunProgram({place.Scene(), place / "out.jpg", "-width", "70000", "-height", "1"});
  EXPECT_EQ(done.status, 2) << done.error;
  EXPECT_TRUE(Has(done.error, "jpeg")) << done.error;
}

TEST(Extremes, G4_ASizeOverTheLimitEndsBeforeMemoryIsAskedFor) {
  NEEDS_THE_PROGRAM();
  const Place place;
  for (const char* width : {"0", "-1", "2147483648", "1099511627776", "1073741824"}) {
    const Finished done = RunProgram({place.Scene(), place / "out.ppm", "-width", width});
    EXPECT_EQ(done.status, 2) << width;
    EXPECT_TRUE(Has(done.error, "-width")) << done.error;
    EXPECT_EQ(place.Others({"in.scn"}), nothing);
  }
}

TEST(Extremes, G10_ManyThreadsMakeTheSamePicture) {
  NEEDS_THE_PROGRAM();
  const Place place;
  std::string first;
  for (const char* threads : {"1", "0", "3", "100"}) {
    RunProgram({place.Scene(), place / "out.pfm", "-width", "5", "-height", "4", "-samples", "4", "-threads", threads});
    const std::string picture = ReadFile(place / "out.pfm");
    if (first.empty()) first = picture;
    EXPECT_TRUE(!picture.empty() && picture == first) << threads;
  }
}

TEST(Extremes, K11_OutputNamesThatAreNoFiles) {
  NEEDS_THE_PROGRAM();
  const Place place;
  fs::create_directory(place / "folder.ppm");
  fs::create_symlink("/dev/full", place / "full.ppm");
  const std::pair<std::string, int> cases[] = {
      {place.Path().string(), 4}, {place / "folder.ppm", 4}, {"", 2},
      {"/dev/full", 4},           {place / "full.ppm", 4},   {place.Scene(), 4}};
  for (const auto& [name, status] : cases) {
    const Finished done = RunProgram({place.Scene(), name});
    EXPECT_EQ(done.status, status) << name << ": " << done.error;
    EXPECT_NE(done.error, "") << name;
  }
  EXPECT_EQ(ReadFile(place.Scene()), small_scene);
}

TEST(Extremes, K11_ALinkIsFollowedButNotSilently) {
  NEEDS_THE_PROGRAM();
  const Place place;
  fs::create_directory(place / "there");
  fs::create_symlink("there/real.ppm", place / "link.ppm");
  const Finished done = RunProgram({place.Scene(), place / "link.ppm", "-width", "8", "-height", "8"});
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(Has(done.error, "is a link; the picture goes to '" + place / "there/real.ppm" + "'")) << done.error;
  EXPECT_TRUE(fs::is_symlink(place / "link.ppm"));
  EXPECT_EQ(Decode(place / "there/real.ppm").image.Width(), 8);
}

TEST(Extremes, K11_AFileThatTheSceneIncludesIsAnInputToo) {
  NEEDS_THE_PROGRAM();
  const Place place("include part.ppm\n");
  WriteFile(place / "part.ppm", small_scene);
  const Finished done = RunProgram({place.Scene(), place / "part.ppm"});
  EXPECT_EQ(done.status, 4) << done.error;
  EXPECT_EQ(ReadFile(place / "part.ppm"), small_scene);
}

/// Whether something new is being written beside the target.
bool IsSaving(const TemporaryFolder& folder, const std::vector<std::string>& old) {
  std::error_code error;
  for (const std::string& name : folder.Others(old))
    if (fs::file_size(folder / name, error) > 0 && !error) return true;
  return false;
}

TEST(Extremes, L1_KilledAtAnyMomentTheOldPictureOrTheNewOneIsThere) {
  NEEDS_THE_PROGRAM();
  const Place place("");
  const std::vector<std::string> words{place.Scene(), place / "out.ppm", "-width", "700", "-height", "700", "-quiet"};
  ASSERT_EQ(RunProgram(words).status, 0);
  const std::string whole = ReadFile(place / "out.ppm");  // a .ppm says nothing of when it was made
  const auto start = std::chrono::steady_clock::now();
  RunProgram(words);
  const double whole_run = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::mt19937 random(1);
  int killed = 0, killed_while_saving = 0;
  for (int round = 0; round < Rounds("RAYTESTS_KILLS", 100); ++round) {
    const bool has_old = round % 2 == 0;
    fs::remove(place / "out.ppm");
    if (has_old) WriteFile(place / "out.ppm", "old");
    std::vector<std::string> old = place.Others({"out.ppm"});  // with what the round before left
    old.emplace_back("out.ppm");
    Running running(words);
    // Half of the rounds wait for the short time in which the picture is being saved.
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
  RecordProperty("killed_while_saving", killed_while_saving);

  ASSERT_EQ(RunProgram(words).status, 0);
  EXPECT_EQ(place.Others({"in.scn", "out.ppm"}), nothing);
}

/// How much more than what is already there a picture of the small scene needs.
constexpr long picture_bytes = 3 * 64 * 64 + 13;
const std::vector<std::string> picture_size{"-width", "64", "-height", "64"};

TEST(Extremes, L2_AFileSizeLimitAnywhereLeavesTheOldPictureWhole) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const auto words = With({place.Scene(), place / "out.ppm", "-quiet"}, picture_size);
  ASSERT_EQ(RunProgram(words).status, 0);
  const std::string whole = ReadFile(place / "out.ppm");
  ASSERT_EQ(static_cast<long>(whole.size()), picture_bytes);
  WriteFile(place / "out.ppm", "old");
  for (int i = 0; i < 64; ++i) {
    const long limit =
        i < 62 ? 512 + (picture_bytes - 512) * i / 62 : picture_bytes - 63 + i;  // the last: all but one, all
    const Finished done =
        RunProgram(words, {.file_size_limit = limit, .environment = {{"TMPDIR", place.Path().string()}}});
    const bool fits = limit >= picture_bytes;
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

TEST(Extremes, L2_AFullDiskLeavesTheOldPictureAndKeepsTheNewElsewhere) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const TemporaryFolder refuge;
  const SmallDisk disk(place / "disk");
  if (!disk.IsMounted())
    GTEST_SKIP() << "a small file system can be mounted by root only; the file size limit was tried";
  const auto words = With({place.Scene(), place / "disk/out.ppm", "-quiet"}, picture_size);
  ASSERT_EQ(RunProgram(words).status, 0);
  const std::string whole = ReadFile(place / "disk/out.ppm");
  WriteFile(place / "disk/out.ppm", "old");
  const long page = sysconf(_SC_PAGESIZE), pages_needed = (picture_bytes + page - 1) / page;
  for (int i = 0; i < 64; ++i) {
    const long pages_free = i % (2 * pages_needed);  // from none to twice what is needed
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

TEST(Extremes, L5_ASignalEndsTheRunWithinASecondAndSavesThePictureSoFar) {
  NEEDS_THE_PROGRAM();
  std::mt19937 random(2);
  for (int round = 0; round < Rounds("RAYTESTS_SIGNALS", 6); ++round) {
    const Place place;
    const int signal = round % 2 ? SIGTERM : SIGINT;
    Running running({place.Scene(), place / "out.png", "-width", "3000", "-height", "3000", "-samples", "64"});
    std::this_thread::sleep_for(std::chrono::duration<double>(std::uniform_real_distribution(0.2, 0.6)(random)));
    running.Send(signal);
    const auto sent = std::chrono::steady_clock::now();
    const Finished done = running.Wait();
    // Encoding nine million pixels takes its time as well, and the machine may be busy or a sanitizer at work.
    EXPECT_LT(std::chrono::steady_clock::now() - sent, 10s);
    EXPECT_EQ(done.status, 128 + signal) << done.error;
    ASSERT_TRUE(fs::exists(place / "out.png")) << done.error;
    auto settings = Decode(place / "out.png").settings;
    EXPECT_TRUE(Has(settings["pixels"], " of 9000000 pixels done")) << settings["pixels"];
    EXPECT_EQ(settings["samples"], "64");
    EXPECT_TRUE(Has(done.output, signal == SIGINT ? "stopped by SIGINT" : "stopped by SIGTERM")) << done.output;
    EXPECT_EQ(place.Others({"in.scn", "out.png", "out.png.checkpoint"}), nothing);
  }
}

// Two billion rays for one sample: stopping was once looked for between samples only.
TEST(Extremes, L5_ASignalEndsALoopOverManyLightSamples) {
  NEEDS_THE_PROGRAM();
  const std::string light = "area_light 1 1 1 0 3 0 0 -1 0 1 1 0 0 ", box = "box -1 -1 -1 -1 1 1 1\n";
  const std::string glowing = "material 0 0 0 .5 .5 .5 0 0 0 0 0 0 1 1 1 0 1 0\ntri 0 -1 3 -1 1 3 -1 0 3 1\n";
  const struct {
    std::string scene;
    std::vector<std::string> words;
  } runs[] = {{light + box, {"-shadow_samples", "2147483647"}},
              {light + box, {"-lights", "2147483647"}},
              {light + box, {"-lights", "2147483647", "-mode", "path"}},
              {"sphere_light 1 1 1 0 3 0 1 1 0 0 " + box, {"-shadow_samples", "2147483647", "-shadows", "off"}},
              {glowing + box, {"-shadow_samples", "2147483647"}}};
  for (const auto& [scene, words] : runs) {
    const Place place;
    WriteFile(place.Scene(), scene);
    Running running(With({place.Scene(), place / "out.ppm", "-width", "8", "-height", "8"}, words));
    std::this_thread::sleep_for(500ms);
    EXPECT_FALSE(running.IsOver());
    running.Send(SIGINT);
    const Finished done = running.Wait(20s);  // else minutes
    EXPECT_EQ(done.status, 130) << words[0] << done.error;
    EXPECT_TRUE(Has(done.error, "progress saved")) << done.error;
    EXPECT_EQ(place.Others({"in.scn", "out.ppm", "out.ppm.checkpoint"}), nothing);
  }
}

TEST(Extremes, L5_ASecondSignalEndsTheRunAtOnceAndLeavesTheOldPicture) {
  NEEDS_THE_PROGRAM();
  const Place place;
  WriteFile(place / "out.ppm", "old");
  Running running({place.Scene(), place / "out.ppm", "-width", "3000", "-height", "3000", "-samples", "64"});
  std::this_thread::sleep_for(500ms);
  // Both are there when the process goes on, so it has no time to end in between; which comes first is the system's.
  for (const int signal : {SIGSTOP, SIGINT, SIGTERM, SIGCONT}) running.Send(signal);
  const int status = running.Wait().status;
  EXPECT_TRUE(status == 128 + SIGINT || status == 128 + SIGTERM) << status;
  EXPECT_EQ(ReadFile(place / "out.ppm"), "old");
  EXPECT_EQ(place.Others({"in.scn", "out.ppm"}), nothing);
}

TEST(Extremes, L6_NobodyListeningCostsNoPicture) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const Surroundings silences[] = {
      {.close_output = true},
      {.close_error = true},
      {.close_output = true, .close_error = true},
      {.break_output = true},
      {.standard_output = "/dev/full", .standard_error = "/dev/full"},  // only this is a failure: -stats was asked for
  };
  const auto words = With({place.Scene(), place / "out.ppm", "-stats", "-verbose"}, picture_size);
  std::string first;
  for (const Surroundings& silence : silences) {
    fs::remove(place / "out.ppm");
    const Finished done = RunProgram(words, silence);
    EXPECT_EQ(done.status, silence.standard_output.empty() ? 0 : 4);
    const std::string picture = ReadFile(place / "out.ppm");
    if (first.empty()) first = picture;
    EXPECT_EQ(static_cast<long>(picture.size()), picture_bytes);
    EXPECT_TRUE(picture == first);  // not a word of the messages went into it
  }
}

TEST(Extremes, K11_StatisticsThatCannotBeWrittenAreAFailureAndTheLineNobodyAskedForIsNone) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const auto words = With({place.Scene(), place / "out.ppm"}, picture_size);
  const Finished asked = RunProgram(With(words, {"-stats"}), {.standard_output = "/dev/full"});
  EXPECT_EQ(asked.status, 4);
  EXPECT_TRUE(Has(asked.error, "cannot write 'standard output': No space left on device")) << asked.error;
  EXPECT_EQ(static_cast<long>(ReadFile(place / "out.ppm").size()), picture_bytes);
  EXPECT_EQ(RunProgram(words, {.standard_output = "/dev/full"}).status, 0);
}

// With less, the process used to die by a signal.
TEST(Extremes, L12_WhereNoThreadCanBeMadeOneDoesAllTheWork) {
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.Path(), std::filesystem::perms::all);
  Surroundings alone;
  alone.deny_threads = true;
  if (RunProgram({"-version"}, alone).status != 0) GTEST_SKIP() << "the program is not for other users";
  const std::string scene = WriteFile(folder / "ball.scn", "sphere -1  0 0 0  1\n");
  const std::string usual = folder / "usual.ppm", by_one = folder / "by_one.ppm";
  EXPECT_EQ(RunProgram({scene, usual, "-width", "64", "-height", "64"}).status, 0);
  for (const char* threads : {"0", "8"}) {
    const Finished finished = RunProgram({scene, by_one, "-width", "64", "-height", "64", "-threads", threads}, alone);
    EXPECT_EQ(finished.status, 0) << finished.error;
    EXPECT_EQ(ReadFile(by_one), ReadFile(usual));
  }
}

TEST(Extremes, L11_AStackTooSmallIsToldOfAndASoftLimitRaised) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const std::string words = std::string(" ") + place.Scene() + " " + (place / "out.ppm") + " -width 8 -height 8 -quiet";
  const auto with_limit = [&](const std::string& limit) {
    const std::string script = limit + "; exec " + ProgramName() + words + " 2>" + (place / "error");
    return std::system(("sh -c '" + script + "'").c_str());
  };
  EXPECT_EQ(WEXITSTATUS(with_limit("ulimit -s 64")), 1);
  EXPECT_TRUE(Has(ReadFile(place / "error"), "the stack is limited to 64 KiB, and 256 are needed"));
  EXPECT_FALSE(fs::exists(place / "out.ppm"));
  for (const char* enough : {"ulimit -S -s 64", "ulimit -s 256"}) {
    fs::remove(place / "out.ppm");
    const int status = with_limit(enough);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << enough << ReadFile(place / "error");
    EXPECT_TRUE(fs::exists(place / "out.ppm")) << enough;
  }
}

TEST(Extremes, L10_ManyRunsWithOneOutputLeaveOneWholePicture) {
  NEEDS_THE_PROGRAM();
  const Place place;
  const auto words = With({place.Scene(), place / "out.ppm", "-quiet"}, picture_size);
  RunProgram(words);
  const std::string whole = ReadFile(place / "out.ppm");
  std::vector<std::unique_ptr<Running>> all;
  for (int i = 0; i < 10; ++i) all.push_back(std::make_unique<Running>(words));
  for (const auto& running : all) EXPECT_EQ(running->Wait().status, 0);
  EXPECT_TRUE(!whole.empty() && ReadFile(place / "out.ppm") == whole);
  EXPECT_EQ(place.Others({"in.scn", "out.ppm"}), nothing);
}

TEST(Raypro, TheReportIsWrittenAndAddsUp) {
  NEEDS_THE_PROGRAM();
  const Place place;
  RunProgram({place.Scene(), place / "out.ppm", "-report", place / "r.json", "-width", "10", "-height", "10"});
  const std::string report = ReadFile(place / "r.json");
  EXPECT_TRUE(Has(report, "\"camera\": 100,")) << report;
  EXPECT_TRUE(Has(report, "\"reason\": \"samples\"")) << report;
  EXPECT_EQ(place.Others({"in.scn", "out.ppm", "r.json"}), nothing);
}

}  // namespace
}  // namespace ray::testing
