#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "source/app/options/OptionFacts.h"
#include "source/app/options/Options.h"
#include "source/film/PixelRectangle.h"

namespace ray {

/// Where in Options a value is kept. Made from one generic lambda, for reading and for writing.
template <class T>
struct Member {
  template <class Lambda>
  Member(Lambda)
      : write([](Options& options) -> T& { return Lambda{}(options); }),
        read([](const Options& options) -> const T& { return Lambda{}(options); }) {}
  T& (*write)(Options&);
  const T& (*read)(const Options&);
};

/// What an option takes, from where, into what.
template <class T>
struct Number {
  Member<T> member;
  T low, high;  // both allowed
};
struct Flag {  // given or not
  Member<bool> member;
};
struct OnOff {
  Member<bool> member;
};
struct OneNumberOf {
  Member<int> member;
  std::vector<int> choices;
};
struct OneNameOf {
  std::vector<std::string> (*choices)();
  std::string (*read)(const Options&);
  void (*write)(Options&, const std::string& name);  // one of the choices
  bool by_number = false;                            // the place in the list will do as well, from 0
};
/// What a file holds, and so which extensions it may have; a folder has none.
enum class FileKind { any, image, scene, scn, json, folder };
struct FileName {
  Member<std::string> member;
  FileKind kind = FileKind::any;
};
struct FileList {  // one or two, separated by a comma
  Member<std::vector<std::string>> member;
  FileKind kind = FileKind::any;
};
struct Repeated {  // the only kind that may be: a word each time
  Member<std::vector<std::string>> member;
  bool (*is_good)(const std::string& word);
  const char* range;  // in words
  std::optional<FileKind> kind{};
};
/// As many numbers as the option has arguments, kept as one value.
struct NumberList {
  std::vector<double> (*read)(const Options&);
  bool (*write)(Options&, std::span<const double>);  // false when they are out of range
  const char* range;                                 // in words
};
/// A word with a grammar of its own.
struct Word {
  bool (*store)(Options&, const std::string& word);  // false when it is none
  std::string (*show)(const Options&);
  const char* range;                              // in words
  std::vector<std::string> (*names)() = nullptr;  // those of its values that have one
  bool is_list = false;                           // of names, separated by commas
  bool may_be_number = false;                     // in a report, where it is one
};
struct Rectangle {
  Member<std::optional<PixelRectangle>> member;
};
/// What is printed instead of doing the program's own work.
using Answer = std::string (*)(const Options&);
struct PixelRequest {  // for one pixel of a scene
  Member<std::optional<Pixel>> member;
  Answer answer;
};
struct Request {
  Answer answer;             // null: what is asked must come before all else
  bool is_of_scene = false;  // which must be named then
  enum { nothing, perhaps, always } takes_subject = nothing;
  std::vector<std::string> (*subjects)() = nullptr;  // what the subject may be; null for a file name
  FileKind kind = FileKind::any;                     // of that file
};

using OptionValue =
    std::variant<Number<int>, Number<std::int64_t>, Number<std::uint64_t>, Number<double>, Flag, OnOff, OneNumberOf,
                 OneNameOf, FileName, Repeated, FileList, Rectangle, NumberList, Word, PixelRequest, Request>;

/// Whose option it is: `both` are raypro and rayview, which render scenes, `one` is another program.
enum class KnownTo { raypro, rayview, both, one, all };

/// One option. The parser, -help, the manual page, the completions, the report and docs/options.md all come from this
/// table.
struct OptionKind {
  const char* name;                    // without the dash
  KnownTo known_to;                    // two programs may each have an option of the same name
  OptionFacts facts;                   // what it changes, where it may stand, what it needs and excludes
  std::vector<const char*> aliases;    // understood everywhere, shown nowhere
  std::vector<const char*> arguments;  // their names
  OptionValue value;
  const char* unit;                     // may be empty
  const char* topic;                    // the heading in the help
  const char* help;                     // one line
  std::vector<const char*> commands{};  // that take it, of a program that has commands; none for a request
};

/// A command of a program that has several: its name comes first, then those of files.
struct CommandKind {
  const char* name;
  const char* files;  // their names in the usage line
  std::size_t fewest, most;
  const char* help;     // one line
  const char* details;  // of what it does and prints, in lines that fit a screen
};
std::vector<std::string> CommandNamesOf(const Program& program);
/// Null when the program has none of that name.
const CommandKind* FindCommand(const Program& program, const std::string& name);
bool Takes(const CommandKind& command, const OptionKind& option);

/// Every option of the program, by command or by topic.
inline std::span<const OptionKind> OptionTable(const Program& program) { return program.options(); }
/// The options of a list that the program knows.
std::vector<OptionKind> KnownOptions(std::vector<OptionKind> list, const Program& program);
/// By name or alias, without dashes; null when the program has none.
const OptionKind* FindOption(const Program& program, const std::string& name);
/// The headings of the help, in order; options of commands are under these instead.
std::vector<std::string> OptionTopics(const Program& program);

/// Stores what was typed behind an option, as many words as it takes arguments (none or one where that is open).
/// Throws UsageError that names option, value and range.
void Store(const OptionKind& option, std::span<const std::string> words, Options& options);

/// How many words must and may follow the option.
std::size_t FewestArguments(const OptionKind& option);
std::size_t MostArguments(const OptionKind& option);
bool MayBeRepeated(const OptionKind& option);

/// What may be typed: "1..1073741824 pixels", "on or off"; empty when anything may, or nothing.
std::string Range(const OptionKind& option);
/// The words an argument can be; empty when they are not a short list.
std::vector<std::string> Choices(const OptionKind& option);
/// The choices; or, where other words will do as well, those of a fixed meaning: "all", "one", "auto".
std::vector<std::string> NamedValues(const OptionKind& option);
/// What the file that it takes holds; none when it takes none.
std::optional<FileKind> FileOf(const OptionKind& option);
/// "-crop x0 y0 x1 y1"
std::string Synopsis(const OptionKind& option);
/// Whether it chooses how an image is made, rather than what the program does.
bool IsSetting(const OptionKind& option);
/// Whether it is a request that needs a scene.
bool IsOfScene(const OptionKind& option);
/// What the program prints for a request. None where it must come before all else.
Answer AnswerTo(const OptionKind& option);
/// The names of all options of which the fact is true, in the order of the table.
std::vector<std::string_view> OptionsWith(const Program& program, Fact fact);

}  // namespace ray
