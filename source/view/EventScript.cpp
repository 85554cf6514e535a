#include "source/view/EventScript.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "source/parse/Tokenizer.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

constexpr std::array button_names{"left", "middle", "right"};
constexpr int drag_moves = 8;
constexpr double least_scale = 0.5, most_scale = 8;  // of screens that there are, and twice as far
constexpr double most_seconds = 3600;                // of a step

std::string Named(Button button) { return button_names[static_cast<std::size_t>(button)]; }

std::string WithModifiers(const Modifiers& modifiers) {
  return std::string(modifiers.control ? " Control" : "") + (modifiers.shift ? " Shift" : "");
}

/// Reads one script; every mistake is kept, and its line is ignored.
class Reader {
 public:
  explicit Reader(const Text& text) : text_(text), tokens_(text, Tokenizer::Comments::hash) {}

  std::vector<ScriptStep> Read() {
    while (const auto word = tokens_.Next()) {
      try {
        ReadStep(*word);
      } catch (const SceneError& error) {
        errors_.push_back(error);
        tokens_.SkipLine(word->line);
      }
    }
    if (!errors_.empty()) throw SceneErrors(errors_);
    return std::move(steps_);
  }

 private:
  /// A step: its first word, and the function that reads the rest of its line.
  struct Step {
    std::string_view name;
    void (Reader::*read)();
  };

  void ReadStep(const Token& word) {
    static constexpr std::array<Step, 19> steps{{{"screenshot", &Reader::ReadScreenshot},
                                                 {"origin", &Reader::ReadOrigin},
                                                 {"print", &Reader::ReadPrint},
                                                 {"panel", &Reader::ReadPanel},
                                                 {"key", &Reader::ReadKey},
                                                 {"type", &Reader::ReadType},
                                                 {"press", &Reader::ReadPress},
                                                 {"release", &Reader::ReadRelease},
                                                 {"down", &Reader::ReadDown},
                                                 {"up", &Reader::ReadUp},
                                                 {"move", &Reader::ReadMove},
                                                 {"click", &Reader::ReadClick},
                                                 {"drag", &Reader::ReadDrag},
                                                 {"scroll", &Reader::ReadScroll},
                                                 {"resize", &Reader::ReadResize},
                                                 {"drop", &Reader::ReadDrop},
                                                 {"tick", &Reader::ReadTick},
                                                 {"close", &Reader::ReadClose},
                                                 {"wait", &Reader::ReadWait}}};
    line_ = word;
    const auto step = std::ranges::find(steps, word.text, &Step::name);
    if (step == steps.end()) {
      std::array<std::string_view, steps.size()> names;
      std::ranges::transform(steps, names.begin(), &Step::name);
      throw ErrorAt(text_, word, "unknown step " + Quoted(word.text), Suggestion(word.text, names, "steps"));
    }
    (this->*step->read)();
    const auto& next = tokens_.Peek();
    if (next && next->line == word.line)
      throw ErrorAt(text_, *next, "unexpected extra word after " + Quoted(word.text));
  }

  void ReadKey() {
    const auto [key, modifiers] = KeyWithModifiers();
    Add(KeyEvent{key, modifiers, true});
    Add(KeyEvent{key, modifiers, false});
  }
  void ReadPress() {
    const auto [key, modifiers] = KeyWithModifiers();
    Add(KeyEvent{key, modifiers, true});
  }
  void ReadRelease() {
    const auto [key, modifiers] = KeyWithModifiers();
    Add(KeyEvent{key, modifiers, false});
  }
  void ReadType() { Add(TextEvent{RestOfLine("what is typed")}); }
  void ReadDown() { ReadButton(true); }
  void ReadUp() { ReadButton(false); }
  void ReadButton(bool is_pressed) {
    const Button button = AButton();
    const double x = Number("x"), y = Number("y");
    Add(ButtonEvent{button, is_pressed, x, y, ModifiersAtEnd()});
  }
  void ReadMove() {
    const double x = Number("x"), y = Number("y");
    Add(MoveEvent{x, y});
  }
  void ReadClick() {
    const Button button = AButton();
    const double x = Number("x"), y = Number("y");
    const Modifiers modifiers = ModifiersAtEnd();
    Add(ButtonEvent{button, true, x, y, modifiers});
    Add(ButtonEvent{button, false, x, y, modifiers});
  }
  void ReadDrag() {
    const Button button = AButton();
    const double x0 = Number("x0"), y0 = Number("y0"), x1 = Number("x1"), y1 = Number("y1");
    const Modifiers modifiers = ModifiersAtEnd();
    Add(ButtonEvent{button, true, x0, y0, modifiers});
    for (int i = 1; i <= drag_moves; ++i)
      Add(MoveEvent{x0 + (x1 - x0) * i / drag_moves, y0 + (y1 - y0) * i / drag_moves});
    Add(ButtonEvent{button, false, x1, y1, modifiers});
  }
  void ReadScroll() {
    const double steps = Number("steps"), x = Number("x"), y = Number("y");
    Add(ScrollEvent{steps, x, y});
  }
  void ReadResize() {
    const int width = Whole("width"), height = Whole("height");
    const auto& next = tokens_.Peek();
    const bool has_scale = next && next->line == line_.line;
    Add(ResizeEvent{width, height, has_scale ? Scale() : 1});
  }
  void ReadDrop() { Add(DropEvent{RestOfLine("the name of a file")}); }
  void ReadTick() { Add(TickEvent{Seconds()}); }
  void ReadClose() { Add(CloseEvent{}); }
  void ReadWait() {
    const auto& next = tokens_.Peek();
    const std::string_view what = next && next->line == line_.line ? next->text : std::string_view();
    if (what == "trace") {
      tokens_.Next();
      Add(WaitForTrace{});
    } else if (what == "image") {
      tokens_.Next();
      Add(WaitForImage{});
    } else if (what == "rows") {
      tokens_.Next();
      Add(WaitForRows{Whole("rows")});
    } else {
      Add(WaitSeconds{Seconds()});
    }
  }
  void ReadOrigin() {
    const Token word = Word("top or bottom");
    if (word.text != "top" && word.text != "bottom") throw ErrorAt(text_, word, "the origin is top or bottom");
    Add(Origin{word.text == "bottom"});
  }
  void ReadScreenshot() { Add(Screenshot{RestOfLine("the name of an image file")}); }
  void ReadPanel() { Add(ClickPanel{RestOfLine("what is to be clicked in the panels")}); }
  void ReadPrint() { Add(PrintState{}); }

  void Add(decltype(ScriptStep::what) what) { steps_.push_back({std::move(what), line_}); }

  Token Word(const std::string& what) {
    const auto& next = tokens_.Peek();
    if (!next || next->line != line_.line) throw ErrorAt(text_, line_, what + " is missing");
    return *tokens_.Next();
  }

  double Number(const std::string& what) {
    const Token word = Word(what);
    const auto number = ParseNumber(word.text);
    if (number.problem) throw ErrorAt(text_, word, what + " " + number.problem);
    return number.value;
  }

  int Whole(const std::string& what) {
    const Token word = Word(what);
    const auto number = ParseWhole(word.text);
    constexpr std::int64_t most = 1 << 14;
    if (number.problem) throw ErrorAt(text_, word, what + " " + number.problem);
    if (number.value < 1 || number.value > most)
      throw ErrorAt(text_, word, what + " must be 1 to " + std::to_string(most));
    return static_cast<int>(number.value);
  }

  double Scale() {
    const Token word = Word("a scale");
    const auto number = ParseNumber(word.text);
    if (number.problem || number.value < least_scale || number.value > most_scale)
      throw ErrorAt(text_, word, "the scale must be a number from 0.5 to 8");
    return number.value;
  }

  double Seconds() {
    const Token word = Word("a number of seconds");
    const auto number = ParseNumber(word.text);
    if (number.problem || number.value < 0 || number.value > most_seconds)
      throw ErrorAt(text_, word, "seconds must be a number from 0 to 3600");
    return number.value;
  }

  Button AButton() {
    const Token word = Word("a button");
    for (std::size_t i = 0; i < button_names.size(); ++i)
      if (word.text == button_names[i]) return static_cast<Button>(i);
    throw ErrorAt(text_, word, "the button must be left, middle or right");
  }

  Modifiers ModifiersAtEnd() {
    Modifiers modifiers;
    while (tokens_.Peek() && tokens_.Peek()->line == line_.line) Take(*tokens_.Next(), modifiers);
    return modifiers;
  }

  void Take(const Token& word, Modifiers& modifiers) const { Take(word, word.text, modifiers); }
  void Take(const Token& word, std::string_view name, Modifiers& modifiers) const {
    if (name == "Shift")
      modifiers.shift = true;
    else if (name == "Control")
      modifiers.control = true;
    else
      throw ErrorAt(text_, word, "a modifier must be Shift or Control");
  }

  std::pair<Key, Modifiers> KeyWithModifiers() {
    const Token word = Word("a key");
    Modifiers modifiers;
    std::string_view name = word.text;
    for (std::size_t plus = name.find('+'); plus != std::string_view::npos && plus + 1 < name.size();
         plus = name.find('+')) {
      Take(word, name.substr(0, plus), modifiers);
      name.remove_prefix(plus + 1);
    }
    const auto key = KeyNamed(std::string(name));
    if (!key) throw ErrorAt(text_, word, "unknown key " + Quoted(name));
    return {*key, modifiers};
  }

  /// Returns the text after the first word unchanged, with blanks; # starts no comment.
  std::string RestOfLine(const std::string& what) {
    std::string_view rest(text_.bytes);
    rest.remove_prefix(static_cast<std::size_t>(line_.text.data() + line_.text.size() - rest.data()));
    rest = rest.substr(0, rest.find_first_of("\r\n"));
    constexpr std::string_view blanks = " \t";
    const std::size_t first = rest.find_first_not_of(blanks);
    if (first == std::string_view::npos) throw ErrorAt(text_, line_, what + " is missing");
    rest = rest.substr(first, rest.find_last_not_of(blanks) + 1 - first);
    tokens_.SkipLine(line_.line);
    return std::string(rest);
  }

  const Text& text_;
  Tokenizer tokens_;
  Token line_;  // the first word of it
  std::vector<ScriptStep> steps_;
  std::vector<SceneError> errors_;
};

}  // namespace

std::vector<ScriptStep> ReadEventScript(const Text& text) { return Reader(text).Read(); }

std::string ScriptLine(const Event& event) {
  const auto xy = [](double x, double y) { return " " + ToText(x) + " " + ToText(y); };
  struct Writer {
    decltype(xy)& at;
    std::string operator()(const KeyEvent& e) const {
      return (e.is_pressed ? "press " : "release ") + NameOf(e.key, e.modifiers) + "\n";
    }
    std::string operator()(const TextEvent& e) const { return "type " + e.text + "\n"; }
    std::string operator()(const ButtonEvent& e) const {
      return (e.is_pressed ? "down " : "up ") + Named(e.button) + at(e.x, e.y) + WithModifiers(e.modifiers) + "\n";
    }
    std::string operator()(const MoveEvent& e) const { return "move" + at(e.x, e.y) + "\n"; }
    std::string operator()(const ScrollEvent& e) const { return "scroll " + ToText(e.steps) + at(e.x, e.y) + "\n"; }
    std::string operator()(const ResizeEvent& e) const {
      if (e.width < 1 || e.height < 1) return {};
      return "resize " + std::to_string(e.width) + " " + std::to_string(e.height) +
             (e.scale == 1 ? "" : " " + ToText(e.scale)) + "\n";
    }
    std::string operator()(const DropEvent& e) const { return "drop " + e.file + "\n"; }
    std::string operator()(const TickEvent& e) const {
      std::string ticks;
      double left = e.seconds;
      for (; left > most_seconds; left -= most_seconds) ticks += "tick " + ToText(most_seconds) + "\n";
      return ticks + "tick " + ToText(left) + "\n";
    }
    std::string operator()(const CloseEvent&) const { return "close\n"; }
  };
  return std::visit(Writer{xy}, event);
}

}  // namespace ray
