#include "source/app/Help.h"

#include "source/app/OptionTable.h"
#include "source/app/Words.h"

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
std::string RangeAndDefault(const OptionKind& option) {
  const std::string range = Range(option), value = Show(option, Options{});
  if (range.empty() || value.empty()) return range + value;
  return range + "; default " + value;
}

std::string HelpLine(const OptionKind& option) {
  std::string line = "  " + Synopsis(option);
  line += line.size() + 2 > column_of_help ? "\n" + std::string(column_of_help, ' ')
                                           : std::string(column_of_help - line.size(), ' ');
  line += option.help;
  const std::string details = RangeAndDefault(option);
  if (!details.empty()) line += "\n" + std::string(column_of_help, ' ') + "(" + details + ")";
  return line + "\n";
}

std::string TopicHelp(const std::string& topic) {
  std::string text = topic + ":\n";
  for (const OptionKind& option : OptionTable())
    if (topic == option.topic) text += HelpLine(option);
  return text;
}

std::string FullHelp() {
  std::string text =
      "usage: raypro scene picture [options]\n\n"
      "Renders a scene file into a picture; the extensions say the formats (raypro -list).\n"
      "-width 512, --width 512 and -width=512 mean the same; options and names come in any order.\n\n";
  for (const std::string& topic : OptionTopics()) text += TopicHelp(topic) + "\n";
  return text + "examples:\n" + HelpExamples() +
         "\nexit status: 0 done, 1 failed while rendering, 2 wrong arguments, 3 scene wrong or missing, 4 cannot "
         "write,\n"
         "130 or 143 interrupted with the picture so far saved\n";
}

std::string MarkdownTable() {
  std::string table = "| option | default | values | what it does |\n|---|---|---|---|\n";
  for (const OptionKind& option : OptionTable())
    table += "|" + MarkdownCell(MarkdownCode(Synopsis(option))) + MarkdownCell(MarkdownCode(Show(option, Options{}))) +
             MarkdownCell(Range(option)) + MarkdownCell(option.help) + "\n";
  return table;
}

}  // namespace

std::string HelpExamples() {
  return "  raypro scenes/hello.scn hello.jpg -width 512 -height 512 -samples 16\n"
         "  raypro scenes/hello.scn part.png -crop 100 100 160 140 -bits 16\n"
         "  raypro scenes/hello.scn -check\n";
}

std::string Help(const std::string& subject) {
  if (subject.empty()) return FullHelp();
  if (subject == "markdown") return MarkdownTable();
  if (const OptionKind* option = FindOption(WithoutDashes(subject))) return HelpLine(*option);
  return TopicHelp(subject);
}

std::string Version() { return "raypro " RAYPRO_VERSION "\nbuilt with: " RAYPRO_FEATURES "\n"; }

}  // namespace ray
