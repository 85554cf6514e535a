#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ray {

struct CommandKind;
struct OptionKind;
struct Options;

/// One of our programs: the texts of its help, and its command line.
struct Program {
  const char* name;
  const char* file_names;  // the names of its file arguments, in order
  const char* summary;     // completes "the program is there to"
  const char* description;
  const char* examples;
  std::vector<std::pair<const char*, const char*>> statuses;  // exit status, what it means
  int failed;                                                 // the exit status of failures without a specific one

  const std::vector<OptionKind>& (*options)();
  std::span<const CommandKind> (*commands)();  // empty if the program has none
  std::unique_ptr<Options> (*defaults)();
  /// Interprets the names and completes the options after all words are read. Throws UsageError if they contradict each
  /// other or something is missing.
  ///   words   as typed
  void (*complete)(Options& options, std::span<const std::string> words);

  static const Program raypro, rayview, rayimg, raygrade;

  friend bool operator==(const Program& a, const Program& b) { return &a == &b; }
};

inline std::string NameOf(const Program& program) { return program.name; }

}  // namespace ray
