#pragma once

#include <string>

#include "source/app/options/Program.h"

namespace ray {

/// Returns the text of -help: everything, one command, one topic of the option table, one option, or ("markdown") the
/// table. rayview's table omits the options that are in raypro's, and lists their names.
std::string Help(const Program& program, const std::string& subject);

/// Returns "raypro scene image [options]" or "rayimg convert in out [options]".
std::string Usage(const Program& program, const CommandKind* command = nullptr);

/// Returns "raypro 0.1.0".
std::string NameAndVersion(const Program& program);
/// Returns the text of -version: name and version, the commit if a checkout was built, and the compiled features.
std::string Version(const Program& program);

}  // namespace ray
