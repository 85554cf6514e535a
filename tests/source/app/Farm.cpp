// Images that several processes render together.
#include "source/app/Farm.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "source/app/files/Checkpoint.h"
#include "source/app/files/PartFiles.h"
#include "source/app/files/SceneHash.h"
#include "source/app/options/CommandLine.h"
#include "source/app/options/SceneSettings.h"
#include "source/parse/SceneError.h"
#include "source/render/Parts.h"
#include "source/text/Words.h"
#include "tests/source/app/Place.h"

namespace ray::testing {
namespace {

/// The folder of an image that is rendered in parts.
struct PartsPlace : Place {
  Finished Part(int i, int n, const List& more = {}) const {
    return Run("out.png", With({"-part", std::to_string(i) + "/" + std::to_string(n)}, more));
  }
  void AllParts(int n, const List& more = {}) const {
    for (int i = n; i >= 1; --i) {
      const Finished part = Part(i, n, more);
      EXPECT_EQ(part.status, 0) << part.error;
    }
  }
  Finished Assemble(const List& more = {}) const {
    return Run("out.png", With({"-parts", *this / "out.png.part-*"}, more));
  }
  std::string Missing(int n, const List& more = {}) const {
    const Finished done = Run("out.png", With({"-missing", std::to_string(n)}, more));
    EXPECT_EQ(done.status, 0) << done.error;
    return done.output;
  }
  /// Returns the files of one render by name, and removes them.
  std::map<std::string, std::string> OneRender(const List& more = {}) const {
    const Finished done = Run("out.png", more);
    EXPECT_EQ(done.status, 0) << done.error;
    std::map<std::string, std::string> files;
    for (const std::string& name : Others({"in.scn"})) {
      files[name] = ReadFile(*this / name);
      std::filesystem::remove(*this / name);
    }
    return files;
  }
  void ExpectFiles(const std::map<std::string, std::string>& files) const {
    for (const auto& [name, bytes] : files) EXPECT_TRUE(ReadFile(*this / name) == bytes) << name;
  }
};

std::string NameOfPart(int i, int n) { return "out.png.part-" + std::to_string(i) + "-of-" + std::to_string(n); }

TEST(Farm, AssembledFilesAreThoseOfOneRender) {
  NEEDS_THE_PROGRAM();
  for (const List& more : {List{}, List{"-samples", "9", "-layers", "depth,id", "-filter", "lanczos"},
                           List{"-mode", "path", "-samples", "16", "-denoise", "-srgb"}}) {
    const PartsPlace place;
    const auto expected = place.OneRender(more);
    EXPECT_EQ(place.Missing(3, more), "1\n2\n3\n");
    place.AllParts(3, more);
    EXPECT_EQ(place.Missing(3, more), "");
    const Finished done = place.Assemble(more);
    EXPECT_EQ(done.status, 0) << done.error;
    EXPECT_EQ(done.error, "");
    place.ExpectFiles(expected);
    List known{"in.scn", NameOfPart(1, 3), NameOfPart(2, 3), NameOfPart(3, 3)};
    for (const auto& [name, bytes] : expected) known.push_back(name);
    EXPECT_EQ(place.Others(known), List{});
  }
}

/// Settings that affect several blocks at once: filters, borders, lenses, motion, layers, decisions based on the image.
const List settings_of_all_kinds[] = {
    {},
    {"-samples", "4"},
    {"-samples", "9", "-filter", "lanczos"},
    {"-samples", "4", "-filter", "gaussian", "-bytes", "truncated"},
    {"-samples", "4", "-filter", "mitchell", "-crop", "5", "4", "33", "21"},
    {"-samples", "4", "-sampler", "stratified", "-seed", "9"},
    {"-samples", "4", "-aperture", "0.3", "-focus", "5"},
    {"-samples", "7", "-motion", "0.1", "0", "0", "-filter", "gaussian"},
    {"-mode", "path", "-samples", "8", "-motion", "0", "0.3", "0.1", "-sampler", "grid", "-shutter_samples", "2"},
    {"-samples", "4", "-shadow_samples", "3"},
    {"-samples", "2", "-mode", "normal"},
    {"-samples", "2", "-mode", "toon"},
    {"-samples", "4", "-layers", "depth,id"},
    {"-samples", "4", "-layers", "normal,albedo", "-filter", "gaussian"},
    {"-mode", "path"},
    {"-mode", "path", "-samples", "16", "-srgb"},
    {"-mode", "path", "-samples", "8", "-max_depth", "7", "-strategy", "bsdf"},
    {"-mode", "path", "-samples", "16", "-denoise"},
    {"-mode", "path", "-samples", "16", "-aperture", "0.2", "-focus", "6", "-layers", "depth"},
    {"-mode", "path", "-samples", "128", "-error", "8"},
    {"-mode", "path", "-samples", "128", "-error", "10", "-adaptive", "off"},
    {"-samples", "16", "-adaptive", "neighbors"},
};

int RunRounds(const PartsPlace& place, int n, const List& more);

TEST(Farm, PartsInAnyOrderOnAnyMachineMakeOneImage) {
  NEEDS_THE_PROGRAM();
  for (const List& more : settings_of_all_kinds) {
    const PartsPlace place;
    const auto expected = place.OneRender(more);
    ASSERT_FALSE(expected.empty());
    for (const int n : {1, 5, 64}) {
      if (n > Rounds("RAYTESTS_PARTS", 5)) continue;  // this many take a minute
      RunRounds(place, n, more);
      EXPECT_EQ(place.Assemble(more).status, 0);
      SCOPED_TRACE(ShellLine(more) + " in " + std::to_string(n));
      place.ExpectFiles(expected);
      if (HasFailure()) return;
      for (const std::string& name : place.Others({"in.scn"})) std::filesystem::remove(place / name);
    }
  }
}

/// Names that have another meaning in patterns of a shell, printf or GNU parallel.
const List odd_names{"shot[1].png", "[!a]*?.png", "a\\nb\\\\.png", "s{}h{1}{.}.png", "50%d {a,b}.png", "]x[.png"};

TEST(Farm, NamesOfImagesAreNeverPatterns) {
  NEEDS_THE_PROGRAM();
  for (const std::string& name : odd_names) {
    const PartsPlace place;
    EXPECT_EQ(place.Run(name, {}).status, 0);
    const std::string expected = ReadFile(place / name);
    std::filesystem::remove(place / name);
    WriteFile(place / "shot1.png.part-1-of-3", "a part of another image");
    for (int i = 1; i <= 3; ++i) EXPECT_EQ(place.Run(name, {"-part", std::to_string(i) + "/3"}).status, 0) << name;
    const Finished missing = place.Run(name, {"-missing", "3"});
    EXPECT_EQ(missing.output + missing.error, "") << name;
    // If a part is not found, its samples are rendered again.
    const Finished done = place.Run(name, {"-parts", place / (name + ".part-*"), "-explain"});
    EXPECT_EQ(done.status, 0) << done.error;
    EXPECT_FALSE(Has(done.error, "no file is named")) << done.error;
    EXPECT_TRUE(ReadFile(place / name) == expected) << name;
  }
}

TEST(Farm, APatternFindsNamesBeforeItIsAPattern) {
  const TemporaryFolder place;
  const std::string odd_folder = place / "in[1]";
  std::filesystem::create_directory(odd_folder);
  std::filesystem::create_directory(place / "in1");
  for (const char* name : {"a.png.part-1-of-3", "a.png.part-2-of-3", "a.png.part-3-of-3", "b[1].png.part-1-of-2",
                           "b1.png.part-1-of-2", "c*.png.part-1-of-1", "cd.png.part-1-of-1", "e.png.part-[1]"})
    WriteFile(place / name, "");
  WriteFile(odd_folder + "/a.png.part-1-of-1", "");
  WriteFile(place / "in1/a.png.part-1-of-1", "");
  const auto found = [&](const std::string& pattern, const std::string& image) {
    List names;
    for (const std::string& name : FilesLike(place / pattern, image))
      names.push_back(std::filesystem::relative(name, place.Path()).string());
    return names;
  };
  EXPECT_EQ(found("a.png.part-*", "a.png"), (List{"a.png.part-1-of-3", "a.png.part-2-of-3", "a.png.part-3-of-3"}));
  EXPECT_EQ(found("a.png.part-[13]-of-?", "a.png"), (List{"a.png.part-1-of-3", "a.png.part-3-of-3"}));
  EXPECT_EQ(found("[ab].png.part-[!1]*", "o.png"), (List{"a.png.part-2-of-3", "a.png.part-3-of-3"}));
  EXPECT_EQ(found("b[1].png.part-*", "o.png"), List{"b[1].png.part-1-of-2"}) << "that is the name of an image";
  EXPECT_EQ(found("b[1].png.part-[1-9]*", "x/b[1].png"), List{"b[1].png.part-1-of-2"}) << "as is the image's own";
  EXPECT_EQ(found("c*.png.part-*", "c*.png"), List{"c*.png.part-1-of-1"});
  EXPECT_EQ(found("c*.png.part-*", "o.png"), (List{"c*.png.part-1-of-1", "cd.png.part-1-of-1"}));
  EXPECT_EQ(found("e.png.part-[1]", "o.png"), List{"e.png.part-[1]"}) << "a file";
  EXPECT_EQ(found("in[1]/a.png.part-*", "o.png"), List{"in[1]/a.png.part-1-of-1"});
  EXPECT_EQ(found("in?/a.png.part-*", "o.png"), List{"in1/a.png.part-1-of-1"});
  EXPECT_EQ(found("[c]d.png.part-*", "o.png"), List{"cd.png.part-1-of-1"});
  EXPECT_EQ(found("nothing*", "o.png"), List{});
}

TEST(Farm, WorkersKilledAtRandomMomentsLoseNothing) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const List more{"-mode", "path", "-samples", "400", "-checkpoint", "0.01", "-threads", "1"};
  const auto start = std::chrono::steady_clock::now();
  const auto expected = place.OneRender(more);
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::mt19937 random(1);
  int killed = 0;
  for (int round = 0; round < Rounds("RAYTESTS_KILLS", 8); ++round) {
    for (const int i : {1, 2}) {
      Running worker(With({place.Scene(), place / "out.png", "-width", "40", "-height", "30", "-part",
                           std::to_string(i) + "/2", "-quiet"},
                          more));
      std::this_thread::sleep_for(std::chrono::duration<double>(std::uniform_real_distribution(0.0, whole)(random)));
      worker.Send(SIGKILL);
      killed += worker.Wait().signal == SIGKILL;
    }
    RunRounds(place, 2, more);
    EXPECT_EQ(place.Assemble(more).status, 0);
    place.ExpectFiles(expected);
    List known{"in.scn", NameOfPart(1, 2), NameOfPart(2, 2)};
    for (const auto& [name, bytes] : expected) known.push_back(name);
    const List others = place.Others(known);
    EXPECT_LE(others.size(), 2u) << "a kill leaves one unfinished file at most";
    for (const List& names : {known, others})
      for (const std::string& name : names)
        if (name != "in.scn") std::filesystem::remove(place / name);
    if (HasFailure()) return;
  }
  EXPECT_GT(killed, 0);
  std::printf("%d workers killed\n", killed);
}

TEST(Farm, MissingPartsAreRenderedByTheAssembler) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const List more{"-samples", "4", "-mode", "path"};
  const auto expected = place.OneRender(more);
  for (const int i : {1, 4}) EXPECT_EQ(place.Part(i, 5, more).status, 0);
  EXPECT_EQ(place.Missing(5, more), "2\n3\n5\n");
  EXPECT_EQ(place.Assemble(more).status, 0);
  place.ExpectFiles(expected);
  std::filesystem::remove(place / NameOfPart(1, 5));
  std::filesystem::remove(place / NameOfPart(4, 5));
  const Finished none = place.Assemble(more);
  EXPECT_EQ(none.status, 0);
  EXPECT_TRUE(Has(none.error, "no file is named '" + place / "out.png.part-*'")) << none.error;
  place.ExpectFiles(expected);
}

TEST(Farm, PartsOfAnotherImageAreRefusedByName) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const List more{"-samples", "4", "-seed", "3"};
  place.AllParts(2, more);
  const struct {
    List other;
    const char* reason;
  } cases[] = {
      {{"-samples", "4", "-seed", "4"}, "made with -seed 3"},
      {{"-samples", "8", "-seed", "3"}, "planned for 4 per pixel, not 8"},
      {{"-samples", "4", "-seed", "3", "-filter", "gaussian"}, "made with -filter box"},
      {{"-samples", "4", "-seed", "3", "-mode", "path"}, "made with -mode whitted"},
  };
  for (const auto& [other, reason] : cases)
    for (const Finished& done :
         {place.Assemble(other), place.Part(1, 2, other), place.Run("out.png", With({"-missing", "2"}, other))}) {
      EXPECT_EQ(done.status, 3) << reason;
      EXPECT_TRUE(Has(done.error, NameOfPart(1, 2)) && Has(done.error, reason)) << done.error;
      EXPECT_FALSE(std::filesystem::exists(place / "out.png"));
    }
  EXPECT_EQ(place.Part(1, 2, With({"-restart"}, cases[0].other)).status, 0);
  const Finished mixed = place.Assemble(more);
  EXPECT_EQ(mixed.status, 3);
  EXPECT_TRUE(Has(mixed.error, "made with -seed 4")) << mixed.error;
  WriteFile(place.Scene(), soft_scene + "sphere -1  0 9 0  .1\n");
  const Finished done = place.Assemble(more);
  EXPECT_EQ(done.status, 3);
  EXPECT_TRUE(Has(done.error, "a different scene")) << done.error;
}

TEST(Farm, PartsOfAnotherDivisionOrByteOrderAreRefused) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  EXPECT_EQ(place.Part(1, 2).status, 0);
  EXPECT_EQ(place.Part(3, 3).status, 0);
  const Finished mixed = place.Assemble();
  EXPECT_EQ(mixed.status, 3);
  EXPECT_TRUE(Has(mixed.error, NameOfPart(3, 3)) && Has(mixed.error, "one of 3 parts, others are of 2")) << mixed.error;
  std::filesystem::remove(place / NameOfPart(3, 3));
  std::string bytes = ReadFile(place / NameOfPart(1, 2));
  const std::string here = "little-endian", there = "big-endian";
  ASSERT_TRUE(Has(bytes, here));
  WriteFile(place / NameOfPart(1, 2), bytes.replace(bytes.find(here), here.size(), there));
  const Finished foreign = place.Assemble();
  EXPECT_EQ(foreign.status, 3);
  EXPECT_TRUE(Has(foreign.error, "another byte order")) << foreign.error;
}

/// Options as the program reads them, and the identity of a part that follows from them and the scene.
struct Asked {
  explicit Asked(const PartsPlace& place, const List& more = {}) {
    const List words = With({place.Scene(), place / "out.png", "-width", "40", "-height", "30", "-part", "1/2"}, more);
    const ParsedScene parsed = Parse(place.Scene(), {});
    options = WithSettingsOf(parsed.scene, ReadCommandLine(Program::raypro, words));
    identity = IdentityOf(options, SceneHash(parsed.scene.files));
  }
  RenderOptions options;
  std::string identity;
};

TEST(Farm, DuplicatePartsMustContainTheSameSums) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const auto expected = place.OneRender();
  place.AllParts(2);
  const std::string twin = place / "out.png.part-1-of-2-again";
  std::filesystem::copy(place / NameOfPart(1, 2), twin);
  EXPECT_EQ(place.Assemble().status, 0);
  place.ExpectFiles(expected);
  const Asked asked(place);
  auto part = PartReader(asked.options.render, asked.options.files.image, asked.identity).Read(twin);
  ASSERT_TRUE(part);
  for (Film::Block& block : part->state.blocks)
    if (block.Samples() > 0) block.sums[0].Sums()[0].color.r += 1e-9;
  PartWriter(asked.options.render, asked.options.files, asked.identity).WritePart(std::move(part->state));
  const Finished done = place.Assemble();
  EXPECT_EQ(done.status, 3);
  EXPECT_TRUE(Has(done.error, "out.png.part-1-of-2-again") && Has(done.error, "out.png.part-1-of-2'")) << done.error;
}

TEST(Farm, ADamagedPartIsNamedAndRenderedAgain) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const auto expected = place.OneRender();
  place.AllParts(2);
  const std::string whole = ReadFile(place / NameOfPart(2, 2));
  for (const std::string& damaged : {whole.substr(0, whole.size() / 2), whole + "x", std::string("x"), std::string()}) {
    WriteFile(place / NameOfPart(2, 2), damaged);
    EXPECT_EQ(place.Missing(2), "2\n");
    const Finished done = place.Assemble();
    EXPECT_EQ(done.status, 0);
    EXPECT_TRUE(Has(done.error, NameOfPart(2, 2)) && Has(done.error, "rendered again")) << done.error;
    place.ExpectFiles(expected);
  }
  EXPECT_EQ(place.Part(2, 2).status, 0) << "renders over a damaged file of its own";
  EXPECT_TRUE(ReadFile(place / NameOfPart(2, 2)) == whole);
}

// Another job of the image's name removes parts between the listing of their names and their reading.
TEST(Farm, APartThatVanishesBeforeReadingCountsAsMissing) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  EXPECT_EQ(place.Part(1, 2).status, 0);
  const Asked asked(place);
  PartReader reader(asked.options.render, asked.options.files.image, asked.identity);
  const RenderState joined = reader.Joined({place / NameOfPart(1, 2), place / NameOfPart(2, 2)}, 2);
  EXPECT_EQ(MissingParts(joined, asked.options.render, reader.PartsOf(2)), std::vector{2});
}

// A part that is neither refused nor found damaged must be unchanged.
TEST(Farm, NoChangedByteOfAPartGoesUnnoticed) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  EXPECT_EQ(place.Part(1, 2).status, 0);
  const Asked asked(place);
  PartReader reader(asked.options.render, asked.options.files.image, asked.identity);
  const std::string name = place / NameOfPart(1, 2), whole = ReadFile(name);
  const auto original = reader.Read(name);
  ASSERT_TRUE(original);
  ::testing::internal::CaptureStderr();
  int noticed = 0, tried = 0;
  for (std::size_t i = 0; i < whole.size(); i += i < 60 ? 1 : 97, ++tried) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ (1 << i % 8));
    WriteFile(name, bytes);
    try {
      const auto part = reader.Read(name);
      noticed += !part || (part->part == original->part && Agree(part->state, original->state) &&
                           SamplesOf(part->state) == SamplesOf(original->state));
    } catch (const SceneErrors&) {
      ++noticed;
    }
  }
  ::testing::internal::GetCapturedStderr();
  EXPECT_GT(tried, 100);
  EXPECT_EQ(noticed, tried);
}

TEST(Farm, ATerminatedPartContinuesFromItsCheckpoint) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const List more{"-samples", "600", "-mode", "path"};
  const auto expected = place.OneRender(more);
  Running running(
      With({place.Scene(), place / "out.png", "-width", "40", "-height", "30"}, With({"-part", "1/2"}, more)));
  running.WaitUntilItCatches(SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  running.Send(SIGTERM);
  const Finished stopped = running.Wait();
  EXPECT_TRUE(stopped.status == 143 || stopped.status == 0) << stopped.error;
  EXPECT_EQ(place.Missing(2, more), stopped.status == 143 ? "1\n2\n" : "2\n");
  place.AllParts(2, more);
  EXPECT_EQ(place.Missing(2, more), "");
  EXPECT_EQ(place.Assemble(more).status, 0);
  place.ExpectFiles(expected);
}

TEST(Farm, AFullDiskCostsAPartButNotTheImage) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const auto expected = place.OneRender();
  Surroundings full;
  full.file_size_limit = 2000;
  full.environment["TMPDIR"] = place.Path().string();
  const Finished done =
      RunProgram({place.Scene(), place / "out.png", "-width", "40", "-height", "30", "-part", "1/2"}, full);
  EXPECT_EQ(done.status, 4);
  EXPECT_TRUE(Has(done.error, NameOfPart(1, 2))) << done.error;
  EXPECT_EQ(place.Part(2, 2).status, 0);
  EXPECT_EQ(place.Missing(2), "1\n");
  EXPECT_EQ(place.Assemble().status, 0);
  place.ExpectFiles(expected);
}

TEST(Farm, TwoJobsOfOneNameDoNoHarm) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const auto expected = place.OneRender();
  for (int round = 0; round < 3; ++round) {
    std::vector<std::unique_ptr<Running>> jobs;
    for (int i = 0; i < 6; ++i)
      jobs.push_back(std::make_unique<Running>(List{place.Scene(), place / "out.png", "-width", "40", "-height", "30",
                                                    "-part", std::to_string(1 + i % 2) + "/2"}));
    for (auto& job : jobs) EXPECT_EQ(job->Wait().status, 0);
    EXPECT_EQ(place.Missing(2), "");
    EXPECT_EQ(place.Assemble().status, 0);
    place.ExpectFiles(expected);
    EXPECT_EQ(place.Others({"in.scn", "out.png", NameOfPart(1, 2), NameOfPart(2, 2)}), List{}) << "nothing else stays";
  }
}

/// Returns the number of rounds until nothing is missing, with parts in random orders and different machines.
int RunRounds(const PartsPlace& place, int n, const List& more) {
  std::mt19937 random(static_cast<unsigned>(n));
  for (int round = 0; round < 30; ++round) {
    List missing = SplitWords(place.Missing(n, more));
    if (missing.empty()) return round;
    std::ranges::shuffle(missing, random);
    for (const std::string& part : missing) {
      const int i = std::stoi(part);
      EXPECT_EQ(place.Part(i, n, With(more, {"-simd", i % 2 == 0 ? "sse4" : "avx2"})).status, 0);
    }
  }
  ADD_FAILURE() << "no end of rounds";
  return -1;
}

TEST(Farm, RoundsReachAnErrorTargetLikeOneRender) {
  NEEDS_THE_PROGRAM();
  for (const List& more :
       {List{"-mode", "path", "-error", "4", "-samples", "512"}, List{"-samples", "16", "-adaptive", "neighbors"}}) {
    const PartsPlace place;
    const Finished one = RunProgram(With({place.Scene(), place / "out.png", "-width", "40", "-height", "30"}, more));
    const auto expected = place.OneRender(more);
    EXPECT_GT(RunRounds(place, 3, more), 1);
    const Finished done = RunProgram(With(
        {place.Scene(), place / "out.png", "-width", "40", "-height", "30", "-parts", place / "out.png.part-*"}, more));
    EXPECT_EQ(done.status, 0) << done.error;
    EXPECT_EQ(one.output.substr(one.output.find('\n')), done.output.substr(done.output.find('\n')))
        << "the line of the error and its interval";
    place.ExpectFiles(expected);
  }
}

/// Changes the time of the plan's file by a duration.
void ShiftPlan(const PartsPlace& place, std::chrono::seconds later) {
  const std::string plan = place / "out.png.plan";
  std::filesystem::last_write_time(plan, std::filesystem::last_write_time(plan) + later);
}

TEST(Farm, ATimeThatIsLongEnoughChangesNoByte) {
  NEEDS_THE_PROGRAM();
  for (const List& more : {List{"-mode", "path", "-samples", "16"},
                           List{"-mode", "path", "-error", "4", "-samples", "512", "-filter", "gaussian"},
                           List{"-mode", "path", "-samples", "16", "-denoise"}}) {
    const PartsPlace place;
    const List timed = With(more, {"-time", "1000"});
    const auto expected = place.OneRender(timed);
    EXPECT_EQ(place.Missing(3, timed), "1\n2\n3\n");
    ShiftPlan(place, std::chrono::hours(1));  // a server's clock may be wrong
    RunRounds(place, 3, timed);
    const Finished done = place.Assemble(timed);
    EXPECT_EQ(done.status, 0) << done.error;
    place.ExpectFiles(expected);
  }
}

TEST(Farm, TheImageContainsThePartsRenderedInTime) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const List more{"-mode", "path", "-time", "1000"};
  place.Missing(4, more);
  for (const int i : {1, 2, 4}) EXPECT_EQ(place.Part(i, 4, more).status, 0);
  EXPECT_EQ(place.Missing(4, more), "3\n");
  ShiftPlan(place, -std::chrono::seconds(2000));
  EXPECT_EQ(place.Missing(4, more), "") << "nobody waits for the machine that is late";
  const Finished late = place.Part(3, 4, more);
  EXPECT_EQ(late.status, 0) << late.error;
  std::filesystem::remove(place / NameOfPart(3, 4));
  const Finished done = RunProgram(With({place.Scene(), place / "out.png", "-width", "40", "-height", "30", "-parts",
                                         place / "out.png.part-*", "-report", place / "out.json"},
                                        more));
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_TRUE(Has(done.output, "stopped by time after 2")) << done.output;
  const auto report = nlohmann::json::parse(ReadFile(place / "out.json"));
  EXPECT_EQ(report["samples"]["least"], 0) << "of the late part";
  EXPECT_EQ(report["samples"]["most"], 1);
}

TEST(Farm, ATimedPartWithoutAPlanIsRefused) {
  NEEDS_THE_PROGRAM();
  const PartsPlace place;
  const Finished part = place.Part(1, 2, {"-time", "5"});
  EXPECT_EQ(part.status, 2);
  EXPECT_TRUE(Has(part.error, "out.png.plan") && Has(part.error, "-missing n writes it")) << part.error;
}

}  // namespace
}  // namespace ray::testing
