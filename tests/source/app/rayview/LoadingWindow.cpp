#include "source/app/rayview/LoadingWindow.h"

#include <gtest/gtest.h>

#ifdef RAYVIEW_GLFW

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include "tests/Display.h"
#include "tests/Project.h"

namespace ray {
namespace {

class LoadingWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::HasServerAndUser()) GTEST_SKIP() << "Xvfb or xdotool is not installed";
    server.emplace();
    if (server->Display().empty()) GTEST_SKIP() << "Xvfb does not start here";
    display.emplace("DISPLAY", server->Display().c_str());
  }
  static bool IsSeen(const std::string& title) {
    const std::string line = "timeout 20 xdotool search --onlyvisible --name '" + title + "' >/dev/null 2>&1";
    for (int i = 0; i < 100; ++i) {
      if (std::system(line.c_str()) == 0) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }

  std::optional<testing::Server> server;
  std::optional<testing::Variable> display;
};

// Regression: the window was empty while ten million triangles were read.
TEST_F(LoadingWindow, NamesTheFileUntilItIsRead) {
  std::promise<std::shared_ptr<const LoadedScene>> scene;
  const auto loading = scene.get_future();
  bool is_seen = false;
  std::thread user([&] {
    is_seen = IsSeen("^rayview: reading hello.scn, [1-9]");
    scene.set_value(nullptr);
  });
  const auto window = WindowUntilLoaded(loading, 200, 100, "scenes/hello.scn");
  user.join();
  EXPECT_TRUE(is_seen);
  ASSERT_TRUE(window);
  EXPECT_EQ(window->Width(), 200);
}

TEST_F(LoadingWindow, IsNotOpenedForFilesThatLoadAtOnce) {
  std::promise<std::shared_ptr<const LoadedScene>> scene;
  scene.set_value(nullptr);
  EXPECT_FALSE(WindowUntilLoaded(scene.get_future(), 200, 100, "scenes/hello.scn"));
}

}  // namespace
}  // namespace ray

#endif
