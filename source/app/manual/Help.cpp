#include "source/app/manual/Manual.h"

#include <sstream>

#include "source/app/files/LayerImages.h"
#include "source/app/options/Comp30019.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/ReportJson.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Returns a cell of a Markdown table with its right border; a bar within the text is escaped.
std::string MarkdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? "\\|" : std::string(1, c);
  return " " + cell + " |";
}

std::string MarkdownCode(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

constexpr std::size_t column_of_help = 26;

/// Returns "a whole number, at least 1 pixels; default 256".
std::string RangeAndDefault(const OptionKind& option, const Options& defaults) {
  const std::string range = Range(option), value = defaults.Show(option);
  if (range.empty() || value.empty()) return range + value;
  return range + "; default " + value;
}

/// Returns the name, followed by its meaning in a fixed column.
std::string Entry(const std::string& name, const std::string& help) {
  const std::string line = "  " + name;
  const bool fits = line.size() + 2 <= column_of_help;
  return line + (fits ? std::string(column_of_help - line.size(), ' ') : "\n" + std::string(column_of_help, ' ')) +
         help + "\n";
}

/// Wraps text to fit a screen, with all lines but the first indented to the column.
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

std::string CommandHelp(const Program& program, const CommandKind& command) {
  std::string options;
  for (const OptionKind& option : OptionTable(program))
    if (Takes(command, option)) options += OptionHelp(option, *program.defaults());
  return "usage: " + Usage(program, &command) + "\n\n" + command.help + "\n" + command.details +
         (options.empty() ? "" : "\noptions:\n" + options);
}

std::string CommandList(const Program& program) {
  std::string text;
  for (const CommandKind& command : program.commands())
    text += Entry(std::string(command.name) + " " + command.files, command.help);
  return text.empty() ? "" : "commands:\n" + text + "\n";
}

/// Returns the help for a topic; empty if there is no such topic.
std::string TopicHelp(const Program& program, const std::string& topic) {
  std::string text;
  for (const OptionKind& option : OptionTable(program))
    if (topic == option.topic) text += OptionHelp(option, *program.defaults());
  return text.empty() ? "" : topic + ":\n" + text;
}

std::string StatusLines(const Program& program) {
  std::string text = "exit status:\n";
  for (const auto& [number, meaning] : program.statuses) text += Entry(number, meaning);
  return text;
}

std::string FullHelp(const Program& program) {
  std::string text =
      "usage: " + Usage(program) + "\n\n" + program.description +
      "-name value, --name value and -name=value mean the same; options and names come in any order.\n\n";
  text += CommandList(program);
  for (const std::string& topic : OptionTopics(program)) text += TopicHelp(program, topic) + "\n";
  return text + "examples:\n" + program.examples + "\n" + StatusLines(program);
}

std::string MarkdownRow(const OptionKind& option, const Options& defaults) {
  return "|" + MarkdownCell(MarkdownCode(Synopsis(option))) + MarkdownCell(MarkdownCode(defaults.Show(option))) +
         MarkdownCell(Range(option)) + MarkdownCell(option.help) + "\n";
}

bool IsRaypros(const OptionKind& option) { return option.known_to == KnownTo::both || option.known_to == KnownTo::all; }

/// Returns the names of the options that raypro has as well, one line per topic.
std::string SharedOptions(const Program& program) {
  std::string text, topic;
  for (const OptionKind& option : OptionTable(program)) {
    if (!IsRaypros(option)) continue;
    text += topic == option.topic ? "," : (topic.empty() ? "" : "\n") + ("- " + std::string(option.topic)) + ":";
    text += " `-" + std::string(option.name) + "`";
    topic = option.topic;
  }
  return text + "\n";
}

std::string MarkdownStatuses(const Program& program) {
  std::string table = "\n| exit status | meaning |\n|---|---|\n";
  for (const auto& [number, meaning] : program.statuses)
    table += "|" + MarkdownCell(number) + MarkdownCell(meaning) + "\n";
  return table;
}

/// Returns the channels of an EXR and the keys of a report.
std::string MarkdownOutputs() {
  std::string text = "\n| layer in an EXR | channels |\n|---|---|\n";
  for (const auto& [layer, channels] : ChannelsOfLayers())
    text += "|" + MarkdownCell(MarkdownCode(layer)) + MarkdownCell(MarkdownCode(channels)) + "\n";
  text += "\n| key of a report | value |\n|---|---|\n";
  for (const auto& [name, meaning] : ReportFields())
    text += "|" + MarkdownCell(MarkdownCode(name)) + MarkdownCell(meaning) + "\n";
  return text;
}

std::string MarkdownTable(const Program& program) {
  const auto defaults = program.defaults();
  const bool has_commands = !program.commands().empty();
  std::string table = std::string("| ") + (has_commands ? "command, " : "") +
                      "option | default | values | what it does |\n|---|---|---|---|\n";
  for (const CommandKind& command : program.commands()) {
    const std::string synopsis = NameOf(program) + " " + command.name + " " + command.files;
    table += "|" + MarkdownCell(MarkdownCode(synopsis)) + " | | " + command.help + " |\n";
    for (const OptionKind& option : OptionTable(program))
      if (Takes(command, option)) table += MarkdownRow(option, *defaults);
  }
  for (const OptionKind& option : OptionTable(program))
    if (option.commands.empty() && (program == Program::raypro || !IsRaypros(option)))
      table += MarkdownRow(option, *defaults);
  if (program == Program::raypro) return table + MarkdownOutputs() + MarkdownStatuses(program);
  return table + "\nThe others are the same as raypro's:\n\n" + SharedOptions(program) + MarkdownStatuses(program);
}

}  // namespace

std::string Usage(const Program& program, const CommandKind* command) {
  return NameOf(program) + " " + (command ? std::string(command->name) + " " + command->files : program.file_names) +
         " [options]";
}

std::string Help(const Program& program, const std::string& subject) {
  if (subject.empty()) return FullHelp(program);
  if (subject == "markdown") return MarkdownTable(program);
  if (subject == "comp30019") return comp30019::Help();
  if (const CommandKind* command = FindCommand(program, subject)) return CommandHelp(program, *command);
  const std::string topic = TopicHelp(program, subject);
  return topic.empty() ? OptionHelp(*FindOption(program, WithoutDashes(subject)), *program.defaults()) : topic;
}

}  // namespace ray
