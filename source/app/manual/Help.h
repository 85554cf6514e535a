#pragma once

#include <string>

#include "source/app/options/Program.h"

namespace ray {

/// What -help prints: everything, one command, one topic of the option table, one option, or ("markdown") the
/// table. That of rayview leaves out what raypro's table has already, and names it.
std::string Help(const Program& program, const std::string& subject);

/// "raypro scene image [options]", "rayimg convert in out [options]"
std::string Usage(const Program& program, const CommandKind* command = nullptr);

/// "raypro 0.1.0"
std::string NameAndVersion(const Program& program);
/// What -version prints: name and version, the commit where a checkout was built, and the features that are built in.
std::string Version(const Program& program);

}  // namespace ray
