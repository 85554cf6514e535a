#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "source/app/rayimg/Options.h"

/// What rayimg understands, in one place: the parser, -help, the manual page, the completions and the README come from
/// these tables. raypro's table (source/app/options/OptionTable.h) is of one command and of its own options; this one
/// says of each option which commands take it.
namespace ray::rayimg {

// What an option takes, and where its value is kept.
struct Flag {
  bool Options::*member;
};
struct Number {
  double Options::*member;
  double low, high;  // both allowed
};
struct Threshold {  // none unless given
  std::optional<double> Options::*member;
  double high;  // at least 0
};
struct Whole {
  int Options::*member;
  int low, high;
};
struct OneName {
  std::string Options::*member;
  std::vector<std::string> choices;
};
struct File {
  std::string Options::*member;
};
struct Weights {
  std::vector<double> Options::*member;
};
using Value = std::variant<Flag, Number, Threshold, Whole, OneName, File, Weights>;

struct OptionKind {
  const char* name;      // without the dash
  const char* argument;  // its name; empty for none
  Value value;
  std::vector<const char*> commands;
  const char* help;  // one line
};

struct CommandKind {
  const char* name;
  const char* files;  // their names in the usage line
  std::size_t fewest, most;
  const char* help;     // one line
  const char* details;  // of what it does and prints, in lines that fit a screen
  int (*run)(const Options& options, const std::string& command_line);  // the exit status
};

/// A request without a command: -help, -version...
struct RequestKind {
  const char* name;
  const char* argument;
  const char* help;
};

std::span<const CommandKind> Commands();
std::span<const RequestKind> Requests();
/// Null when there is none.
const CommandKind* FindCommand(const std::string& name);

std::span<const OptionKind> OptionTable();
const OptionKind* FindOption(const std::string& name);
bool Takes(const CommandKind& command, const OptionKind& option);

/// Throws UsageError that names option, value and range.
void Store(const OptionKind& option, const std::string& word, Options& options);
/// The value in force, as it would be typed; empty when there is none.
std::string Show(const OptionKind& option, const Options& options);
/// What may be typed; empty for nothing.
std::string Range(const OptionKind& option);
/// The words an argument can be; empty when they are no short list.
std::vector<std::string> Choices(const OptionKind& option);
/// "-fail x"
std::string Synopsis(const char* name, const char* argument);

std::vector<std::string> CommandNames();
std::vector<std::string> Shells();

}  // namespace ray::rayimg
