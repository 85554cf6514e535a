#include "source/app/Manual.h"

#include "source/app/Help.h"
#include "source/app/OptionTable.h"

namespace ray {

std::string Roff(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    const bool starts_line = roff.empty() || roff.back() == '\n';
    if (starts_line && (c == '.' || c == '\'')) roff += "\\&";
    if (c == '\\')
      roff += "\\e";
    else
      roff += c == '-' ? "\\-" : std::string(1, c);
  }
  return roff;
}

namespace {

std::string Entry(const OptionKind& option) {
  std::string entry = ".TP\n.B " + Roff(Synopsis(option)) + "\n" + Roff(option.help) + ".\n";
  const std::string range = Range(option), value = Show(option, Options{});
  if (!range.empty()) entry += "Values: " + Roff(range) + ".\n";
  if (!value.empty()) entry += "Default: " + Roff(value) + ".\n";
  return entry;
}

std::string Entries() {
  std::string text, topic;
  for (const OptionKind& option : OptionTable()) {
    if (topic != option.topic) text += ".SS " + Roff(topic = option.topic) + "\n";
    text += Entry(option);
  }
  return text;
}

}  // namespace

std::string ManualPage() {
  return ".TH RAYPRO 1 \"\" \"raypro " + Roff(RAYPRO_VERSION) +
         "\" \"User Commands\"\n"
         ".SH NAME\nraypro \\- render a scene file into a picture by tracing rays\n"
         ".SH SYNOPSIS\n.B raypro\n.I scene picture\n.RI [ options ]\n"
         ".SH DESCRIPTION\n"
         "The extensions of the two names say their formats;\n.B raypro \\-list\nnames them.\n"
         "Options and names come in any order; \\-width 512, \\-\\-width 512 and \\-width=512 mean the same.\n"
         "The picture is written to a temporary file beside its name and renamed when it is whole.\n"
         ".SH OPTIONS\n" +
         Entries() +
         ".SH EXIT STATUS\n"
         ".TP\n.B 0\nDone.\n.TP\n.B 1\nFailed while rendering.\n.TP\n.B 2\nWrong arguments.\n"
         ".TP\n.B 3\nThe scene, or a file that it names, is wrong or missing.\n.TP\n.B 4\nThe picture cannot be "
         "written.\n"
         ".TP\n.B 130, 143\nInterrupted by SIGINT or SIGTERM; the picture so far is saved.\n"
         ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nNo colour on the terminal.\n"
         ".TP\n.B TMPDIR\nWhere a picture is kept that cannot be written where it should be.\n"
         ".SH EXAMPLES\n.nf\n" +
         Roff(HelpExamples()) + ".fi\n";
}

}  // namespace ray
