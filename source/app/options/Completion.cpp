#include "source/app/options/Completion.h"

#include "source/app/options/OptionTable.h"

namespace ray {

std::string Joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

std::string Quotable(const std::string& text, const std::string& marks) {
  std::string quotable;
  for (const char c : text) {
    if (c == '\'') continue;
    if (marks.find(c) != std::string::npos) quotable += '\\';
    quotable += c;
  }
  return quotable;
}

namespace {

std::string Bash(Program program) {
  const std::string name = NameOf(program);
  std::string names, cases;
  for (const OptionKind& option : OptionTable(program)) {
    names += " -" + std::string(option.name);
    const auto choices = Choices(option);
    if (!choices.empty())
      cases += "    -" + std::string(option.name) + ") COMPREPLY=($(compgen -W '" + Joined(choices) +
               "' -- \"$word\")); return ;;\n";
  }
  return "_" + name +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  case $before in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         names.substr(1) +
         "' -- \"$word\"))\n"
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
  return text + "  '1:scene:_files'" + (program == Program::raypro ? " \\\n  '2:picture:_files'\n" : "\n");
}

std::string Fish(Program program) {
  std::string text;
  for (const OptionKind& option : OptionTable(program)) {
    text += "complete -c " + NameOf(program) + " -o " + std::string(option.name) + " -d '" +
            Quotable(option.help, "\\") + "'";
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
