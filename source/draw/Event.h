#pragma once

#include <optional>
#include <string>
#include <variant>

namespace ray {

/// A physical key, not the character it types. Letters, digits and signs have their (upper-case) ASCII codes.
// clang-format off
enum class Key : int {
  none = 0,
  space = ' ', comma = ',', minus = '-', period = '.', slash = '/',
  digit_0 = '0', digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
  equal = '=',
  a = 'A', b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
  left_bracket = '[', right_bracket = ']',
  escape = 256, enter, tab, backspace, left, right, up, down, page_up, page_down, home, end, del,
  f1 = 301, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
  pad_0 = 400, pad_1, pad_2, pad_3, pad_4, pad_5, pad_6, pad_7, pad_8, pad_9
};
// clang-format on

struct Modifiers {
  bool shift = false, control = false;
  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

enum class Button { left, middle, right };

// Positions are in pixels of the drawing from its lower left corner.
struct KeyEvent {
  Key key = Key::none;
  Modifiers modifiers;
  bool is_pressed = true;
};
struct TextEvent {   // typed text, for text fields; without blanks, which have keys
  std::string text;  // UTF-8
};
struct ButtonEvent {
  Button button = Button::left;
  bool is_pressed = true;
  double x = 0, y = 0;
  Modifiers modifiers;
};
struct MoveEvent {  // by the pointer
  double x = 0, y = 0;
};
struct ScrollEvent {
  double steps = 0;  // away from the user
  double x = 0, y = 0;
};
struct ResizeEvent {
  int width = 0, height = 0;
  double scale = 1;  // > 0: pixels per unit of length, 2 on a screen twice as dense as usual
};
struct DropEvent {
  std::string file;
};
struct TickEvent {  // the passing of time
  double seconds = 0;
};
struct CloseEvent {};

/// Any input to the viewer.
using Event = std::variant<KeyEvent, TextEvent, ButtonEvent, MoveEvent, ScrollEvent, ResizeEvent, DropEvent, TickEvent,
                           CloseEvent>;

/// Returns the name of a key in scripts and help: "S", "F1", "Escape", "Pad1", "[".
std::string NameOf(Key key);
/// Returns the key with a name, ignoring case; std::nullopt if there is none.
std::optional<Key> KeyNamed(const std::string& name);
/// Returns a name such as "Control+Shift+S".
std::string NameOf(Key key, const Modifiers& modifiers);

}  // namespace ray
