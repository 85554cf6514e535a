#include "source/draw/Event.h"

#include <array>

#include "source/text/LowerCase.h"

namespace ray {
namespace {

struct NamedKey {
  Key key;
  const char* name;
};
constexpr std::array named_keys{
    NamedKey{Key::space, "Space"},    NamedKey{Key::comma, ","},         NamedKey{Key::minus, "-"},
    NamedKey{Key::period, "."},       NamedKey{Key::slash, "?"},         NamedKey{Key::equal, "="},
    NamedKey{Key::left_bracket, "["}, NamedKey{Key::right_bracket, "]"}, NamedKey{Key::escape, "Escape"},
    NamedKey{Key::enter, "Enter"},    NamedKey{Key::tab, "Tab"},         NamedKey{Key::backspace, "Backspace"},
    NamedKey{Key::left, "Left"},      NamedKey{Key::right, "Right"},     NamedKey{Key::up, "Up"},
    NamedKey{Key::down, "Down"},      NamedKey{Key::page_up, "PageUp"},  NamedKey{Key::page_down, "PageDown"},
    NamedKey{Key::home, "Home"},      NamedKey{Key::end, "End"},         NamedKey{Key::del, "Delete"},
};

bool IsBetween(Key key, Key first, Key last) { return first <= key && key <= last; }
int Distance(Key key, Key first) { return static_cast<int>(key) - static_cast<int>(first); }

}  // namespace

std::string NameOf(Key key) {
  if (IsBetween(key, Key::a, Key::z) || IsBetween(key, Key::digit_0, Key::digit_9))
    return std::string(1, static_cast<char>(key));
  if (IsBetween(key, Key::f1, Key::f12)) return "F" + std::to_string(1 + Distance(key, Key::f1));
  if (IsBetween(key, Key::pad_0, Key::pad_9)) return "Pad" + std::to_string(Distance(key, Key::pad_0));
  for (const NamedKey& named : named_keys)
    if (named.key == key) return named.name;
  return "unknown";
}

std::optional<Key> KeyNamed(const std::string& name) {
  const auto is_it = [&](Key key) { return LowerCase(NameOf(key)) == LowerCase(name); };
  const auto found_in = [&](Key first, Key last) -> std::optional<Key> {
    for (int k = static_cast<int>(first); k <= static_cast<int>(last); ++k)
      if (is_it(static_cast<Key>(k))) return static_cast<Key>(k);
    return {};
  };
  for (const auto& [first, last] : {std::pair{Key::a, Key::z}, std::pair{Key::digit_0, Key::digit_9},
                                    std::pair{Key::f1, Key::f12}, std::pair{Key::pad_0, Key::pad_9}})
    if (const auto key = found_in(first, last)) return key;
  for (const NamedKey& named : named_keys)
    if (is_it(named.key)) return named.key;
  return {};
}

std::string NameOf(Key key, const Modifiers& modifiers) {
  return std::string(modifiers.control ? "Control+" : "") + (modifiers.shift ? "Shift+" : "") + NameOf(key);
}

}  // namespace ray
