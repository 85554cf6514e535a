#include "source/app/rayview/Habits.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/Display.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::Variable;

TEST(PanelHabits, AreReadAsTheyWereWritten) {
  const testing::TemporaryFolder folder;
  const PanelSettings look{PanelTheme::light, 1.25, 412.5};
  SavePanelHabits(folder / "new/folder/rayview", look);
  EXPECT_EQ(LoadPanelHabits(folder / "new/folder/rayview"), look);
}

TEST(PanelHabits, OfAMissingFileAreTheDefaultsAndCreateNone) {
  const testing::TemporaryFolder folder;
  EXPECT_EQ(LoadPanelHabits(folder / "raypro/rayview"), PanelSettings());
  EXPECT_EQ(LoadPanelHabits(""), PanelSettings());
  EXPECT_TRUE(std::filesystem::is_empty(folder.Path()));
}

TEST(PanelHabits, MissingValuesAreTheDefaults) {
  EXPECT_EQ(ReadPanelHabits("theme light\n"), (PanelSettings{PanelTheme::light, 1, 0}));
  EXPECT_EQ(ReadPanelHabits(""), PanelSettings());
}

TEST(PanelHabits, ABrokenFileIsIgnoredWithAMessage) {
  const testing::TemporaryFolder folder;
  for (const char* text : {"theme pink\n", "letters 0\n", "letters 1e9\n", "width -1\n", "width nan\n", "width\n",
                           "theme light dark\n", "theme light\n\xff\n", "size 3\n"}) {
    const std::string file = testing::WriteFile(folder / "rayview", text);
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(LoadPanelHabits(file), PanelSettings()) << text;
    EXPECT_EQ(::testing::internal::GetCapturedStderr(),
              "rayview: " + file + " cannot be parsed; using the default panel layout\n")
        << text;
  }
}

TEST(PanelHabits, AFailureToSaveThemIsReported) {
  const testing::TemporaryFolder folder;
  testing::WriteFile(folder / "raypro", "a file, no folder");
  ::testing::internal::CaptureStderr();
  SavePanelHabits(folder / "raypro/rayview", PanelSettings());
  EXPECT_TRUE(::testing::internal::GetCapturedStderr().starts_with("rayview: cannot save the panel layout: "));
}

TEST(PanelHabits, AreInTheFolderForSettings) {
  const Variable home("HOME", "/home/someone");
  {
    const Variable config("XDG_CONFIG_HOME", "/config");
    EXPECT_EQ(PanelHabitsFile(), "/config/raypro/rayview");
  }
  for (const char* none : {static_cast<const char*>(nullptr), "", "relative"}) {
    const Variable config("XDG_CONFIG_HOME", none);
    EXPECT_EQ(PanelHabitsFile(), "/home/someone/.config/raypro/rayview");
    const Variable nowhere("HOME", nullptr);
    EXPECT_EQ(PanelHabitsFile(), "");
  }
}

}  // namespace
}  // namespace ray
