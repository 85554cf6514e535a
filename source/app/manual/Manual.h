#pragma once

#include <string>
#include <vector>

#include "source/app/options/Program.h"

/// The texts that programs print about themselves: manual pages, help, lists, completions.
namespace ray {

/// Returns the manual page raypro.1 or rayview.1, as troff source with man macros.
std::string ManualPage(const Program& program);

/// Returns the names of the pages that -man accepts in addition to the program's own.
std::vector<std::string> ManualPages();
/// Returns one of them, or the program's own if `name` is empty.
std::string ManualPage(const std::string& name, const Program& program);

/// Escapes text for roff: backslashes and dashes, and control characters at the start of a line.
std::string Roff(const std::string& text);

/// Returns paragraphs, each preceded by a bold tag: pairs of tag and text.
template <class List>
std::string Tagged(const List& list) {
  std::string text;
  for (const auto& [tag, meaning] : list) text += ".TP\n.B " + Roff(tag) + "\n" + Roff(meaning) + "\n";
  return text;
}

/// Returns the manual page scn.5 as troff source with man macros: the scene language, with every command from the
/// parser's own tables.
std::string SceneManualPage();

/// Returns the text of -help: everything, one command, one topic of the option table, one option, or ("markdown") the
/// table. rayview's table omits the options that are in raypro's, and lists their names.
std::string Help(const Program& program, const std::string& subject);

/// Returns "raypro scene image [options]" or "rayimg convert in out [options]".
std::string Usage(const Program& program, const CommandKind* command = nullptr);

/// Returns "raypro 0.1.0".
std::string NameAndVersion(const Program& program);
/// Returns the text of -version: name and version, the commit if a checkout was built, and the compiled features.
std::string Version(const Program& program);

/// Returns the subjects of -list.
std::vector<std::string> ListSubjects(const Program& program);

/// Returns the names of one subject with descriptions, or of all subjects if `subject` is empty. `keys`: descriptions
/// of the viewer's keys, in lines; empty for programs without a window.
std::string Listing(const Program& program, const std::string& subject, const std::vector<std::string>& keys = {});

/// Returns the bash completion script for the program's options.
std::string BashCompletion(const Program& program);

}  // namespace ray
