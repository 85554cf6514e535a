#include "source/app/options/Completion.h"

#include "source/app/rayimg/Help.h"
#include "source/app/rayimg/Table.h"

namespace ray::rayimg {
namespace {

std::vector<std::string> FirstWords() {
  std::vector<std::string> words = CommandNames();
  for (const RequestKind& request : Requests()) words.push_back("-" + std::string(request.name));
  return words;
}

std::vector<std::string> OptionNames(const CommandKind& command) {
  std::vector<std::string> names{"-help"};
  for (const OptionKind& option : OptionTable())
    if (Takes(command, option)) names.push_back("-" + std::string(option.name));
  return names;
}

std::string Offer(const std::vector<std::string>& words) {
  return "COMPREPLY=($(compgen -W '" + Joined(words) + "' -- \"$word\"))";
}

std::string Bash() {
  std::string choices = "    -complete) " + Offer(Shells()) + "; return ;;\n", names;
  for (const OptionKind& option : OptionTable())
    if (!Choices(option).empty())
      choices += "    -" + std::string(option.name) + ") " + Offer(Choices(option)) + "; return ;;\n";
  for (const CommandKind& command : Commands())
    names += "      " + std::string(command.name) + ") " + Offer(OptionNames(command)) + " ;;\n";
  return "_rayimg() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  if [[ $COMP_CWORD -eq 1 ]]; then\n    " +
         Offer(FirstWords()) + "\n    return\n  fi\n  case $before in\n" + choices +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    case ${COMP_WORDS[1]} in\n" +
         names +
         "    esac\n"
         "  else\n"
         "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _rayimg rayimg\n";
}

std::string ZshSpecification(const OptionKind& option) {
  std::string text = "      '-" + std::string(option.name) + "[" + Quotable(option.help, "[]:") + "]";
  if (*option.argument) {
    text += ":" + Quotable(option.argument, ":") + ":";
    text += Choices(option).empty() ? "_files" : "(" + Joined(Choices(option)) + ")";
  }
  return text + "' \\\n";
}

std::string Zsh() {
  std::string text = "#compdef rayimg\nif (( CURRENT == 2 )); then\n  compadd -- " + Joined(FirstWords()) +
                     "\n  return\nfi\nlocal command=$words[2]\nshift words\n(( CURRENT-- ))\ncase $command in\n";
  for (const CommandKind& command : Commands()) {
    text += "  " + std::string(command.name) + ")\n    _arguments \\\n";
    for (const OptionKind& option : OptionTable())
      if (Takes(command, option)) text += ZshSpecification(option);
    text += "      '*:picture:_files' ;;\n";
  }
  return text + "  -complete)\n    compadd -- " + Joined(Shells()) + " ;;\nesac\n";
}

std::string Fish() {
  std::string text;
  const std::string at_first = "complete -c rayimg -n __fish_use_subcommand ";
  for (const CommandKind& command : Commands())
    text += at_first + "-a " + command.name + " -d '" + Quotable(command.help, "\\") + "'\n";
  for (const RequestKind& request : Requests())
    text += at_first + "-o " + request.name + " -d '" + Quotable(request.help, "\\") + "'" +
            (std::string(request.name) == "complete" ? " -x -a '" + Joined(Shells()) + "'" : "") + "\n";
  for (const OptionKind& option : OptionTable()) {
    text += "complete -c rayimg -n '__fish_seen_subcommand_from " +
            Joined({option.commands.begin(), option.commands.end()}) + "' -o " + option.name + " -d '" +
            Quotable(option.help, "\\") + "'";
    if (!Choices(option).empty())
      text += " -x -a '" + Joined(Choices(option)) + "'";
    else if (*option.argument)
      text += " -r";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string CompletionScript(const std::string& shell) {
  if (shell == "zsh") return Zsh();
  if (shell == "fish") return Fish();
  return Bash();
}

}  // namespace ray::rayimg
