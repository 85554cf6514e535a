#include <gtest/gtest.h>

#ifdef RAYVIEW_GLFW

#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <thread>

#include "source/draw/contexts/Context.h"
#include "source/draw/gl/Painter.h"
#include "tests/Display.h"

// Windows on a separate display, with keys and a pointer moved by xdotool; the only part that scripts of events cannot
// test.
namespace {

using namespace ray;
using ray::testing::Server;
using ray::testing::Variable;

TEST(WindowWithoutADisplay, IsReportedInALineWithAnAlternative) {
  const Variable x("DISPLAY", nullptr), wayland("WAYLAND_DISPLAY", nullptr);
  try {
    MakeWindow(100, 100, "none");
    FAIL() << "a window on no display";
  } catch (const ContextError& error) {
    const std::string why = error.what();
    EXPECT_EQ(why.substr(0, 21), "cannot open a display");
    EXPECT_NE(why.find("rayview -headless needs none"), std::string::npos) << why;
    EXPECT_EQ(why.find('\n'), std::string::npos) << why;
  }
}

class WindowOnADisplay : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!ray::testing::HasServerAndUser()) GTEST_SKIP() << "Xvfb or xdotool is not installed";
    server.emplace();
    if (server->Display().empty()) GTEST_SKIP() << "Xvfb does not start here";
    display.emplace("DISPLAY", server->Display().c_str());
    try {
      window = MakeWindow(320, 240, "a test");
    } catch (const ContextError& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// Applies `actions`, with %1 for the window, while the window does not wait.
  void Do(const std::string& actions) {
    const std::string line = "timeout 20 xdotool search --onlyvisible --name '^a test$' " + actions + " >/dev/null";
    for (int i = 0; i < 50 && std::system(line.c_str()) != 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }

  /// Returns the events up to the last expected one, for at most ten seconds.
  std::vector<Event> WaitFor(const std::function<bool(const Event&)>& is_last) {
    std::vector<Event> all;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < end)
      for (const Event& event : window->Wait(0.1)) {
        all.push_back(event);
        if (is_last(event)) return all;
      }
    ADD_FAILURE() << "what was waited for has not come";
    return all;
  }

  std::optional<Server> server;
  std::optional<Variable> display;
  std::unique_ptr<Window> window;  // destroyed first
};

template <typename Kind>
std::vector<Kind> Those(const std::vector<Event>& events) {
  std::vector<Kind> those;
  for (const Event& event : events)
    if (const Kind* one = std::get_if<Kind>(&event)) those.push_back(*one);
  return those;
}

bool IsReleaseOf(const Event& event, Key key) {
  const auto* of_key = std::get_if<KeyEvent>(&event);
  return of_key && of_key->key == key && !of_key->is_pressed;
}

TEST_F(WindowOnADisplay, DistinguishesKeysModifiersAndTheKeypad) {
  Do("windowfocus key --delay 20 s shift+s ctrl+F12 bracketleft KP_1 1 Escape Prior End");
  const auto events = WaitFor([](const Event& event) { return IsReleaseOf(event, Key::end); });
  std::vector<std::pair<Key, Modifiers>> pressed;
  for (const KeyEvent& event : Those<KeyEvent>(events))
    if (event.is_pressed) pressed.emplace_back(event.key, event.modifiers);
  const Modifiers none, shift{.shift = true}, control{.control = true};
  const std::vector<std::pair<Key, Modifiers>> expected{
      {Key::s, none},       {Key::s, shift},     {Key::f12, control},  {Key::left_bracket, none}, {Key::pad_1, none},
      {Key::digit_1, none}, {Key::escape, none}, {Key::page_up, none}, {Key::end, none}};
  ASSERT_EQ(pressed.size(), expected.size());
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    EXPECT_EQ(static_cast<int>(pressed[i].first), static_cast<int>(expected[i].first)) << i;
    EXPECT_TRUE(pressed[i].second == expected[i].second || expected[i].first == Key::pad_1) << i;
  }
}

// A query when the event is read would return the pointer's later position.
TEST_F(WindowOnADisplay, ReportsWhereButtonsWerePressedAndReleased) {
  Do("windowfocus mousemove --window %1 50 40 mousedown 3 mousemove --window %1 200 150 mouseup 3 "
     "mousemove --window %1 60 60 click 4 click 5 key q");
  const auto events = WaitFor([](const Event& event) { return IsReleaseOf(event, Key::q); });
  const auto buttons = Those<ButtonEvent>(events);
  ASSERT_EQ(buttons.size(), 2U);
  EXPECT_TRUE(buttons[0].is_pressed && buttons[0].button == Button::right);
  EXPECT_EQ(buttons[0].x, 50.5);
  EXPECT_EQ(buttons[0].y, 240 - 40.5);
  EXPECT_FALSE(buttons[1].is_pressed);
  EXPECT_EQ(buttons[1].x, 200.5);
  EXPECT_EQ(buttons[1].y, 240 - 150.5);
  const auto scrolls = Those<ScrollEvent>(events);
  ASSERT_EQ(scrolls.size(), 2U);
  EXPECT_EQ(scrolls[0].steps, 1);
  EXPECT_EQ(scrolls[1].steps, -1);
  EXPECT_EQ(scrolls[0].x, 60.5);
  EXPECT_EQ(scrolls[0].y, 240 - 60.5);
}

TEST_F(WindowOnADisplay, ReportsItsNewSize) {
  EXPECT_EQ(window->Width(), 320);
  EXPECT_EQ(window->Height(), 240);
  Do("windowsize %1 400 300");
  WaitFor([](const Event& event) {
    const auto* size = std::get_if<ResizeEvent>(&event);
    return size && size->width == 400 && size->height == 300;
  });
  EXPECT_EQ(window->Width(), 400);
  EXPECT_EQ(window->Height(), 300);
}

TEST_F(WindowOnADisplay, WaitsUntilItIsWokenFromAnotherThread) {
  while (!window->Wait(0.3).empty()) {
  }
  const auto start = std::chrono::steady_clock::now();
  std::thread other([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    WakeWindow();
  });
  window->Wait(30);
  other.join();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(WindowOnADisplay, DrawsTheSameAsAFramebuffer) {
  std::vector<R2::Image> images;
  for (const auto target : {Canvas::Target::window, Canvas::Target::own}) {
    Painter painter(target);
    painter.canvas.Begin(window->Width(), window->Height(), {0.2, 0.3, 0.4});
    const Lines lines{{{-1, -0.7F, 0}, {255, 0, 0, 255}}, {{1, 0.8F, 0}, {0, 255, 0, 255}}};
    painter.lists.Draw(*painter.lists.Upload(lines), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 3);
    PanelDrawing panels;
    panels.sheet = std::make_shared<const InkSheet>(InkSheet{1, 1, {255}});
    for (const auto& [x, y] : {std::pair{10.F, 10.F}, {40.F, 10.F}, {10.F, 30.F}})
      panels.corners.push_back({x, y, 0.5F, 0.5F, {255, 255, 255, 200}});
    panels.indices = {0, 1, 2};
    panels.parts = {{0, 0, 50, 50, 0, 3}};
    painter.panels.Draw(panels, painter.canvas);
    images.push_back(painter.canvas.Read());
    if (target == Canvas::Target::window) window->Show();
  }
  EXPECT_TRUE(images[0] == images[1]);
}

}  // namespace

#endif
