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

/// The location of a value in Options. Made from one generic lambda, for reading and for writing.
template <class T>
struct Member {
  template <class Lambda>
  Member(Lambda)
      : write([](Options& options) -> T& { return Lambda{}(options); }),
        read([](const Options& options) -> const T& { return Lambda{}(options); }) {}
  T& (*write)(Options&);
  const T& (*read)(const Options&);
};

/// A number in a range, and the location of its value.
template <class T>
struct Number {
  Member<T> member;
  T low, high;  // inclusive
};
struct Flag {  // present or not
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
  bool by_number = false;                            // the position in the list, from 0, is also accepted
};
/// The contents of a file, which determine its extensions; a folder has none.
enum class FileKind { any, image, scene, scn, json, folder };
struct FileName {
  Member<std::string> member;
  FileKind kind = FileKind::any;
};
struct FileList {  // one or two, separated by a comma
  Member<std::vector<std::string>> member;
  FileKind kind = FileKind::any;
};
struct Repeated {  // the only repeatable kind, one word each time
  Member<std::vector<std::string>> member;
  bool (*is_good)(const std::string& word);
  const char* range;  // a description
  std::optional<FileKind> kind{};
};
/// One number per argument of the option, stored as one value.
struct NumberList {
  std::vector<double> (*read)(const Options&);
  bool (*write)(Options&, std::span<const double>);  // false if they are out of range
  const char* range;                                 // a description
};
/// A word with its own grammar.
struct Word {
  bool (*store)(Options&, const std::string& word);  // false if it is invalid
  std::string (*show)(const Options&);
  const char* range;                              // a description
  std::vector<std::string> (*names)() = nullptr;  // the names among its values
  bool is_list = false;                           // of names, separated by commas
  bool may_be_number = false;                     // written as a number in a report, if it is one
};
struct Rectangle {
  Member<std::optional<PixelRectangle>> member;
};
/// A function whose output replaces the program's own work.
using Answer = std::string (*)(const Options&);
struct PixelRequest {  // for one pixel of a scene
  Member<std::optional<Pixel>> member;
  Answer answer;
};
struct Request {
  Answer answer;             // null: the request must come first
  bool is_of_scene = false;  // a scene must be named
  enum { nothing, perhaps, always } takes_subject = nothing;
  std::vector<std::string> (*subjects)() = nullptr;  // the allowed subjects; null for a file name
  FileKind kind = FileKind::any;                     // of the subject, if it is a file
};

using OptionValue =
    std::variant<Number<int>, Number<std::int64_t>, Number<std::uint64_t>, Number<double>, Flag, OnOff, OneNumberOf,
                 OneNameOf, FileName, Repeated, FileList, Rectangle, NumberList, Word, PixelRequest, Request>;

/// The programs with an option: `both` are raypro and rayview, which render scenes, `one` is another program.
enum class KnownTo { raypro, rayview, both, one, all };

/// One option. The parser, -help, the manual page, the completions, the report and docs/options.md are all made from
/// this table.
struct OptionKind {
  const char* name;                    // without the dash
  KnownTo known_to;                    // two programs may have different options with the same name
  OptionFacts facts;                   // what it changes, where it is allowed, what it needs and excludes
  std::vector<const char*> aliases;    // accepted everywhere, shown nowhere
  std::vector<const char*> arguments;  // their names
  OptionValue value;
  const char* unit;                     // may be empty
  const char* topic;                    // the heading in the help
  const char* help;                     // one line
  std::vector<const char*> commands{};  // the commands with this option, if the program has commands
};

/// A command of a program that has several: its name comes first, followed by file names.
struct CommandKind {
  const char* name;
  const char* files;  // their names in the usage line
  std::size_t fewest, most;
  const char* help;     // one line
  const char* details;  // about its work and output, in lines that fit a screen
};
std::vector<std::string> CommandNamesOf(const Program& program);
/// Returns the program's command with the given name, or null.
const CommandKind* FindCommand(const Program& program, const std::string& name);
bool Takes(const CommandKind& command, const OptionKind& option);

/// Returns every option of the program, by command or by topic.
inline std::span<const OptionKind> OptionTable(const Program& program) { return program.options(); }
/// Returns the options of a list that apply to the program.
std::vector<OptionKind> KnownOptions(std::vector<OptionKind> list, const Program& program);
/// Returns the option with that name or alias, without dashes, or null.
const OptionKind* FindOption(const Program& program, const std::string& name);
/// Returns the headings of the help, in order; options of commands are listed under these instead.
std::vector<std::string> OptionTopics(const Program& program);

/// Stores the arguments of an option, as many words as it takes (none or one if that is open). Throws UsageError with
/// option, value and range.
void Store(const OptionKind& option, std::span<const std::string> words, Options& options);

/// Returns the minimum number of words after the option. MostArguments returns the maximum.
std::size_t FewestArguments(const OptionKind& option);
std::size_t MostArguments(const OptionKind& option);

/// Returns the allowed values: "1..1073741824 pixels", "on or off"; empty if anything, or nothing, is allowed.
std::string Range(const OptionKind& option);
/// Returns the allowed words of an argument; empty if they are not a short list.
std::vector<std::string> Choices(const OptionKind& option);
/// Returns the choices, or the words with a fixed meaning if others are allowed too: "all", "one", "auto".
std::vector<std::string> NamedValues(const OptionKind& option);
/// Returns the kind of the file that it takes, if any.
std::optional<FileKind> FileOf(const OptionKind& option);
/// Returns "-crop x0 y0 x1 y1".
std::string Synopsis(const OptionKind& option);
/// Returns true if it affects how an image is made, rather than what the program does.
bool IsSetting(const OptionKind& option);
/// Returns true if it is a request that needs a scene.
bool IsOfScene(const OptionKind& option);
/// Returns the function that answers a request. Null if it must come first.
Answer AnswerTo(const OptionKind& option);
/// Returns the names of all options with the fact, in the order of the table.
std::vector<std::string_view> OptionsWith(const Program& program, Fact fact);

}  // namespace ray
