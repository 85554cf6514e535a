#include "source/app/options/Completion.h"

#include "source/app/options/OptionTable.h"

namespace ray {
namespace {

/// The words with blanks between them.
std::string Joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

/// Text within single quotes of any of the three shells; `marks`, those that zsh knows within a specification, are
/// escaped as well.
std::string Quotable(const std::string& text, const std::string& marks) {
  std::string quotable;
  for (const char c : text) {
    if (c == '\'') continue;
    if (marks.find(c) != std::string::npos) quotable += '\\';
    quotable += c;
  }
  return quotable;
}

/// The options of a command, or those of the program itself: with a dash each.
std::vector<std::string> OptionNames(Program program, const CommandKind* command) {
  std::vector<std::string> names;
  for (const OptionKind& option : OptionTable(program))
    if (command ? Takes(*command, option) : option.commands.empty()) names.push_back("-" + std::string(option.name));
  return names;
}

std::string Offer(const std::vector<std::string>& words) {
  return "COMPREPLY=($(compgen -W '" + Joined(words) + "' -- \"$word\"))";
}

/// Offers options: those of the command that came first, where the program has commands.
std::string BashOptions(Program program) {
  if (CommandsOf(program).empty()) return "    " + Offer(OptionNames(program, nullptr)) + "\n";
  std::string text = "    case ${COMP_WORDS[1]} in\n";
  for (const CommandKind& command : CommandsOf(program))
    text += "      " + std::string(command.name) + ") " + Offer(OptionNames(program, &command)) + " ;;\n";
  return text + "      *) " + Offer(OptionNames(program, nullptr)) + " ;;\n    esac\n";
}

std::string Bash(Program program) {
  const std::string name = NameOf(program);
  std::string cases;
  for (const OptionKind& option : OptionTable(program))
    if (!Choices(option).empty())
      cases += "    -" + std::string(option.name) + ") " + Offer(Choices(option)) + "; return ;;\n";
  const std::string commands = CommandsOf(program).empty() ? ""
                                                           : "  elif [[ $COMP_CWORD -eq 1 ]]; then\n    " +
                                                                 Offer(CommandNamesOf(program)) + "\n";
  return "_" + name +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  case $before in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n" +
         BashOptions(program) + commands +
         "  else\n"
         "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _" +
         name + " " + name + "\n";
}

std::string ZshSpecification(const OptionKind& option) {
  std::string text = "  '" + std::string(MayBeRepeated(option) ? "*" : "") + "-" + option.name + "[" +
                     Quotable(option.help, "[]:") + "]";
  const auto choices = Choices(option);
  const std::string optional = FewestArguments(option) < MostArguments(option) ? ":" : "";
  for (const char* argument : option.arguments) {
    text += ":" + optional + Quotable(argument, ":") + ":";
    text += choices.empty() ? "_files" : "(" + Joined(choices) + ")";
  }
  return text + "' \\\n";
}

std::string Zsh(Program program) {
  std::string text = "#compdef " + NameOf(program) + "\n_arguments \\\n";
  for (const OptionKind& option : OptionTable(program)) text += ZshSpecification(option);
  if (!CommandsOf(program).empty())
    return text + "  '1:command:(" + Joined(CommandNamesOf(program)) + ")' \\\n  '*:picture:_files'\n";
  return text + "  '1:scene:_files'" + (program == Program::raypro ? " \\\n  '2:picture:_files'\n" : "\n");
}

std::string Fish(Program program) {
  const std::string complete = "complete -c " + NameOf(program);
  std::string text;
  for (const CommandKind& command : CommandsOf(program))
    text += complete + " -n __fish_use_subcommand -a " + command.name + " -d '" + Quotable(command.help, "\\") + "'\n";
  for (const OptionKind& option : OptionTable(program)) {
    text += complete;
    if (!option.commands.empty())
      text += " -n '__fish_seen_subcommand_from " + Joined({option.commands.begin(), option.commands.end()}) + "'";
    text += " -o " + std::string(option.name) + " -d '" + Quotable(option.help, "\\") + "'";
    const auto choices = Choices(option);
    if (!choices.empty()) text += " -x -a '" + Joined(choices) + "'";
    if (choices.empty() && !option.arguments.empty()) text += " -r";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string CompletionScript(Program program, const std::string& shell) {
  if (shell == "zsh") return Zsh(program);
  if (shell == "fish") return Fish(program);
  return Bash(program);
}

}  // namespace ray
