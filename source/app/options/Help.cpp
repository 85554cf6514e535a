#include "source/app/options/Help.h"

#include "source/app/options/OptionTable.h"
#include "source/text/Words.h"

namespace ray {

std::string MarkdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? "\\|" : std::string(1, c);
  return " " + cell + " |";
}

std::string MarkdownCode(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

namespace {

constexpr std::size_t column_of_help = 26;

/// "at least 1 camera rays a pixel; 16 unless given"
std::string RangeAndDefault(const OptionKind& option, const Options& defaults) {
  const std::string range = Range(option), value = Show(option, defaults);
  if (range.empty() || value.empty()) return range + value;
  return range + "; default " + value;
}

std::string HelpLine(const OptionKind& option, const Options& defaults) {
  std::string line = "  " + Synopsis(option);
  line += line.size() + 2 > column_of_help ? "\n" + std::string(column_of_help, ' ')
                                           : std::string(column_of_help - line.size(), ' ');
  line += option.help;
  const std::string details = RangeAndDefault(option, defaults);
  if (!details.empty()) line += "\n" + std::string(column_of_help, ' ') + "(" + details + ")";
  return line + "\n";
}

std::string TopicHelp(Program program, const std::string& topic) {
  std::string text = topic + ":\n";
  for (const OptionKind& option : OptionTable(program))
    if (topic == option.topic) text += HelpLine(option, Defaults(program));
  return text;
}

std::string StatusLines(Program program) {
  std::string text = "exit status:\n";
  for (const auto& [number, meaning] : TextOf(program).statuses)
    text +=
        "  " + std::string(number) + std::string(column_of_help - 2 - std::string(number).size(), ' ') + meaning + "\n";
  return text;
}

std::string FullHelp(Program program) {
  const ProgramText& about = TextOf(program);
  std::string text = "usage: " + Usage(program) + "\n\n" + about.description +
                     "-width 512, --width 512 and -width=512 mean the same; options and names come in any order.\n\n";
  for (const std::string& topic : OptionTopics(program)) text += TopicHelp(program, topic) + "\n";
  return text + "examples:\n" + about.examples + "\n" + StatusLines(program);
}

std::string MarkdownRow(const OptionKind& option, const Options& defaults) {
  return "|" + MarkdownCell(MarkdownCode(Synopsis(option))) + MarkdownCell(MarkdownCode(Show(option, defaults))) +
         MarkdownCell(Range(option)) + MarkdownCell(option.help) + "\n";
}

/// Names of the options that both programs have, a line a topic.
std::string SharedOptions(Program program) {
  std::string text, topic;
  for (const OptionKind& option : OptionTable(program)) {
    if (option.known_to != KnownTo::both) continue;
    text += topic == option.topic ? "," : (topic.empty() ? "" : "\n") + ("- " + std::string(option.topic)) + ":";
    text += " `-" + std::string(option.name) + "`";
    topic = option.topic;
  }
  return text + "\n";
}

std::string MarkdownTable(Program program) {
  const bool is_whole = program == Program::raypro;
  std::string table = "| option | default | values | what it does |\n|---|---|---|---|\n";
  for (const OptionKind& option : OptionTable(program))
    if (is_whole || option.known_to != KnownTo::both) table += MarkdownRow(option, Defaults(program));
  return is_whole ? table : table + "\nThe rest is raypro's:\n\n" + SharedOptions(program);
}

}  // namespace

const ProgramText& TextOf(Program program) {
  static const ProgramText of_raypro{
      .names = "scene picture",
      .summary = "render a scene file into a picture by tracing rays",
      .description = "Renders a scene file into a picture; the extensions say the formats (raypro -list).\n",
      .examples =
          "  raypro scenes/hello.scn hello.jpg -width 512 -height 512 -samples 16\n"
          "  raypro scenes/hello.scn part.png -crop 100 100 160 140 -bits 16\n"
          "  raypro scenes/hello.scn -check\n"
          "  raypro scenes/hello.scn -debugpixel 128 100\n",
      .statuses = {{"0", "Done."},
                   {"1", "Failed while rendering."},
                   {"2", "Wrong arguments."},
                   {"3", "The scene, or a file that it names, is wrong or missing."},
                   {"4", "The picture cannot be written."},
                   {"130, 143", "Interrupted by SIGINT or SIGTERM; the picture so far is saved."}}};
  static const ProgramText of_rayview{
      .names = "scene",
      .summary = "look at a scene file, and trace what is seen",
      .description =
          "Shows a scene file in a window; key H there lists what keys and mouse do. Key S traces the view.\n",
      .examples =
          "  rayview scenes/hello.scn -image hello.png -samples 16\n"
          "  rayview scenes/hello.scn -headless -events tour.txt -screenshot end.png\n"
          "  rayview scenes/hello.scn -headless -exit_immediately -output_image first.png\n",
      .statuses = {{"0", "Done."},
                   {"1", "There is nothing to draw with, or drawing failed."},
                   {"2", "Wrong arguments."},
                   {"3", "The scene, or a file that it names, is wrong or missing."},
                   {"4", "A file cannot be written."}}};
  return program == Program::raypro ? of_raypro : of_rayview;
}

std::string Usage(Program program) { return NameOf(program) + " " + TextOf(program).names + " [options]"; }

std::string Help(Program program, const std::string& subject) {
  if (subject.empty()) return FullHelp(program);
  if (subject == "markdown") return MarkdownTable(program);
  if (const OptionKind* option = FindOption(program, WithoutDashes(subject)))
    return HelpLine(*option, Defaults(program));
  return TopicHelp(program, subject);
}

std::string NameAndVersion(Program program) { return NameOf(program) + " " RAYPRO_VERSION; }

std::string Version(Program program) { return NameAndVersion(program) + "\nbuilt with: " RAYPRO_FEATURES "\n"; }

}  // namespace ray
