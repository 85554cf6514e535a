#include "source/app/files/OutputFile.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>

#include "source/app/Status.h"
#include "source/app/files/TemporaryFile.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

namespace fs = std::filesystem;
using testing::Has;
using testing::ReadFile;
using testing::TemporaryFolder;
using testing::WriteFile;

std::span<const unsigned char> Bytes(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

/// Returns the message of the refusal, or "" if the name is accepted.
std::string Refusal(const std::string& name, const std::vector<std::string>& inputs = {}) {
  return project::MessageOf<OutputError>([&] { CheckOutput(name, inputs); });
}

TEST(OutputFile, IsWrittenWholeAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  WriteWhole(CheckOutput(folder / "out.ppm", {}), Bytes("new"));
  EXPECT_EQ(ReadFile(folder / "out.ppm"), "new");
  EXPECT_EQ(folder.Others({"out.ppm"}), std::vector<std::string>{});
}

TEST(OutputFile, CheckingLeavesNothingBehindAndAnOldFileAlone) {
  const TemporaryFolder folder;
  WriteFile(folder / "old.ppm", "old");
  EXPECT_EQ(Refusal(folder / "old.ppm"), "");
  EXPECT_EQ(Refusal(folder / "new.ppm"), "");
  EXPECT_EQ(ReadFile(folder / "old.ppm"), "old");
  EXPECT_EQ(folder.Others({"old.ppm"}), std::vector<std::string>{});
}

TEST(OutputFile, HasTheModeBitsThatTheUmaskLeaves) {
  const TemporaryFolder folder;
  for (const mode_t mask : {mode_t{022}, mode_t{077}, mode_t{0}}) {
    const mode_t before = umask(mask);
    WriteWhole(CheckOutput(folder / "out.ppm", {}), Bytes("x"));
    umask(before);
    struct stat now = {};
    stat((folder / "out.ppm").c_str(), &now);
    EXPECT_EQ(now.st_mode & 0777, 0666 & ~mask);
    fs::remove(folder / "out.ppm");
  }
}

/// Root may write anywhere; while this object lives, the process is an ordinary user.
class WithoutRights {
 public:
  WithoutRights() { is_nobody_ = seteuid(geteuid() == 0 ? nobody : geteuid()) == 0; }
  ~WithoutRights() {
    if (seteuid(before_) != 0) ADD_FAILURE() << "the rights did not come back";
  }
  bool Hold() const { return is_nobody_; }

 private:
  static constexpr uid_t nobody = 65534;
  uid_t before_ = geteuid();
  bool is_nobody_ = false;
};

struct stat StatusOf(const std::string& file) {
  struct stat status = {};
  EXPECT_EQ(stat(file.c_str(), &status), 0) << file;
  return status;
}

// Regression: an image that its owner had made private was readable by everybody after the next render.
TEST(OutputFile, KeepsTheModeBitsOfTheFileThatItReplaces) {
  const TemporaryFolder folder;
  const std::string file = WriteFile(folder / "out.ppm", "old");
  fs::create_symlink("out.ppm", folder / "link.ppm");
  for (const mode_t mode : {mode_t{0600}, mode_t{0664}, mode_t{0640}, mode_t{0666}, mode_t{0700}}) {
    ASSERT_EQ(chmod(file.c_str(), mode), 0);
    for (const char* name : {"out.ppm", "link.ppm"}) {
      WriteWhole(CheckOutput(folder / name, {}), Bytes("new"));
      EXPECT_EQ(StatusOf(file).st_mode & 07777, mode) << name;
    }
  }
  EXPECT_EQ(ReadFile(file), "new");
}

TEST(TemporaryFile, IsPrivateFromTheStartWhenReplacingAPrivateFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(chmod(WriteFile(folder / "out.ppm", "old").c_str(), 0600), 0);
  TemporaryFile file(folder / "out.ppm");
  file.Write(Bytes("new"));
  const auto names = folder.Others({"out.ppm"});
  ASSERT_EQ(names.size(), 1u);
  EXPECT_EQ(StatusOf(folder / names[0]).st_mode & 0777, 0600u);
}

TEST(OutputFile, KeepsOwnerAndGroupWhereTheSystemAllowsIt) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser may give files away";
  const TemporaryFolder folder;
  const std::string file = WriteFile(folder / "out.ppm", "old");
  ASSERT_EQ(chown(file.c_str(), 65534, 65533), 0);
  ASSERT_EQ(chmod(file.c_str(), 0640), 0);
  WriteWhole(CheckOutput(file, {}), Bytes("new"));
  EXPECT_EQ(StatusOf(file).st_uid, 65534u);
  EXPECT_EQ(StatusOf(file).st_gid, 65533u);
  EXPECT_EQ(StatusOf(file).st_mode & 0777, 0640u);
}

// A group that cannot be kept must not pass its permissions to another group.
TEST(OutputFile, OurGroupGetsNoRightsOfAnotherGroup) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser may give files away";
  const TemporaryFolder folder;
  ASSERT_EQ(chmod(folder.Path().c_str(), 0777), 0);
  const std::string file = WriteFile(folder / "out.ppm", "old");
  ASSERT_EQ(chown(file.c_str(), 0, 65533), 0);
  ASSERT_EQ(chmod(file.c_str(), 0662), 0);
  {
    const WithoutRights rights;
    ASSERT_TRUE(rights.Hold());
    WriteWhole(CheckOutput(file, {}), Bytes("new"));
  }
  EXPECT_EQ(ReadFile(file), "new");
  EXPECT_NE(StatusOf(file).st_gid, 65533u);
  EXPECT_EQ(StatusOf(file).st_mode & 0777, 0622u);
}

TEST(Extremes, K11_ImpossibleOutputFilesAreRefusedBeforeRendering) {
  const TemporaryFolder folder;
  WriteFile(folder / "file", "");
  EXPECT_TRUE(Has(Refusal(folder.Path().string()), "it is a folder"));
  EXPECT_TRUE(Has(Refusal("/dev/full"), "it is not a regular file"));
  EXPECT_TRUE(Has(Refusal(folder / "missing/out.ppm"), "does not exist"));
  EXPECT_TRUE(Has(Refusal(folder / "file/out.ppm"), "cannot write"));
  EXPECT_TRUE(Has(Refusal(folder / std::string(300, 'x')), "too long"));
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_TRUE(Has(Refusal(folder / "pipe"), "it is not a regular file"));
}

TEST(OutputFile, ALongNameThatTheFileSystemTakesIsTaken) {
  const TemporaryFolder folder;
  std::string name(251, 'x');
  name += ".ppm";
  WriteWhole(CheckOutput(folder / name, {}), Bytes("long"));
  EXPECT_EQ(ReadFile(folder / name), "long");
}

TEST(Extremes, K11_TheInputIsNotOverwrittenUnderAnyOfItsNames) {
  const TemporaryFolder folder;
  const std::string input = WriteFile(folder / "in.scn", "scene");
  fs::create_symlink("in.scn", folder / "link.ppm");
  fs::create_hard_link(input, folder / "hard.ppm");
  fs::create_directory(folder / "sub");
  for (const char* name : {"in.scn", "link.ppm", "hard.ppm", "sub/../in.scn"})
    EXPECT_TRUE(Has(Refusal(folder / name, {input}), "itself")) << name;
}

TEST(Extremes, K11_ALinkStaysALinkAndItsTargetIsReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  fs::create_symlink("there/real.ppm", folder / "link.ppm");  // the target does not exist yet
  const OutputFile output = CheckOutput(folder / "link.ppm", {});
  EXPECT_TRUE(output.is_link);
  WriteWhole(output, Bytes("picture"));
  EXPECT_TRUE(fs::is_symlink(folder / "link.ppm"));
  EXPECT_EQ(ReadFile(folder / "there/real.ppm"), "picture");

  fs::create_symlink("/dev/full", folder / "full.ppm");
  EXPECT_TRUE(Has(Refusal(folder / "full.ppm"), "it is not a regular file"));
  fs::create_symlink("ring.ppm", folder / "ring.ppm");
  EXPECT_TRUE(Has(Refusal(folder / "ring.ppm"), "too many levels of symbolic links"));
}

TEST(Extremes, L3_UnwritableFoldersAndFilesAreRefusedBeforeRendering) {
  const TemporaryFolder folder;
  WriteFile(folder / "old.ppm", "old");
  fs::create_directory(folder / "open");
  WriteFile(folder / "open/old.ppm", "old");
  fs::permissions(folder / "open", fs::perms::all);
  fs::permissions(folder / "open/old.ppm", static_cast<fs::perms>(0444));
  fs::permissions(folder.Path(), static_cast<fs::perms>(0555));
  {
    const WithoutRights rights;
    ASSERT_TRUE(rights.Hold());
    EXPECT_TRUE(Has(Refusal(folder / "new.ppm"), "Permission denied"));
    EXPECT_TRUE(Has(Refusal(folder / "old.ppm"), "Permission denied"));
    EXPECT_TRUE(Has(Refusal(folder / "open/old.ppm"), "Permission denied"));
    EXPECT_EQ(Refusal(folder / "open/new.ppm"), "");
  }
  fs::permissions(folder.Path(), fs::perms::owner_all);
}

TEST(Extremes, L3_AnImageWhoseFolderDisappearedIsKeptElsewhere) {
  TemporaryFolder refuge;
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  const OutputFile output = CheckOutput(folder / "there/out.ppm", {});
  fs::remove_all(folder / "there");
  setenv("TMPDIR", refuge.Path().c_str(), 1);
  std::string message;
  try {
    WriteWhole(output, Bytes("picture"));
  } catch (const OutputError& error) {
    message = error.what();
  }
  unsetenv("TMPDIR");
  const auto kept = refuge.Others({});
  ASSERT_EQ(kept.size(), 1u) << message;
  EXPECT_EQ(ReadFile(refuge / kept[0]), "picture");
  EXPECT_TRUE(Has(message, "it is kept as '" + refuge / kept[0] + "'")) << message;
}

TEST(OutputFile, LeftoversOfDeadProcessesAreRemovedAndOthersKept) {
  const TemporaryFolder folder;
  WriteFile(folder / ".out.ppm.raypro-1.tmp", "dead");
  WriteFile(folder / ".out.ppm.raypro-2.tmp", "alive");
  WriteFile(folder / ".other.ppm.raypro-1.tmp", "another image's");
  WriteFile(folder / "out.ppm.raypro-1.tmp", "somebody's own");
  const int alive = open((folder / ".out.ppm.raypro-2.tmp").c_str(), O_WRONLY);
  ASSERT_EQ(flock(alive, LOCK_EX), 0);
  CheckOutput(folder / "out.ppm", {});
  close(alive);
  auto left = folder.Others({});
  std::ranges::sort(left);
  EXPECT_EQ(left,
            (std::vector<std::string>{".other.ppm.raypro-1.tmp", ".out.ppm.raypro-2.tmp", "out.ppm.raypro-1.tmp"}));
}

TEST(TemporaryFile, TakesAnotherNameWhenItsOwnIsTaken) {
  const TemporaryFolder folder;
  TemporaryFile first(folder / "out.ppm");
  TemporaryFile second(folder / "out.ppm");
  first.Write(Bytes("first"));
  second.Write(Bytes("second"));
  first.Become();
  EXPECT_EQ(ReadFile(folder / "out.ppm"), "first");
  second.Become();
  EXPECT_EQ(ReadFile(folder / "out.ppm"), "second");
  EXPECT_EQ(folder.Others({"out.ppm"}), std::vector<std::string>{});
}

}  // namespace
}  // namespace ray
