#pragma once

#include <string>

namespace ray {

/// What -help prints: everything, one topic of the option table, one option, or ("markdown") the README's table.
std::string Help(const std::string& subject);

/// "raypro 0.1.0" and what is built in.
std::string Version();

/// The examples of the help and the manual page.
std::string HelpExamples();

}  // namespace ray
