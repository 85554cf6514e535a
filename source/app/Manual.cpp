#include "source/app/Manual.h"

#include <algorithm>
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

/// Paragraphs, each with a bold word or two before it.
template <class List>
std::string Tagged(const List& list) {
  std::string text;
  for (const auto& [tag, meaning] : list) text += ".TP\n.B " + Roff(tag) + "\n" + Roff(meaning) + "\n";
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
         Entries(program) +
         ".SH SCENES\nScenes are in the language of the COS426 course. What that lacks is stated in words of our "
         "own:\n" +
         Tagged(extensions) + ".SH EXIT STATUS\n" + Tagged(about.statuses) + ".SH ENVIRONMENT\n" + Tagged(environment) +
         ".SH EXAMPLES\n.nf\n" + Roff(about.examples) + ".fi\n";
}

}  // namespace ray
