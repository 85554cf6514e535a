#include "source/app/options/Manual.h"

#include <algorithm>
#include <utility>

#include "source/app/options/Help.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/SceneManual.h"

namespace ray {

std::string Roff(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    const bool starts_line = roff.empty() || roff.back() == '\n';
    if (starts_line && (c == '.' || c == '\'')) roff += "\\&";
    if (c == '\\')
      roff += "\\e";
    else if (c == '^')
      roff += "\\(ha";  // an accent otherwise
    else
      roff += c == '-' ? "\\-" : std::string(1, c);
  }
  return roff;
}

namespace {

std::string Entry(const OptionKind& option, const Options& defaults) {
  std::string entry = ".TP\n.B " + Roff(Synopsis(option)) + "\n" + Roff(option.help) + ".\n";
  const std::string range = Range(option), value = Show(option, defaults);
  if (!range.empty()) entry += "Values: " + Roff(range) + ".\n";
  if (!value.empty()) entry += "Default: " + Roff(value) + ".\n";
  return entry;
}

std::string Entries(Program program) {
  std::string text, topic;
  for (const OptionKind& option : OptionTable(program)) {
    if (topic != option.topic) text += ".SS " + Roff(topic = option.topic) + "\n";
    text += Entry(option, Defaults(program));
  }
  return text;
}

std::string UpperCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; });
  return text;
}

constexpr std::pair<const char*, const char*> environment[] = {
    {"NO_COLOR", "No colour on the terminal."},
    {"TMPDIR", "Where a picture is kept that cannot be written where it should be."},
};

}  // namespace

std::vector<std::string> ManualPages() { return {"scn"}; }

std::string ManualPage(const std::string& name, Program program) {
  return name == "scn" ? SceneManualPage() : ManualPage(program);
}

std::string ManualPage(Program program) {
  const ProgramText& about = TextOf(program);
  const std::string name = NameOf(program);
  return ".TH " + UpperCase(name) + " 1 \"\" \"" + Roff(NameAndVersion(program)) +
         "\" \"User Commands\"\n"
         ".SH NAME\n" +
         name + " \\- " + Roff(about.summary) + "\n.SH SYNOPSIS\n.B " + name + "\n.I " + about.names +
         "\n.RI [ options ]\n"
         ".SH DESCRIPTION\n" +
         Roff(about.description) + "The extensions of names say their formats;\n.B " + name +
         " \\-list\nnames them.\n"
         "Options and names come in any order; \\-width 512, \\-\\-width 512 and \\-width=512 mean the same.\n"
         "A picture is written to a temporary file beside its name and renamed when it is whole.\n"
         ".SH OPTIONS\n" +
         Entries(program) + ".SH SCENES\nScenes are in the language that\n.BR scn (5)\nexplains.\n" +
         ".SH EXIT STATUS\n" + Tagged(about.statuses) + ".SH ENVIRONMENT\n" + Tagged(environment) +
         ".SH EXAMPLES\n.nf\n" + Roff(about.examples) + ".fi\n.SH SEE ALSO\n.BR " + NameOf(TheOther(program)) +
         " (1),\n.BR rayimg (1),\n.BR scn (5)\n";
}

}  // namespace ray
