#include "source/parse/Files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>

#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

std::string ErrorOf(const std::function<void()>& f) {
  try {
    f();
    return "(none)";
  } catch (const FileError& error) {
    return error.message + (error.hint.empty() ? "" : "; " + error.hint);
  }
}

std::string ReadNamed(const Files& files, const std::string& name, const fs::path& in) {
  return files.Read(files.Find(name, in.string()));
}

class ScopedCurrentFolder {
 public:
  explicit ScopedCurrentFolder(const fs::path& path) : before_(fs::current_path()) { fs::current_path(path); }
  ~ScopedCurrentFolder() { fs::current_path(before_); }

 private:
  fs::path before_;
};

TEST(Files, AreSearchedNextToTheFileThatNamesThem) {
  const Folder folder;
  folder.Write("sub/a.off", "sub");
  folder.Write("a.off", "top");
  const Files files(folder / "scene.scn", {});
  EXPECT_EQ(ReadNamed(files, "a.off", folder / "scene.scn"), "top");
  EXPECT_EQ(ReadNamed(files, "a.off", folder / "sub/inner.scn"), "sub");
  EXPECT_EQ(ReadNamed(files, "../a.off", folder / "sub/inner.scn"), "top");
  EXPECT_EQ(ReadNamed(files, (folder / "a.off").string(), folder / "sub/inner.scn"), "top");
}

TEST(Files, AreSearchedInTheCurrentFolderNext) {
  const Folder folder, current;
  current.Write("meshes/a.off", "current");
  const ScopedCurrentFolder here(current.Path());
  const Files files(folder / "scene.scn", {});
  EXPECT_EQ(ReadNamed(files, "meshes/a.off", folder / "scene.scn"), "current");
  folder.Write("meshes/a.off", "beside");
  EXPECT_EQ(ReadNamed(files, "meshes/a.off", folder / "scene.scn"), "beside");
}

// Scenes that were written for a program started elsewhere.
TEST(Files, UpwardPathsFallBackToTheScenesFolder) {
  const Folder folder;
  folder.Write("sub/textures/a.off", "beside");
  const Files files(folder / "sub/scene.scn", {});
  EXPECT_EQ(ReadNamed(files, "../textures/a.off", folder / "sub/scene.scn"), "beside");
  ASSERT_EQ(files.Remarks().size(), 1u);
  EXPECT_TRUE(Contains(*files.Remarks().begin(), "'../textures/a.off' does not exist; reading "));
  EXPECT_TRUE(
      Contains(ErrorOf([&] { files.Find("../none.off", (folder / "sub/scene.scn").string()); }), "no such file"));
  folder.Write("textures/a.off", "above");
  EXPECT_EQ(ReadNamed(Files(folder / "sub/scene.scn", {folder.Path().string()}), "../textures/a.off",
                      folder / "sub/scene.scn"),
            "above");
  EXPECT_TRUE(
      Contains(ErrorOf([&] { files.Find("../textures/a.off", (folder / "sub/scene.scn").string()); }), "is outside"));
}

// Scenes that were written on another computer.
TEST(Files, PathsOfAnotherComputerAreSearchedByName) {
  const Folder folder;
  folder.Write("sub/textures/a.png", "in textures");
  const std::string scene = (folder / "sub/scene.scn").string();
  for (const char* name : {"/home/nobody here/x/a.png", "C:\\Users\\me\\a.png", "D:/work/a.png",
                           "\\\\server\\share\\a.png", "~/a.png", "..\\..\\images\\a.png", "../../images/a.png"}) {
    const Files files(scene, {folder.Path().string()});
    EXPECT_EQ(ReadNamed(files, name, scene), "in textures") << name;
    EXPECT_EQ(ReadNamed(files, name, scene), "in textures");
    ASSERT_EQ(files.Remarks().size(), 1u) << name;
    EXPECT_TRUE(Contains(*files.Remarks().begin(), " does not exist; reading ")) << *files.Remarks().begin();
  }
  const auto read = [&] { return ReadNamed(Files(scene, {folder.Path().string()}), "/nowhere/a.png", scene); };
  folder.Write("sub/a.png", "beside");
  EXPECT_EQ(read(), "beside");
  std::filesystem::remove_all(folder / "sub/textures");
  std::filesystem::remove(folder / "sub/a.png");
  folder.Write("textures/a.png", "in textures above");
  EXPECT_EQ(read(), "in textures above");
  folder.Write("a.png", "above");
  EXPECT_EQ(read(), "above");
}

TEST(Files, OtherNamesAreNotSearchedElsewhere) {
  const Folder folder;
  folder.Write("textures/a.png", "x");
  const Files files(folder / "scene.scn", {});
  const std::string scene = (folder / "scene.scn").string();
  for (const char* name : {"a.png", "images/a.png", "/nowhere/", "C:a.png", "/nowhere/b.png", "file:///a.png"})
    EXPECT_TRUE(Contains(ErrorOf([&] { files.Find(name, scene); }), "no such file")) << name;
}

TEST(Files, OfAnotherComputerAreNotReadFromOutsideEither) {
  const Folder folder;
  folder.Write("textures/a.png", "x");
  folder.Write("sub/scene.scn", "");
  const Files files(folder / "sub/scene.scn", {});
  const std::string error = ErrorOf([&] { files.Find("/nowhere/a.png", (folder / "sub/scene.scn").string()); });
  EXPECT_TRUE(Contains(error, "-allow_path " + (folder / "textures").string())) << error;
}

TEST(Files, ABareSceneNameMeansTheCurrentFolder) {
  const Folder folder;
  folder.Write("a.off", "x");
  const ScopedCurrentFolder here(folder.Path());
  EXPECT_EQ(ReadNamed(Files("scene.scn", {}), "a.off", "scene.scn"), "x");
}

TEST(Extremes, K2_LinksSwappedInAfterTheCheckAreNotFollowed) {
  const Folder folder, outside;
  outside.Write("a.off", "secret");
  folder.Write("sub/a.off", "harmless");
  const Files files(folder / "scene.scn", {});
  const FoundFile found = files.Find("sub/a.off", (folder / "s").string());
  fs::remove(folder / "sub/a.off");
  fs::create_symlink(outside / "a.off", folder / "sub/a.off");
  EXPECT_TRUE(Contains(ErrorOf([&] { files.Read(found); }), "cannot open"));
  fs::remove_all(folder / "sub");
  fs::create_directory_symlink(outside.Path(), folder / "sub");
  EXPECT_TRUE(Contains(ErrorOf([&] { files.Read(found); }), "cannot open"));
}

TEST(Extremes, K8_NamesAreBytes) {
  const Folder folder;
  const std::string odd = "a\xFF\x1b.off";
  folder.Write(odd, "x");
  const Files files(folder / "scene.scn", {});
  EXPECT_EQ(ReadNamed(files, odd, folder / "s"), "x");
  EXPECT_EQ(ErrorOf([&] { files.Find("\x1b[31m", (folder / "s").string()); }), "no such file: '\\x1b[31m'");
  EXPECT_TRUE(Contains(ErrorOf([&] { files.Find(std::string(10000, 'x'), (folder / "s").string()); }), "cannot open"));
}

TEST(Files, AnUnreadableSceneIsAnError) {
  const Folder folder;
  folder.Write("scene.scn", "");
  fs::permissions(folder / "scene.scn", fs::perms::none);
  if (geteuid() == 0) GTEST_SKIP() << "the superuser reads everything";
  EXPECT_TRUE(Contains(ReportOf(folder, "scene.scn"), "cannot open"));
}

}  // namespace
}  // namespace ray
