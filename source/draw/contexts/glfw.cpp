#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "source/draw/contexts/ContextKind.h"

// Windows through GLFW 3.3.
namespace ray {
namespace {

std::string LastError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

/// A range of the library's keys that corresponds to a range of ours.
struct KeyRange {
  int first, last;
  Key ours;
};

constexpr KeyRange key_ranges[] = {
    {GLFW_KEY_SPACE, GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_COMMA, GLFW_KEY_SLASH, Key::comma},
    {GLFW_KEY_0, GLFW_KEY_9, Key::digit_0},
    {GLFW_KEY_EQUAL, GLFW_KEY_EQUAL, Key::equal},
    {GLFW_KEY_A, GLFW_KEY_Z, Key::a},
    {GLFW_KEY_LEFT_BRACKET, GLFW_KEY_LEFT_BRACKET, Key::left_bracket},
    {GLFW_KEY_RIGHT_BRACKET, GLFW_KEY_RIGHT_BRACKET, Key::right_bracket},
    {GLFW_KEY_ESCAPE, GLFW_KEY_BACKSPACE, Key::escape},
    {GLFW_KEY_LEFT, GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_PAGE_UP, GLFW_KEY_END, Key::page_up},
    {GLFW_KEY_DELETE, GLFW_KEY_DELETE, Key::del},
    {GLFW_KEY_F1, GLFW_KEY_F12, Key::f1},
    {GLFW_KEY_KP_0, GLFW_KEY_KP_9, Key::pad_0},
    {GLFW_KEY_KP_ENTER, GLFW_KEY_KP_ENTER, Key::enter},
    {GLFW_KEY_KP_ADD, GLFW_KEY_KP_ADD, Key::equal},
    {GLFW_KEY_KP_SUBTRACT, GLFW_KEY_KP_SUBTRACT, Key::minus},
    {GLFW_KEY_KP_DECIMAL, GLFW_KEY_KP_DECIMAL, Key::period},
    {GLFW_KEY_KP_DIVIDE, GLFW_KEY_KP_DIVIDE, Key::slash},
};

Key KeyOf(int theirs) {
  for (const KeyRange& range : key_ranges)
    if (theirs >= range.first && theirs <= range.last)
      return static_cast<Key>(static_cast<int>(range.ours) + theirs - range.first);
  return Key::none;
}

/// Returns true for keys that repeat while held, such as those that step; keys that toggle must not flicker.
bool Repeats(Key key) {
  switch (key) {
    case Key::left:
    case Key::right:
    case Key::up:
    case Key::down:
    case Key::page_up:
    case Key::page_down:
    case Key::left_bracket:
    case Key::right_bracket:
    case Key::backspace:
    case Key::comma:
    case Key::period:
    case Key::minus:
    case Key::equal:
      return true;
    default:
      return false;
  }
}

/// Encodes a character of at most 21 bits as UTF-8.
std::string Utf8(unsigned int character) {
  if (character < 0x80) return {static_cast<char>(character)};
  const auto further = [&](int shift) { return static_cast<char>(0x80 | (character >> shift & 0x3F)); };
  if (character < 0x800) return {static_cast<char>(0xC0 | character >> 6), further(0)};
  if (character < 0x10000) return {static_cast<char>(0xE0 | character >> 12), further(6), further(0)};
  return {static_cast<char>(0xF0 | character >> 18), further(12), further(6), further(0)};
}

Modifiers ModifiersOf(int theirs) {
  return {.shift = (theirs & GLFW_MOD_SHIFT) != 0, .control = (theirs & GLFW_MOD_CONTROL) != 0};
}

/// The library, initialized while there is a window.
class Library {
 public:
  Library() {
    if (!glfwInit()) throw ContextError("cannot open a display (" + LastError() + "); rayview -headless needs none");
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

class GlfwWindow : public Window {
 public:
  GlfwWindow(int width, int height, const std::string& title) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
#ifdef __APPLE__
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // without it, wide lines would be forbidden elsewhere
#endif
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_TRUE);  // so that light is blended before it is encoded
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_)
      throw ContextError("cannot open a window with OpenGL 3.3 (" + LastError() + "); rayview -headless needs none");
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwGetFramebufferSize(window_, &width_, &height_);
    name_ = "glfw: " + CurrentRenderer();
    Listen();
  }

  ~GlfwWindow() override {
    glfwMakeContextCurrent(nullptr);
    glfwDestroyWindow(window_);
  }

  std::string Name() const override { return name_; }
  int Width() const override { return width_; }
  int Height() const override { return height_; }
  double Scale() const override {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return x > 0 ? x : 1;
  }
  void Show() override { glfwSwapBuffers(window_); }
  void SetTitle(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
  void SetClipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }

  std::vector<Event> Wait(double seconds) override {
    // The library has no endless wait; waking once per hour is harmless.
    constexpr double longest = 3600;
    if (events_.empty() && seconds > 0)
      glfwWaitEventsTimeout(std::min(seconds, longest));
    else
      glfwPollEvents();
    return std::exchange(events_, {});
  }

 private:
  static GlfwWindow& Of(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }

  void Listen() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
      Of(w).OnKey(KeyOf(key), action, ModifiersOf(mods));
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned int character) {
      if (character > ' ') Of(w).events_.emplace_back(TextEvent{Utf8(character)});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
      Of(w).OnButton(button, action == GLFW_PRESS, ModifiersOf(mods));
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { Of(w).OnMove(x, y); });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double steps) {
      GlfwWindow& self = Of(w);
      self.events_.emplace_back(ScrollEvent{steps, self.x_, self.y_});
    });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int width, int height) { Of(w).OnSize(width, height); });
    // A part of the window that was covered must be redrawn, as after a change of size.
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { Of(w).OnSize(Of(w).width_, Of(w).height_); });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** files) {
      for (int i = 0; i < count; ++i) Of(w).events_.emplace_back(DropEvent{files[i]});
    });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
      glfwSetWindowShouldClose(w, GLFW_FALSE);  // the receiver of the event decides
      Of(w).events_.emplace_back(CloseEvent{});
    });
  }

  void OnKey(Key key, int action, const Modifiers& modifiers) {
    if (key == Key::none || (action == GLFW_REPEAT && !Repeats(key))) return;
    events_.emplace_back(KeyEvent{key, modifiers, action != GLFW_RELEASE});
  }

  // The pointer's position is that of its last event: a query now would return its current one.
  void OnButton(int theirs, bool is_pressed, const Modifiers& modifiers) {
    if (theirs > GLFW_MOUSE_BUTTON_MIDDLE) return;
    const Button button = theirs == GLFW_MOUSE_BUTTON_LEFT    ? Button::left
                          : theirs == GLFW_MOUSE_BUTTON_RIGHT ? Button::right
                                                              : Button::middle;
    events_.emplace_back(ButtonEvent{button, is_pressed, x_, y_, modifiers});
  }

  // Converts the window's units, counted from the top, to the middle of a pixel of the drawing, counted from the
  // bottom: rounded down it is the pixel under the pointer.
  void OnMove(double x, double y) {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (width < 1 || height < 1) return;
    x_ = (x + 0.5) * width_ / width;
    y_ = height_ - (y + 0.5) * height_ / height;
    events_.emplace_back(MoveEvent{x_, y_});
  }

  void OnSize(int width, int height) {
    width_ = width, height_ = height;
    events_.emplace_back(ResizeEvent{width, height, Scale()});
  }

  Library library_;
  GLFWwindow* window_ = nullptr;
  int width_ = 0, height_ = 0;
  double x_ = 0, y_ = 0;
  std::string name_;
  std::vector<Event> events_;
};

}  // namespace

void WakeWindow() { glfwPostEmptyEvent(); }

bool HasWindows() { return true; }

std::unique_ptr<Window> MakeWindow(int width, int height, const std::string& title) {
  return std::make_unique<GlfwWindow>(width, height, title);
}

}  // namespace ray
