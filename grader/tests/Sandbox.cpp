#include "grader/Sandbox.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;
using grade::RunResult;
using grade::Sandbox;

/// A folder that the sandbox's user may write to, whoever runs the tests.
struct Workplace : TemporaryFolder {
  Workplace() { fs::permissions(Path(), fs::perms::all); }
};

std::string Hostile(const std::string& name) {
  return fs::absolute(project::Root() / "grader/tests/hostile" / (name + ".sh")).string();
}

std::vector<Sandbox> Sandboxes() {
  std::vector<Sandbox> all{Sandbox(Sandbox::Mode::limits)};
  const Sandbox best(Sandbox::Mode::automatic);
  if (best.IsolatesPrograms()) all.push_back(best);
  return all;
}

RunResult RunHostile(const Sandbox& sandbox, const Workplace& place, const std::string& name) {
  const grade::Limits limits{.seconds = 1, .memory = 256, .file_bytes = 1 << 20};
  const auto begin = std::chrono::steady_clock::now();
  const RunResult result = sandbox.Run({"/bin/sh", Hostile(name), place / "image.png", place / "scene", "/nowhere"},
                                       place.Path(), {}, limits);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << name;
  return result;
}

TEST(Sandbox, AProgramThatNeverEndsIsStopped) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    const RunResult result = RunHostile(sandbox, place, "sleeper");
    EXPECT_EQ(result.end, RunResult::End::timed_out)
        << sandbox.Describe() << "\n" << result.Problem() << "\n" << result.output;
  }
}

TEST(Sandbox, EndlessOutputEndsAProgram) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    const RunResult result = RunHostile(sandbox, place, "endless_output");
    EXPECT_EQ(result.end, RunResult::End::too_much_output) << result.Problem();
    EXPECT_LE(result.output.size(), 16384U);
  }
}

TEST(Sandbox, FilesStayBelowTheirLimit) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    EXPECT_FALSE(RunHostile(sandbox, place, "huge_file").IsGood());
    EXPECT_LE(fs::file_size(place / "image.png"), std::uintmax_t{1} << 20);
  }
}

TEST(Sandbox, ASignalIsReportedByName) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    const RunResult result = RunHostile(sandbox, place, "crasher");
    EXPECT_TRUE(Has(result.Problem(), "signal 11")) << result.Problem() << sandbox.Describe();
  }
}

TEST(Sandbox, MemoryHasALimit) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    EXPECT_EQ(RunHostile(sandbox, place, "memory").end, RunResult::End::out_of_memory);
  }
}

TEST(Sandbox, KindsOfFailureAreDistinguished) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    const auto end = [&](const std::vector<std::string>& command) {
      const RunResult result = sandbox.Run(command, place.Path(), {}, {.seconds = 2, .file_bytes = 1 << 20});
      return std::pair(result.end, result.Problem());
    };
    const auto killed = end({"/bin/sh", "-c", "kill -KILL $$"});
    EXPECT_EQ(killed.first, RunResult::End::signaled);
    EXPECT_TRUE(Has(killed.second, "killed")) << killed.second;
    EXPECT_EQ(end({"/bin/sh", "-c", "kill -XCPU $$"}).first, RunResult::End::out_of_cpu);
    EXPECT_EQ(end({"/bin/sh", "-c", "exec cat /dev/zero > big"}).first, RunResult::End::large_file);
    EXPECT_EQ(end({"/bin/sh", "-c", "echo std::bad_alloc; exit 1"}).first, RunResult::End::out_of_memory);
    EXPECT_EQ(end({"/nowhere/tracer"}).first, RunResult::End::no_program);
    // A file that a program's own shell does not find is its own failure.
    EXPECT_EQ(end({"/bin/sh", "-c", "/nowhere/tracer"}).first, RunResult::End::exited);
    fs::permissions(WriteFile(place / "plain", "text"), fs::perms::others_read | fs::perms::owner_read);
    EXPECT_TRUE(Has(end({place / "plain"}).second, "must be executable")) << end({place / "plain"}).second;
    fs::permissions(WriteFile(place / "script", "#!/nowhere/sh\n"), fs::perms::all);
    EXPECT_TRUE(Has(end({place / "script"}).second, "interpreter")) << end({place / "script"}).second;
  }
}

// It was aborted before it was the program, because its arguments did not fit into the grader's free memory.
TEST(Sandbox, AProgramMayHaveLessMemoryThanTheGraderUses) {
  constexpr std::size_t much = std::size_t{1} << 28;
  const std::unique_ptr<char[]> of_the_grader(new char[much]);
  const Workplace place;
  std::vector<std::string> command(50000, "word");
  command[0] = "/bin/true";
  const RunResult result =
      Sandbox(Sandbox::Mode::limits).Run(command, place.Path(), {}, {.seconds = 10, .memory = 64});
  EXPECT_TRUE(result.IsGood()) << result.Problem() << "\n" << result.output;
}

TEST(Sandbox, NothingThatAProgramStartedOutlivesIt) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    RunHostile(sandbox, place, "leaver");
    for (const auto& process : fs::directory_iterator("/proc")) {
      const std::string command = process.path() / "cmdline";
      if (!fs::exists(command)) continue;
      EXPECT_FALSE(Has(ReadFile(command), std::string("sleep\0"
                                                      "611",
                                                      9)))
          << process.path();
    }
  }
}

TEST(Sandbox, AStoppedGraderStopsTheProgram) {
  for (const Sandbox& sandbox : Sandboxes()) {
    const Workplace place;
    const std::atomic<bool> stop = true;
    const RunResult result = sandbox.Run({"/bin/sleep", "60"}, place.Path(), {}, {.seconds = 30}, &stop);
    EXPECT_EQ(result.end, RunResult::End::interrupted) << sandbox.Describe();
    EXPECT_LT(result.seconds, 5);
  }
}

TEST(Sandbox, BubblewrapProtectsFiles) {
  const Sandbox sandbox(Sandbox::Mode::automatic);
  if (!sandbox.IsolatesPrograms()) GTEST_SKIP() << sandbox.Describe();
  const Workplace place, scenes, other;
  WriteFile(scenes / "a.scn", "scene");
  WriteFile(other / "diary", "dear diary");
  const std::string vandal = WriteFile(scenes / "vandal.sh", ReadFile(Hostile("vandal")));
  sandbox.Run({"/bin/sh", vandal, place / "image.png", scenes / "a.scn", other.Path().string()}, place.Path(), {},
              {.seconds = 2});
  EXPECT_EQ(ReadFile(scenes / "a.scn"), "scene");
  EXPECT_EQ(ReadFile(other / "diary"), "dear diary");
  EXPECT_FALSE(fs::exists(scenes / "vandal.sh.new"));
}

TEST(Sandbox, BubblewrapHidesTheMachine) {
  const Sandbox sandbox(Sandbox::Mode::automatic);
  if (!sandbox.IsolatesPrograms()) GTEST_SKIP() << sandbox.Describe();
  const Workplace place;
  const TemporaryFolder other;
  WriteFile(other / "secret", "secret");
  const grade::Limits limits{.seconds = 2};
  EXPECT_FALSE(sandbox.Run({"/bin/sh", "-c", "cat </etc/passwd"}, place.Path(), {}, limits).IsGood());
  EXPECT_FALSE(sandbox.Run({"/bin/sh", "-c", "cat " + other / "secret"}, place.Path(), {}, limits).IsGood());
  EXPECT_TRUE(sandbox.Run({"/bin/sh", "-c", "echo 1 > here"}, place.Path(), {}, limits).IsGood());
  // Node looks for settings of OpenSSL there, and ends without access.
  EXPECT_TRUE(sandbox.Run({"/bin/sh", "-c", "ls /etc/ssl"}, place.Path(), {}, limits).IsGood());
}

}  // namespace
}  // namespace ray::testing
