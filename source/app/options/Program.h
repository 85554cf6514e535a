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

/// One of our programs: what its help says, and what its command line may hold.
struct Program {
  const char* name;
  const char* file_names;  // of the files to be named, in order
  const char* summary;     // completes "the program is there to"
  const char* description;
  const char* examples;
  std::vector<std::pair<const char*, const char*>> statuses;  // exit status, what it means
  int failed;                                                 // the exit status of failures that have none of their own

  const std::vector<OptionKind>& (*options)();
  std::span<const CommandKind> (*commands)();  // empty where the program has none
  std::unique_ptr<Options> (*defaults)();
  /// Decides what the names are and completes the options once all words are read. Throws UsageError where they
  /// contradict each other or something is missing.
  ///   words   as typed
  void (*complete)(Options& options, std::span<const std::string> words);

  static const Program raypro, rayview, rayimg, raygrade;

  friend bool operator==(const Program& a, const Program& b) { return &a == &b; }
};

inline std::string NameOf(const Program& program) { return program.name; }

}  // namespace ray
