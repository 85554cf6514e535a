#include "source/app/rayimg/Help.h"

#include "source/app/options/Help.h"
#include "source/app/options/Manual.h"
#include "source/app/rayimg/Pictures.h"
#include "source/app/rayimg/Table.h"

namespace ray::rayimg {
namespace {

constexpr std::size_t column_of_help = 26;

constexpr const char* exit_status =
    "0 done; 1 diff: beyond a threshold; 2 wrong arguments; 3 a picture is missing, damaged or too large;\n"
    "4 cannot write";

constexpr const char* examples =
    "  rayimg diff noisy.exr clean.exr -map where.png -fail_flip 0.05\n"
    "  rayimg convert out.exr out.jpg -exposure 1 -tonemap filmic -srgb\n"
    "  rayimg merge seed1.exr seed2.exr seed3.exr -out mean.exr\n"
    "  rayimg movie turn.avi -fps 25 turn01.jpg turn02.jpg turn03.jpg\n";

std::string CommandSynopsis(const CommandKind& command) {
  return "rayimg " + std::string(command.name) + " " + command.files;
}

/// The name, and in its column what it means.
std::string HelpLine(const std::string& name, const std::string& help) {
  std::string line = "  " + name;
  line += line.size() + 2 > column_of_help ? "\n" + std::string(column_of_help, ' ')
                                           : std::string(column_of_help - line.size(), ' ');
  return line + help + "\n";
}

/// "a number, 1 to 1000; default 67.0206"
std::string RangeAndDefault(const OptionKind& option) {
  const std::string range = Range(option), value = Show(option, Options{});
  return value.empty() ? range : range + "; default " + value;
}

std::string OptionLines(const CommandKind& command) {
  std::string text;
  for (const OptionKind& option : OptionTable()) {
    if (!Takes(command, option)) continue;
    text += HelpLine(Synopsis(option.name, option.argument), option.help);
    const std::string details = RangeAndDefault(option);
    if (!details.empty()) text += std::string(column_of_help, ' ') + "(" + details + ")\n";
  }
  return text;
}

std::string CommandHelp(const CommandKind& command) {
  const std::string options = OptionLines(command);
  return "usage: " + CommandSynopsis(command) + (options.empty() ? "" : " [options]") + "\n\n" + command.help + "\n" +
         command.details + (options.empty() ? "" : "\noptions:\n" + options);
}

std::string FullHelp() {
  std::string text =
      "usage: rayimg command pictures [options]\n\n"
      "Compares, describes, converts and merges pictures, and makes movies of them; extensions say the formats of\n"
      "those written, contents of those read.\n\n"
      "commands:\n";
  for (const CommandKind& command : Commands())
    text += HelpLine(std::string(command.name) + " " + command.files, command.help);
  text += "\nrequests:\n";
  for (const RequestKind& request : Requests())
    text += HelpLine(Synopsis(request.name, request.argument), request.help);
  return text + "\nexamples:\n" + examples + "\nexit status: " + exit_status + "\n";
}

std::string MarkdownTable() {
  std::string table = "| command, option | default | values | what it does |\n|---|---|---|---|\n";
  for (const CommandKind& command : Commands()) {
    table += "|" + MarkdownCell(MarkdownCode(CommandSynopsis(command))) + " | | " + command.help + " |\n";
    for (const OptionKind& option : OptionTable())
      if (Takes(command, option))
        table += "|" + MarkdownCell(MarkdownCode(Synopsis(option.name, option.argument))) +
                 MarkdownCell(MarkdownCode(Show(option, Options{}))) + MarkdownCell(Range(option)) +
                 MarkdownCell(option.help) + "\n";
  }
  return table;
}

std::string ManualEntry(const OptionKind& option) {
  const std::string details = RangeAndDefault(option);
  return ".TP\n.B " + Roff(Synopsis(option.name, option.argument)) + "\n" + Roff(option.help) + ".\n" +
         (details.empty() ? "" : "Values: " + Roff(details) + ".\n");
}

std::string ManualSection(const CommandKind& command) {
  std::string text = ".SS " + Roff(CommandSynopsis(command)) + "\n" + Roff(command.help) + ".\n.nf\n" +
                     Roff(std::string(command.details).substr(1)) + ".fi\n";
  for (const OptionKind& option : OptionTable())
    if (Takes(command, option)) text += ManualEntry(option);
  return text;
}

}  // namespace

std::string Help(const std::string& subject) {
  if (subject.empty()) return FullHelp();
  if (subject == "markdown") return MarkdownTable();
  return CommandHelp(*FindCommand(subject));
}

std::string Version() { return ProgramAndVersion() + "\nbuilt with: " RAYPRO_FEATURES "\n"; }

std::string ManualPage() {
  std::string text = ".TH RAYIMG 1 \"\" \"" + Roff(ProgramAndVersion()) +
                     "\" \"User Commands\"\n"
                     ".SH NAME\nrayimg \\- compare, describe, convert and merge pictures, make movies of them\n"
                     ".SH SYNOPSIS\n.B rayimg\n.I command pictures\n.RI [ options ]\n.SH COMMANDS\n";
  for (const CommandKind& command : Commands()) text += ManualSection(command);
  text += ".SH REQUESTS\n";
  for (const RequestKind& request : Requests())
    text += ".TP\n.B " + Roff(Synopsis(request.name, request.argument)) + "\n" + Roff(request.help) + ".\n";
  return text + ".SH EXIT STATUS\n" + Roff(exit_status) + ".\n.SH EXAMPLES\n.nf\n" + Roff(examples) +
         ".fi\n.SH SEE ALSO\n.BR raypro (1)\n";
}

}  // namespace ray::rayimg
