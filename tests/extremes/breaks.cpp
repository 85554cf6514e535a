// raypro broken off at any moment, by a signal, an allocation that fails, or a computer that stops: the picture of a
// name is the old one or the new one, whole, and what was rendered is not lost. script/robustness.sh does it all many
// times.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string lit_scene =
    "camera 0 1 6  0 -.1 -1  0 1 0  .4  .1 100\narea_light 1 1 1  0 3 0  0 -1 0  .8  1 0 0\n"
    "sphere -1  0 0 0  1\nbox -1  -2 -1.2 -2  2 -1 2\n";

bool HasCommand(const std::string& command) {
  return std::system(("command -v " + command + " >/dev/null").c_str()) == 0;
}

TEST(Extremes, L1_J3_RepeatedInterruptionsDoNotChangeTheImage) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place(lit_scene);
  const std::string picture = place / "out.pfm";
  const std::vector<std::string> words{place.Scene(), picture, "-width",      "96",    "-height", "96",
                                       "-samples",    "64",    "-checkpoint", "0.02s", "-quiet",  "-resume"};
  ASSERT_EQ(RunProgram(words).status, 0);
  const std::string whole = ReadFile(picture);
  const auto start = std::chrono::steady_clock::now();
  RunProgram(words);
  const double whole_run = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::mt19937 random(3);
  int breaks = 0, finished = 0;
  const int wanted = Rounds("RAYTESTS_BREAKS", 12);
  WriteFile(picture, "old");
  while (breaks < wanted) {
    Running running(words);
    std::this_thread::sleep_for(std::chrono::duration<double>(std::uniform_real_distribution(0.0, whole_run)(random)));
    running.Send(breaks % 2 ? SIGINT : SIGKILL);
    const Finished done = running.Wait();
    const std::string now = ReadFile(picture);
    ASSERT_TRUE(now == whole || now == "old") << "after " << breaks << " breaks: " << now.size() << " bytes";
    breaks += done.status != 0;
    if (done.status != 0) continue;
    ASSERT_TRUE(now == whole) << "after " << breaks << " breaks a resumed render is another image";
    EXPECT_EQ(place.Others({"in.scn", "out.pfm"}), nothing);
    WriteFile(picture, "old");
    ++finished;
  }
  ASSERT_EQ(RunProgram(words).status, 0);
  EXPECT_TRUE(ReadFile(picture) == whole);
  EXPECT_EQ(place.Others({"in.scn", "out.pfm"}), nothing);
  std::printf("%d breaks, %d renders finished between them\n", breaks, finished);
}

/// What a program wrote, in the order in which it did, and what a disk may hold of it when the power fails. Bytes may
/// be lost until their file is synced; names may be as they were until their folder is synced, and as they are now from
/// the moment of the call.
class PowerLoss {
 public:
  explicit PowerLoss(const std::string& name) { possible_[name] = {old_file}; }

  /// One line of strace -y; false for one that writes nothing.
  bool Read(const std::string& line) {
    const auto between = [&](const std::string& from, const std::string& to) {
      const std::size_t begin = line.find(from);
      if (begin == std::string::npos) return std::string();
      const std::size_t end = line.find(to, begin + from.size());
      return line.substr(begin + from.size(), end - begin - from.size());
    };
    const auto is_call = [&](const std::string& name) { return Has(line, name + "("); };
    const long result = std::atol(line.substr(line.rfind('=') + 1).c_str());
    if (result < 0 || !Has(line, ") ")) return false;
    const std::string opened = between("<", ">"), named = between("\"", "\"");
    if (is_call("openat") && Has(line, "O_CREAT"))
      Create(named);
    else if (is_call("write") && files_of_.contains(opened))
      files_[files_of_[opened]].written += result;
    else if (is_call("fsync") && files_of_.contains(opened))
      Sync(files_[files_of_[opened]]);
    else if (is_call("fsync"))
      SyncFolder();
    else if (is_call("rename"))
      Rename(named, between(", \"", "\""));
    else if (is_call("unlink"))
      Unlink(named);
    else
      return false;
    return true;
  }

  /// Whether everything that the name may lead to now is the old file, a whole new one, or (where allowed) none.
  bool IsWhole(const std::string& name, bool may_be_missing) const {
    const auto found = possible_.find(name);
    if (found == possible_.end()) return may_be_missing;
    return std::ranges::all_of(found->second, [&](int file) {
      if (file == no_file) return may_be_missing;
      return file == old_file || files_[static_cast<std::size_t>(file)].synced_at_rename;
    });
  }
  bool MayBeOld(const std::string& name) const { return possible_.at(name).contains(old_file); }
  std::size_t States() const {
    std::size_t states = 1;
    for (const auto& [name, files] : possible_) states *= files.size();
    return states;
  }

 private:
  static constexpr int old_file = -1, no_file = -2;
  struct File {
    long written = 0, synced = 0;
    bool synced_at_rename = false;
  };

  void Create(const std::string& name) {
    files_of_[name] = files_.size();
    files_.emplace_back();
  }
  static void Sync(File& file) { file.synced = file.written; }
  void Rename(const std::string& from, const std::string& to) {
    const std::size_t file = files_of_.at(from);
    files_[file].synced_at_rename = files_[file].synced == files_[file].written && files_[file].written > 0;
    if (!possible_.contains(to)) possible_[to] = {no_file};
    possible_[to].insert(static_cast<int>(file));
    newest_[to] = static_cast<int>(file);
  }
  void Unlink(const std::string& name) {
    possible_[name].insert(no_file);
    newest_[name] = no_file;
  }
  void SyncFolder() {
    for (const auto& [name, file] : newest_) possible_[name] = {file};
  }

  std::vector<File> files_;
  std::map<std::string, std::size_t> files_of_;  // by the name that they were made under
  std::map<std::string, std::set<int>> possible_;
  std::map<std::string, int> newest_;
};

TEST(Extremes, L1_ThePowerLossModelCatchesMissingOrLateSyncs) {
  const auto read = [](const std::vector<std::string>& calls) {
    PowerLoss disk("/f/out");
    for (const std::string& call : calls) disk.Read(call);
    return disk;
  };
  const std::string make = "openat(AT_FDCWD</>, \"/f/tmp\", O_WRONLY|O_CREAT, 0666) = 3</f/tmp>";
  const std::string fill = "write(3</f/tmp>, \"p\"..., 9) = 9", sync = "fsync(3</f/tmp>) = 0";
  const std::string rename = "rename(\"/f/tmp\", \"/f/out\") = 0", sync_folder = "fsync(3</f>) = 0";
  const PowerLoss whole = read({make, fill, sync, rename, sync_folder});
  EXPECT_TRUE(whole.IsWhole("/f/out", false));
  EXPECT_FALSE(whole.MayBeOld("/f/out"));
  EXPECT_FALSE(read({make, fill, rename, sync, sync_folder}).IsWhole("/f/out", false));
  EXPECT_FALSE(read({make, sync, rename}).IsWhole("/f/out", false));
  EXPECT_TRUE(read({make, fill, sync, rename}).MayBeOld("/f/out"));
  EXPECT_FALSE(read({"unlink(\"/f/out\") = 0"}).IsWhole("/f/out", false));
}

TEST(Extremes, L1_APowerFailureLeavesWholeFilesAndLosesNoWork) {
  NEEDS_THE_PROGRAM();
  if (!HasCommand("strace")) GTEST_SKIP() << "there is no strace here";
  const SceneFolder place(lit_scene);
  const std::string picture = place / "out.pfm", checkpoint = place / "out.partial.pfm.checkpoint";
  WriteFile(picture, "old");
  const std::string command =  // AddressSanitizer cannot look for leaks in what strace traces
      "ASAN_OPTIONS=detect_leaks=0 strace -y -s 1 -e trace=openat,write,fsync,rename,unlink -o " + (place / "log") +
      " " + ProgramName() + " " + place.Scene() + " " + picture +
      " -width 64 -height 64 -samples 64 -checkpoint 0.01s -threads 1 -quiet -restart -report " +
      (place / "report.json");
  if (std::system((command + " >/dev/null 2>&1").c_str()) != 0) GTEST_SKIP() << "strace may not trace here";

  PowerLoss disk(picture);
  std::ifstream log(place / "log");
  int calls = 0, checkpoints = 0;
  std::size_t states = 0;
  for (std::string line; std::getline(log, line);) {
    if (!disk.Read(line)) continue;
    ++calls;
    states += disk.States();
    checkpoints += Has(line, "rename(") && Has(line, checkpoint);
    EXPECT_TRUE(disk.IsWhole(picture, false)) << "call " << calls << ": " << line;
    EXPECT_TRUE(disk.IsWhole(checkpoint, true)) << "call " << calls << ": " << line;
    EXPECT_TRUE(disk.IsWhole(place / "report.json", true)) << "call " << calls << ": " << line;
    EXPECT_FALSE(Has(line, "unlink(\"" + checkpoint) && disk.MayBeOld(picture)) << "the work is thrown away too early";
  }
  EXPECT_GT(checkpoints, 2);
  EXPECT_FALSE(disk.MayBeOld(picture)) << "the end of the program does not mean that the picture is on the disk";
  std::printf("%d calls, %d checkpoints, %zu states of the disk\n", calls, checkpoints, states);
}

#ifdef __GLIBC__
TEST(Extremes, L7_AnyFailedAllocationLeavesAWholeImageAndAStatus) {
  NEEDS_THE_PROGRAM();
  NEEDS_NO_SANITIZER("no library of ours can make allocations fail");
  const SceneFolder place(lit_scene);
  const TemporaryFolder refuge;  // for what is kept elsewhere, and for the library
  const std::string library = refuge / "fail_allocation.so", count = refuge / "count";
  const char* root = std::getenv("RAYPRO_ROOT");
  const std::string source = std::string(root ? root : ".") + "/tests/extremes/fail_allocation.c";
  if (!HasCommand("cc") || std::system(("cc -shared -fPIC -o " + library + " '" + source + "'").c_str()) != 0)
    GTEST_SKIP() << "there is no C compiler here";
  fs::create_directory(refuge / "kept");
  std::map<std::string, std::string> environment{
      {"LD_PRELOAD", library}, {"COUNT_ALLOCATIONS", count}, {"TMPDIR", refuge / "kept"}};
  const std::vector<std::string> words{
      place.Scene(), place / "out.png",     "-width",  "40", "-height", "30", "-samples", "4", "-mode", "path",
      "-report",     place / "report.json", "-restart"};
  ASSERT_EQ(RunProgram(words, {.environment = environment}).status, 0);
  const R2::Image whole = Decode(place / "out.png").image;
  const long all = std::atol(ReadFile(count).c_str());
  ASSERT_GT(all, 500);

  // The first round of each pair fails one allocation, the second all from there on.
  const long rounds = std::min<long>(2 * all, Rounds("RAYTESTS_ALLOCATIONS", 60));
  int ended = 0;
  for (long round = 0; round < rounds; ++round) {
    const long which = round * all / rounds;
    WriteFile(place / "out.png", "old");
    fs::remove(place / "report.json");
    environment["FAIL_ALLOCATION"] = std::to_string(which);
    if (round % 2)
      environment["EXHAUST_MEMORY"] = "yes";
    else
      environment.erase("EXHAUST_MEMORY");
    const Finished done = RunProgram(words, {.environment = environment});
    const std::string story =
        "allocation " + std::to_string(which) + (round % 2 ? " and all after it: " : ": ") + done.error;
    EXPECT_EQ(done.signal, 0) << story;
    EXPECT_TRUE(done.status >= 0 && done.status <= 4) << story;
    const bool is_old = ReadFile(place / "out.png") == "old";
    EXPECT_TRUE(is_old ? done.status != 0 : Decode(place / "out.png").image == whole) << story;
    EXPECT_TRUE(done.status == 0 || !done.error.empty()) << story << "no message";
    EXPECT_EQ(place.Others({"in.scn", "out.png", "report.json"}), nothing) << story;
    ended += done.status != 0;
  }
  std::printf("%ld failures among %ld allocations, %d of them ended the program\n", rounds, all, ended);
}
#endif

}  // namespace
}  // namespace ray::testing
