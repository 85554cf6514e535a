#include "source/app/manual/Help.h"

#include <sstream>

#include "source/app/files/LayerPictures.h"
#include "source/app/options/Comp30019.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ReportFields.h"
#include "source/text/Words.h"

namespace ray {

namespace {

/// A cell of a table in Markdown, with its right border; a bar within the text is escaped, which would end it.
std::string MarkdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? "\\|" : std::string(1, c);
  return " " + cell + " |";
}

std::string MarkdownCode(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

constexpr std::size_t column_of_help = 26;

/// "a whole number, at least 1 pixels; default 256"
std::string RangeAndDefault(const OptionKind& option, const Options& defaults) {
  const std::string range = Range(option), value = defaults.Show(option);
  if (range.empty() || value.empty()) return range + value;
  return range + "; default " + value;
}

/// The name, and in its column what it means.
std::string Entry(const std::string& name, const std::string& help) {
  const std::string line = "  " + name;
  const bool fits = line.size() + 2 <= column_of_help;
  return line + (fits ? std::string(column_of_help - line.size(), ' ') : "\n" + std::string(column_of_help, ' ')) +
         help + "\n";
}

/// In lines that fit a screen, each but the first indented to the column.
std::string Wrapped(const std::string& text) {
  constexpr std::size_t screen = 120;
  std::string lines;
  std::size_t column = column_of_help;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && column + 1 + word.size() > screen) {
      lines += "\n" + std::string(column_of_help, ' ');
      column = column_of_help;
    } else if (!lines.empty()) {
      lines += " ";
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

std::string OptionHelp(const OptionKind& option, const Options& defaults) {
  const std::string details = RangeAndDefault(option, defaults);
  return Entry(Synopsis(option), option.help) +
         (details.empty() ? "" : std::string(column_of_help, ' ') + Wrapped("(" + details + ")") + "\n");
}

std::string CommandHelp(Program program, const CommandKind& command) {
  std::string options;
  for (const OptionKind& option : OptionTable(program))
    if (Takes(command, option)) options += OptionHelp(option, Defaults(program));
  return "usage: " + Usage(program, &command) + "\n\n" + command.help + "\n" + command.details +
         (options.empty() ? "" : "\noptions:\n" + options);
}

std::string CommandList(Program program) {
  std::string text;
  for (const CommandKind& command : CommandsOf(program))
    text += Entry(std::string(command.name) + " " + command.files, command.help);
  return text.empty() ? "" : "commands:\n" + text + "\n";
}

/// Nothing when there is no such topic.
std::string TopicHelp(Program program, const std::string& topic) {
  std::string text;
  for (const OptionKind& option : OptionTable(program))
    if (topic == option.topic) text += OptionHelp(option, Defaults(program));
  return text.empty() ? "" : topic + ":\n" + text;
}

std::string StatusLines(Program program) {
  std::string text = "exit status:\n";
  for (const auto& [number, meaning] : TextOf(program).statuses) text += Entry(number, meaning);
  return text;
}

std::string FullHelp(Program program) {
  const ProgramText& about = TextOf(program);
  std::string text =
      "usage: " + Usage(program) + "\n\n" + about.description +
      "-name value, --name value and -name=value mean the same; options and names come in any order.\n\n";
  text += CommandList(program);
  for (const std::string& topic : OptionTopics(program)) text += TopicHelp(program, topic) + "\n";
  return text + "examples:\n" + about.examples + "\n" + StatusLines(program);
}

std::string MarkdownRow(const OptionKind& option, const Options& defaults) {
  return "|" + MarkdownCell(MarkdownCode(Synopsis(option))) + MarkdownCell(MarkdownCode(defaults.Show(option))) +
         MarkdownCell(Range(option)) + MarkdownCell(option.help) + "\n";
}

bool IsRaypros(const OptionKind& option) { return option.known_to == KnownTo::both || option.known_to == KnownTo::all; }

/// Names of the options that raypro has as well, a line per topic.
std::string SharedOptions(Program program) {
  std::string text, topic;
  for (const OptionKind& option : OptionTable(program)) {
    if (!IsRaypros(option)) continue;
    text += topic == option.topic ? "," : (topic.empty() ? "" : "\n") + ("- " + std::string(option.topic)) + ":";
    text += " `-" + std::string(option.name) + "`";
    topic = option.topic;
  }
  return text + "\n";
}

std::string MarkdownStatuses(Program program) {
  std::string table = "\n| exit status | meaning |\n|---|---|\n";
  for (const auto& [number, meaning] : TextOf(program).statuses)
    table += "|" + MarkdownCell(number) + MarkdownCell(meaning) + "\n";
  return table;
}

/// Channels of an EXR and keys of a report.
std::string MarkdownOutputs() {
  std::string text = "\n| layer in an EXR | channels |\n|---|---|\n";
  for (const auto& [layer, channels] : ChannelsOfLayers())
    text += "|" + MarkdownCell(MarkdownCode(layer)) + MarkdownCell(MarkdownCode(channels)) + "\n";
  text += "\n| key of a report | value |\n|---|---|\n";
  for (const auto& [name, meaning] : ReportFields())
    text += "|" + MarkdownCell(MarkdownCode(name)) + MarkdownCell(meaning) + "\n";
  return text;
}

std::string MarkdownTable(Program program) {
  const Options defaults = Defaults(program);
  const bool has_commands = !CommandsOf(program).empty();
  std::string table = std::string("| ") + (has_commands ? "command, " : "") +
                      "option | default | values | what it does |\n|---|---|---|---|\n";
  for (const CommandKind& command : CommandsOf(program)) {
    const std::string synopsis = NameOf(program) + " " + command.name + " " + command.files;
    table += "|" + MarkdownCell(MarkdownCode(synopsis)) + " | | " + command.help + " |\n";
    for (const OptionKind& option : OptionTable(program))
      if (Takes(command, option)) table += MarkdownRow(option, defaults);
  }
  for (const OptionKind& option : OptionTable(program))
    if (option.commands.empty() && (program == Program::raypro || !IsRaypros(option)))
      table += MarkdownRow(option, defaults);
  if (program == Program::raypro) return table + MarkdownOutputs() + MarkdownStatuses(program);
  return table + "\nThe others are the same as raypro's:\n\n" + SharedOptions(program) + MarkdownStatuses(program);
}

}  // namespace

const ProgramText& TextOf(Program program) {
  constexpr const char* bad_scene = "The scene, or a file that it names, is wrong or missing.";
  static const ProgramText of_raypro{
      .names = "scene image",
      .summary = "render a scene by ray tracing",
      .description =
          "Renders a scene file; the extensions choose the formats (raypro -list). The name - is standard input as a "
          "scene,\n"
          "in .scn, and standard output as an image, in PNG. A scene or a mesh that is named alone is rendered to a "
          "PNG of\nits name beside it.\n",
      .examples =
          "  raypro scenes/hello.scn hello.jpg -width 512 -height 512 -samples 16\n"
          "  raypro scenes/hello.scn part.png -crop 100 100 160 140 -bits 16\n"
          "  raypro scenes/hello.scn scenes/glass.scn -out_folder images\n"
          "  raypro - - < scenes/hello.scn > hello.png\n"
          "  raypro scenes/hello.scn -check\n"
          "  raypro scenes/hello.scn -debugpixel 128 100\n",
      .statuses = {
          {"0", "Success."},
          {"1", "Failed while rendering."},
          {"2", "Wrong arguments."},
          {"3", bad_scene},
          {"4", "The image cannot be written."},
          {"129, 130, 143, 152", "Stopped by SIGHUP, SIGINT, SIGTERM or SIGXCPU; the image so far is saved."}}};
  static const ProgramText of_rayview{
      .names = "scene",
      .summary = "view a scene, and ray trace the view",
      .description =
          "Shows a scene file in a window; key H there lists the keys and what the mouse does. Key S traces the view.\n"
          "Scenes in .scn can be changed there, by the panel Edit of key Tab, and saved by Control+S.\n",
      .examples =
          "  rayview scenes/hello.scn -image hello.png -samples 16\n"
          "  rayview scenes/hello.scn -headless -events tour.txt -screenshot end.png\n"
          "  rayview scenes/hello.scn -headless -exit_immediately -output_image first.png\n",
      .statuses = {{"0", "Success."},
                   {"1", "There is nothing to draw with, or drawing failed."},
                   {"2", "Wrong arguments."},
                   {"3", bad_scene},
                   {"4", "A file cannot be written."}}};
  static const ProgramText of_rayimg{
      .names = "command images",
      .summary = "compare, describe, convert and merge images, and make movies of them",
      .description =
          "Compares, describes, converts and merges images, and makes movies of them. Extensions choose the formats\n"
          "of those written, contents tell those of those read. rayimg -help command lists the options of a command.\n",
      .examples =
          "  rayimg diff noisy.exr clean.exr -map where.png -fail_flip 0.05\n"
          "  rayimg convert out.exr out.jpg -exposure 1 -tonemap filmic -srgb\n"
          "  rayimg merge seed1.exr seed2.exr seed3.exr -out mean.exr\n"
          "  rayimg movie turn.avi -fps 25 turn01.jpg turn02.jpg turn03.jpg\n",
      .statuses = {{"0", "Success."},
                   {"1", "diff: beyond a threshold."},
                   {"2", "Wrong arguments."},
                   {"3", "An image is missing, damaged or too large."},
                   {"4", "A file cannot be written."}}};
  static const ProgramText of_raygrade{
      .names = "suite.yaml -- command",
      .summary = "grade students' ray tracers and name their mistakes",
      .description =
          "Runs a ray tracer on the scenes of a suite, compares its images with ours where pixels are\n"
          "steady, and names the mistake that makes an image like it. In the command, {scene}, {image},\n"
          "{width}, {height} and {student} are replaced. docs/teachers.md says more.\n",
      .examples =
          "  raygrade share/suites/cos426/suite.yaml -- ./student {scene} {image} -width {width} -height {height}\n"
          "  raygrade suite.yaml -students handed_in -out graded -- {student}/tracer {scene} {image}\n"
          "  raygrade suite.yaml -matrix\n"
          "  raygrade -new scenes\n",
      .statuses = {{"0", "Success, whatever the points."},
                   {"1", "Grading failed."},
                   {"2", "Wrong arguments."},
                   {"3", "The suite, or a scene, is wrong or missing."},
                   {"4", "A file cannot be written."}}};
  switch (program) {
    case Program::raypro:
      return of_raypro;
    case Program::rayview:
      return of_rayview;
    case Program::rayimg:
      return of_rayimg;
    case Program::raygrade:
      return of_raygrade;
  }
  return of_raypro;
}

std::string Usage(Program program, const CommandKind* command) {
  return NameOf(program) + " " + (command ? std::string(command->name) + " " + command->files : TextOf(program).names) +
         " [options]";
}

std::string Help(Program program, const std::string& subject) {
  if (subject.empty()) return FullHelp(program);
  if (subject == "markdown") return MarkdownTable(program);
  if (subject == "comp30019") return comp30019::Help();
  if (const CommandKind* command = FindCommand(program, subject)) return CommandHelp(program, *command);
  const std::string topic = TopicHelp(program, subject);
  return topic.empty() ? OptionHelp(*FindOption(program, WithoutDashes(subject)), Defaults(program)) : topic;
}

}  // namespace ray
