#pragma once

#include <string>

namespace ray {

/// What -help prints: everything, one topic of the option table, one option, or ("markdown") the README's table.
std::string Help(const std::string& subject);

/// "raypro 0.1.0" and what is built in.
std::string Version();

/// The examples of the help and the manual page.
std::string HelpExamples();

/// A cell of a table in Markdown, with its right border; a bar within the text is escaped, which would end it.
std::string MarkdownCell(const std::string& text);
/// The text as code; nothing for no text.
std::string MarkdownCode(const std::string& text);

}  // namespace ray
