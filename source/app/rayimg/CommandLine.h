#pragma once

#include <span>
#include <string>

#include "source/app/rayimg/Table.h"

namespace ray::rayimg {

/// What is asked for.
struct Job {
  const CommandKind* command = nullptr;  // null for a request
  Options options;
  std::string request, subject;  // "help" and of what
};

/// The words behind the program's name: a command, then names and options in any order; -fail 1, --fail 1 and -fail=1
/// are the same; behind "--" everything is a name. Throws UsageError.
Job ReadCommandLine(std::span<const std::string> words);

}  // namespace ray::rayimg
