#include "source/app/Manual.h"

#include <utility>
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

/// What scene files may say that the course's language lacks.
constexpr std::pair<const char*, const char*> extensions[] = {
    {"mesh id file smooth", "A mesh with the vertex normals that its file brings."},
    {"absorb id r g b",
     "Solids of the material take exp(-r d), exp(-g d), exp(-b d) from light over a distance d inside."},
    {"bump id file height", "Light sees a relief of the picture's luminance times the height."},
    {"motion dx dy dz", "Between begin and end: the group goes this far while the shutter is open."},
    {"environment file", "Light and view from all around: a latitude-longitude picture, an angular probe or a cross."},
    {"sphere_light r g b px py pz radius ca la qa", "A lamp with a size, not itself seen."},
};

std::string Extensions() {
  std::string text;
  for (const auto& [statement, meaning] : extensions)
    text += ".TP\n.B " + Roff(statement) + "\n" + Roff(meaning) + "\n";
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
         ".SH SCENES\nScenes are in the language of the COS426 course. What that lacks is stated in words of our "
         "own:\n" +
         Extensions() +
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
