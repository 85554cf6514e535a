#pragma once

#include <string>
#include <utility>
#include <vector>

#include "source/app/options/Program.h"

namespace ray {

/// What -help prints: everything, one topic of the option table, one option, or ("markdown") the README's table. That
/// of rayview leaves out what raypro's table has already, and names it.
std::string Help(Program program, const std::string& subject);

/// "raypro scene picture [options]"
std::string Usage(Program program);

/// "raypro 0.1.0"
std::string NameAndVersion(Program program);
/// The same, and what is built in.
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

/// A cell of a table in Markdown, with its right border; a bar within the text is escaped, which would end it.
std::string MarkdownCell(const std::string& text);
/// The text as code; nothing for no text.
std::string MarkdownCode(const std::string& text);

}  // namespace ray
