#include "source/app/manual/Manual.h"

#include <algorithm>
#include <utility>

#include "source/app/files/LayerImages.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ReportJson.h"

namespace ray {

std::string Roff(const std::string& text) {
  std::string roff;
  for (const char c : text) {
    const bool starts_line = roff.empty() || roff.back() == '\n';
    if (starts_line && (c == '.' || c == '\'')) roff += "\\&";
    if (c == '\\')
      roff += "\\e";
    else if (c == '^')
      roff += "\\(ha";  // otherwise an accent
    else
      roff += c == '-' ? "\\-" : std::string(1, c);
  }
  return roff;
}

namespace {

std::string Entry(const OptionKind& option, const Options& defaults) {
  std::string entry = ".TP\n.B " + Roff(Synopsis(option)) + "\n" + Roff(option.help) + ".\n";
  const std::string range = Range(option), value = defaults.Show(option);
  if (!range.empty()) entry += "Values: " + Roff(range) + ".\n";
  if (!value.empty()) entry += "Default: " + Roff(value) + ".\n";
  return entry;
}

std::string CommandSections(const Program& program) {
  std::string text;
  for (const CommandKind& command : program.commands()) {
    text += ".SS " + Roff(NameOf(program) + " " + command.name + " " + command.files) + "\n" + Roff(command.help) +
            ".\n.nf\n" + Roff(std::string(command.details).substr(1)) + ".fi\n";
    for (const OptionKind& option : OptionTable(program))
      if (Takes(command, option)) text += Entry(option, *program.defaults());
  }
  return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

std::string Entries(const Program& program) {
  std::string text, topic;
  for (const OptionKind& option : OptionTable(program)) {
    if (!option.commands.empty()) continue;
    if (topic != option.topic) text += ".SS " + Roff(topic = option.topic) + "\n";
    text += Entry(option, *program.defaults());
  }
  return text;
}

std::string SceneLanguages() {
  return ".SH SCENES\nFiles .scn are in the language described in\n.BR scn (5).\n" +
         Roff(
             "Files .yaml and .yml are in the language of Groningen's course, files .txt in that of COMP30019; files "
             ".json are in that of CS 315 or in Groningen's, depending on their keys. -format names the language "
             "otherwise: scn, groningen, cs315 or comp30019.\n") +
         "A file with the extension of a mesh is a scene of that mesh alone.\n";
}

std::string SeeAlso(const Program& program) {
  std::string text;
  for (const std::string other : {"raypro", "rayview", "rayimg", "raygrade"})
    if (other != program.name) text += ".BR " + other + " (1),\n";
  return ".SH SEE ALSO\n" + text + ".BR scn (5),\n.BR raypro\\-farm (7)\n";
}

constexpr const char* interruption =
    "A render that is interrupted leaves the image so far, whole and noisy, and a checkpoint from which \\-resume "
    "continues: out.png and out.png.checkpoint, or, where a finished image has the name and stays, out.partial.png "
    "and out.partial.png.checkpoint. Where there is a checkpoint, a render needs \\-resume or \\-restart.\n";

std::string UpperCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; });
  return text;
}

/// Returns the sections about files that only raypro writes.
std::string OutputSections() {
  std::string text = ".SH LAYERS\nAn EXR stores each of \\-layers in separate floating-point channels:\n";
  for (const auto& [layer, channels] : ChannelsOfLayers()) text += ".TP\n.B " + layer + "\n" + channels + "\n";
  text += ".SH REPORT\n\\-report writes a JSON object with these keys:\n";
  for (const auto& [name, meaning] : ReportFields())
    text += ".TP\n.B " + Roff(name) + "\n" + Roff(meaning) + ".\n";
  return text;
}

constexpr std::pair<const char*, const char*> environment[] = {
    {"NO_COLOR", "No color on the terminal."},
    {"TMPDIR", "The folder for an image that cannot be written to its place."},
};

}  // namespace

std::vector<std::string> ManualPages() { return {"scn"}; }

std::string ManualPage(const std::string& name, const Program& program) {
  return name == "scn" ? SceneManualPage() : ManualPage(program);
}

std::string ManualPage(const Program& program) {
  const std::string name = NameOf(program);
  const bool takes_scene = program.commands().empty();
  return ".TH " + UpperCase(name) + " 1 \"\" \"" + Roff(NameAndVersion(program)) + "\" \"User Commands\"\n.SH NAME\n" +
         name + " \\- " + Roff(program.summary) + "\n.SH SYNOPSIS\n.B " + name + "\n.I " + program.file_names +
         "\n.RI [ options ]\n.SH DESCRIPTION\n" + Roff(program.description) +
         (takes_scene ? "File name extensions choose the formats;\n.B " + name + " \\-list\nlists them.\n" : "") +
         "Options and names come in any order; \\-name value, \\-\\-name value and \\-name=value mean the same.\n"
         "An image is written to a temporary file in the same folder and renamed when it is complete.\n" +
         (program == Program::raypro ? interruption : "") + CommandSections(program) + ".SH OPTIONS\n" +
         Entries(program) + (takes_scene ? SceneLanguages() : "") +
         (program == Program::raypro ? OutputSections() : "") + ".SH EXIT STATUS\n" + Tagged(program.statuses) +
         ".SH ENVIRONMENT\n" + Tagged(environment) + ".SH EXAMPLES\n.nf\n" + Roff(program.examples) + ".fi\n" +
         SeeAlso(program);
}

}  // namespace ray
