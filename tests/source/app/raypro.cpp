// Runs of the program: its images, its output and its errors.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "R2/ImageFile.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

TEST(Raypro, MakesAnImageAndReportsItInOneLine) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const Finished done = RunProgram({place.Scene(), place / "out.png", "-width", "32", "-height=16"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_TRUE(done.output.starts_with(place / "out.png" + " 32x16 1 spp ")) << done.output;
  EXPECT_TRUE(done.output.ends_with(" Mrays/s\n")) << done.output;
  EXPECT_EQ(done.error, "");
  EXPECT_EQ(Decode(place / "out.png").image.Width(), 32);
  EXPECT_EQ(place.Others({"in.scn", "out.png"}), nothing);
}

TEST(Raypro, TheImageStatesItsSettings) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
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

TEST(Raypro, TheSameImageHasTheSameBytesInEveryRun) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
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

TEST(Raypro, KeepsTimesInTheImageOnRequest) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  ASSERT_EQ(RunProgram({place.Scene(), place / "out.png", "-keep_times", "-threads", "3"}).status, 0);
  auto settings = Decode(place / "out.png").settings;
  EXPECT_NE(settings["seconds"], "");
  EXPECT_EQ(settings["threads"], "3");
}

TEST(Raypro, ReadsScenesFromStandardInputAndLocatesMistakes) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
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

// Otherwise images of two scenes would pass for dependent, and one scene would resume the other.
TEST(Raypro, ScenesFromStandardInputAreDistinguished) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
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
  const SceneFolder place;
  const Finished done = RunProgram({place.Scene(), "-", "-width", "16", "-height", "8", "-stats"});
  EXPECT_EQ(done.status, 0) << done.error;
  WriteFile(place / "out.png", done.output);
  EXPECT_EQ(Decode(place / "out.png").image.Width(), 16);
  EXPECT_STREQ(Decode(place / "out.png").format->name, "png");
  EXPECT_TRUE(Has(done.error, "<stdout> 16x8 1 spp")) << done.error;
  EXPECT_EQ(place.Others({"in.scn", "out.png"}), nothing);
  EXPECT_EQ(RunProgram({place.Scene(), "-", "-resume"}).status, 2);
}

/// Runs a shell command in the folder; returns its status and its whole output.
Finished Shell(const TemporaryFolder& place, const std::string& command) {
  const std::string all = "cd '" + place.Path().string() + "' && { " + command + "\n} > said 2>&1";
  const int status = std::system(all.c_str());
  return {.status = WEXITSTATUS(status), .signal = 0, .output = ReadFile(place / "said"), .error = {}};
}

TEST(Raypro, PipesByNameAreTheStreamsThatTheyName) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place;
  const std::string size = " -width 16 -height 16 -quiet";
  ASSERT_EQ(Shell(place, "\"$RAYPRO\" in.scn named.pfm" + size).status, 0);
  // In a shell's <(...), a pipe is descriptor 9 and not 0.
  for (const std::string command :
       {"cat in.scn | \"$RAYPRO\" /dev/stdin out.pfm", "\"$RAYPRO\" /dev/fd/0 out.pfm < in.scn",
        "cat in.scn | \"$RAYPRO\" /dev/fd/9 out.pfm 9<&0 < /dev/null"}) {
    const Finished done = Shell(place, command + size);
    EXPECT_EQ(done.status, 0) << command << done.output;
    EXPECT_TRUE(ReadFile(place / "out.pfm") == ReadFile(place / "named.pfm")) << command;
    fs::remove(place / "out.pfm");
  }
  for (const std::string name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    const Finished piped = Shell(place, "\"$RAYPRO\" in.scn " + name + size + " | \"$RAYIMG\" info -");
    EXPECT_TRUE(piped.output.starts_with("<stdin>: png, 16x16\n")) << name << piped.output;
    EXPECT_EQ(Shell(place, "\"$RAYPRO\" in.scn " + name + size + " > out.png").status, 0) << name;
    EXPECT_EQ(Decode(place / "out.png").image.Width(), 16) << name;
  }
  EXPECT_EQ(Shell(place, "echo spere | \"$RAYPRO\" /dev/stdin out.png").status, 3);
  EXPECT_TRUE(Has(ReadFile(place / "said"), "<stdin>:1:1: error: unknown command 'spere'"));
}

TEST(Raypro, OtherPipesAreRefusedAsWhatTheyAre) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const SceneFolder place;
  ASSERT_EQ(Shell(place, "\"$RAYPRO\" in.scn a.png -width 8 -height 8 && mkfifo named.png named.scn").status, 0);
  const std::string run = "cat a.png | { \"$RAYPRO\" in.scn out.png -width 8 -height 8 ", from_9 = " 9<&0; }";
  for (const std::string& command :
       {run + "-reference /dev/fd/9" + from_9, run + "-env /dev/fd/9" + from_9, run + "-replay /dev/fd/9" + from_9,
        std::string("\"$RAYPRO\" named.scn out.png")}) {
    const Finished done = Shell(place, command);
    EXPECT_NE(done.status, 0) << command;
    EXPECT_TRUE(Has(done.output, "is a pipe, not a regular file")) << command << done.output;
  }
  for (const std::string& command :
       {std::string("\"$RAYPRO\" in.scn named.png"), run + "-report /dev/fd/9 9>&1 | cat; }",
        std::string("\"$RAYPRO\" in.scn /dev/fd/9 9>&1 | cat; false"),
        std::string("\"$RAYIMG\" convert a.png /dev/stdout | cat; false")}) {
    const Finished done = Shell(place, command);
    EXPECT_TRUE(Has(done.output, "it is not a regular file")) << command << done.output;
  }
}

TEST(Raypro, ALoneMeshRendersBesideItselfButSparesWhatIsThere) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder place;
  const std::map<std::string, std::string> meshes{
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"c.PLY",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}};
  for (const auto& [name, text] : meshes) {
    const std::string mesh = WriteFile(place / name, text), image = place / (name.substr(0, 1) + ".png");
    const std::vector<std::string> words{mesh, "-width", "8", "-height", "8"};
    for (int time = 0; time < 2; ++time) {  // over its own image too
      const Finished done = RunProgram(words);
      EXPECT_EQ(done.status, 0) << name << done.error;
      EXPECT_EQ(Decode(image).image.Width(), 8) << name;
    }
    WriteFile(image, "a texture");
    const Finished refused = RunProgram(words);
    EXPECT_EQ(refused.status, 2) << name;
    EXPECT_TRUE(Has(refused.error, "exists and may be a texture of the mesh; name the image")) << refused.error;
    EXPECT_EQ(ReadFile(image), "a texture") << name;
  }
}

TEST(Raypro, ALoneSceneRendersBesideItselfButSparesItsTexture) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  WriteFile(place / "in.png", "an earlier image");
  const Finished made = RunProgram({place.Scene(), "-width", "8", "-height", "6"});
  EXPECT_EQ(made.status, 0) << made.error;
  EXPECT_TRUE(made.output.starts_with(place / "in.png"));
  EXPECT_EQ(Decode(place / "in.png").image.Width(), 8);

  const std::string picture = ReadFile(place / "in.png");
  WriteFile(place.Scene(), "material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 in.png\n" + small_scene);
  EXPECT_NE(RunProgram({place.Scene(), "-width", "8", "-height", "6"}).status, 0);
  EXPECT_TRUE(ReadFile(place / "in.png") == picture);
}

TEST(Raypro, CameraOptionsOverrideTheSceneAndAreReplayed) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const std::string ball = "sphere -1 0 0 0 1\nbox -1 1 1 1 2 2 2\n";
  WriteFile(place / "said.scn", "camera look_at 3 2 4  0 0 0  0 1 .2  40\n" + ball);
  WriteFile(place / "asked.scn", "camera 0 0 9  0 0 -1  0 1 0  .5 .01 100\n" + ball);
  const std::vector<std::string> size{"-width", "24", "-height", "18", "-quiet"};
  const auto render = [&](std::vector<std::string> words) {
    words.insert(words.end(), size.begin(), size.end());
    const Finished done = RunProgram(words);
    EXPECT_EQ(done.status, 0) << done.error;
    return ReadFile(words[1]);
  };
  const std::string said = render({place / "said.scn", place / "a.ppm"});
  const auto asked = [&](const std::string& picture, const std::string& request, const std::string& report) {
    return render({place / "asked.scn", picture, "-eye", "3", "2", "4", "-target", "0", "0", "0", "-up", "0", "1", ".2",
                   "-fov", "40", request, report});
  };
  EXPECT_TRUE(asked(place / "b.ppm", "-report", place / "b.json") == said);
  EXPECT_TRUE(asked(place / "c.ppm", "-replay", place / "b.json") == said);
  const Finished other = RunProgram({place / "asked.scn", place / "d.ppm", "-replay", place / "b.json"});
  EXPECT_EQ(other.status, 2);
  EXPECT_FALSE(render({place / "asked.scn", place / "d.ppm", "-eye", "0", "0", "8"}) == said);
  const Finished inside =
      RunProgram({place / "asked.scn", place / "e.ppm", "-eye", "1", "1", "1", "-target", "1", "1", "1"});
  EXPECT_EQ(inside.status, 3);
  EXPECT_TRUE(Has(inside.error, "the camera is at the point given by -target")) << inside.error;
}

TEST(Raypro, RendersScenesIntoAFolderDespiteOneThatFails) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
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

// Regression: the image of one scene replaced the texture of another, which then was rendered with it.
TEST(Raypro, NoScenesImageReplacesWhatAnotherSceneReads) {
  NEEDS_THE_PROGRAM();
  if (!R2::FormatForName("a.png")) GTEST_SKIP() << "no PNG in this build";
  const SceneFolder place;
  const std::vector<std::string> more{"-out_folder", place.Path(), "-width", "8", "-height", "8", "-layers", "depth"};
  ASSERT_EQ(RunProgram(With({place.Scene()}, more)).status, 0);
  for (const char* texture : {"in.png", "in.depth.png"}) {
    const std::string before = ReadFile(place / texture);
    const std::string other = WriteFile(place / "other.scn", "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 " +
                                                                 std::string(texture) + "\n" + small_scene);
    const Finished done = RunProgram(With({place.Scene(), other}, With(more, {"-samples", "4"})));
    EXPECT_EQ(done.status, 4) << done.error;
    EXPECT_TRUE(Has(done.error, "it is the input")) << done.error;
    EXPECT_TRUE(ReadFile(place / texture) == before) << texture;
    EXPECT_EQ(Decode(place / "other.png").settings["samples"], "4") << "a mistake in one does not stop the others";
  }
}

TEST(Raypro, DebugpixelWritesNoFile) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
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

TEST(Extremes, G4_SizesOverTheLimitAreRefusedBeforeAllocating) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  for (const char* width : {"0", "-1", "2147483648", "1099511627776", "1073741824"}) {
    const Finished done = RunProgram({place.Scene(), place / "out.ppm", "-width", width});
    EXPECT_EQ(done.status, 2) << width;
    EXPECT_TRUE(Has(done.error, "-width")) << done.error;
    EXPECT_EQ(place.Others({"in.scn"}), nothing);
  }
}

TEST(Extremes, G10_ManyThreadsMakeTheSameImage) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  std::string first;
  for (const char* threads : {"1", "0", "3", "100"}) {
    RunProgram({place.Scene(), place / "out.pfm", "-width", "5", "-height", "4", "-samples", "4", "-threads", threads});
    const std::string picture = ReadFile(place / "out.pfm");
    if (first.empty()) first = picture;
    EXPECT_TRUE(!picture.empty() && picture == first) << threads;
  }
}

TEST(Raypro, TheReportIsWrittenAndAddsUp) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  RunProgram({place.Scene(), place / "out.ppm", "-report", place / "r.json", "-width", "10", "-height", "10"});
  const std::string report = ReadFile(place / "r.json");
  EXPECT_TRUE(Has(report, "\"camera\": 100,")) << report;
  EXPECT_TRUE(Has(report, "\"reason\": \"samples\"")) << report;
  EXPECT_EQ(place.Others({"in.scn", "out.ppm", "r.json"}), nothing);
}

}  // namespace
}  // namespace ray::testing
