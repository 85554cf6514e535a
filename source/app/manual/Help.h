#pragma once

#include <string>
#include <utility>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

struct CommandKind;

/// What -help prints: everything, one command, one topic of the option table, one option, or ("markdown") the
/// table. That of rayview leaves out what raypro's table has already, and names it.
std::string Help(Program program, const std::string& subject);

/// "raypro scene image [options]", "rayimg convert in out [options]"
std::string Usage(Program program, const CommandKind* command = nullptr);

/// "raypro 0.1.0"
std::string NameAndVersion(Program program);
/// What -version prints: name and version, the commit where a checkout was built, and the features that are built in.
std::string Version(Program program);

/// What the help and the manual page say besides the options.
struct ProgramText {
  const char* names;    // of the files to be named, in order
  const char* summary;  // completes "the program is there to"
  const char* description;
  const char* examples;
  std::vector<std::pair<const char*, const char*>> statuses;  // exit status, what it means
};
const ProgramText& TextOf(Program program);

}  // namespace ray
