#include "source/app/manual/Manual.h"

#include <algorithm>

#include "R2/ImageFile.h"
#include "source/app/options/OptionTable.h"
#include "source/parse/Format.h"
#include "source/parse/meshes/MeshFormat.h"

namespace ray {
namespace {

/// Returns the words separated by blanks, or by `between`.
std::string Joined(const std::vector<std::string>& words, const std::string& between = " ") {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : between) + word;
  return line;
}

/// Returns the options of a command, or those of the program itself, each with a dash.
std::vector<std::string> OptionNames(const Program& program, const CommandKind* command) {
  std::vector<std::string> names;
  for (const OptionKind& option : OptionTable(program))
    if (command ? Takes(*command, option) : option.commands.empty()) names.push_back("-" + std::string(option.name));
  return names;
}

/// Returns the extensions without dots: "png"; empty for files of any name, and for folders.
std::vector<std::string> ExtensionsOf(FileKind kind) {
  std::vector<std::string> extensions;
  const auto add = [&](std::string extension) {
    if (extension.starts_with('.')) extension.erase(0, 1);
    if (std::ranges::find(extensions, extension) == extensions.end()) extensions.push_back(extension);
  };
  if (kind == FileKind::image)
    for (const R2::ImageFormat& format : R2::ImageFormats()) std::ranges::for_each(format.extensions, add);
  if (kind == FileKind::scene) {
    for (const SceneFormat* format : SceneFormats()) std::ranges::for_each(format->extensions, add);
    for (const MeshFormat* format : MeshFormats()) add(format->extension);
  }
  if (kind == FileKind::scn) add("scn");
  if (kind == FileKind::json) add("json");
  return extensions;
}

/// Returns the kind of the files that come first; raypro writes an image after its scene.
FileKind FirstFiles(const Program& program) { return program.commands().empty() ? FileKind::scene : FileKind::image; }

bool IsListOfNames(const OptionKind& option) {
  const auto* word = std::get_if<Word>(&option.value);
  return word && word->is_list;
}

std::string Offer(const std::vector<std::string>& words) {
  return "COMPREPLY=($(compgen -W '" + Joined(words) + "' -- \"$word\"))";
}

/// Offers completions for the part after the last comma.
std::string OfferInList(const std::vector<std::string>& words) {
  return "COMPREPLY=($(compgen -P \"${word%\"${word##*,}\"}\" -W '" + Joined(words) + "' -- \"${word##*,}\"))";
}

std::string OfferFiles(const Program& program, FileKind kind) {
  if (kind == FileKind::any) return "COMPREPLY=($(compgen -f -- \"$word\"))";
  if (kind == FileKind::folder) return "COMPREPLY=($(compgen -d -- \"$word\"))";
  return "_" + NameOf(program) + "_files '" + Joined(ExtensionsOf(kind), "|") + "'";
}

/// Offers the values of an option; nothing for a number.
std::string BashArgument(const Program& program, const OptionKind& option) {
  const auto values = NamedValues(option);
  if (IsListOfNames(option)) return OfferInList(values) + "; ";
  if (!values.empty()) return Offer(values) + "; ";
  const auto kind = FileOf(option);
  return kind ? OfferFiles(program, *kind) + "; " : "";
}

/// Offers options: those of the first command, if the program has commands.
std::string BashOptions(const Program& program) {
  if (program.commands().empty()) return "    " + Offer(OptionNames(program, nullptr)) + "\n";
  std::string text = "    case ${COMP_WORDS[1]} in\n";
  for (const CommandKind& command : program.commands())
    text += "      " + std::string(command.name) + ") " + Offer(OptionNames(program, &command)) + " ;;\n";
  return text + "      *) " + Offer(OptionNames(program, nullptr)) + " ;;\n    esac\n";
}

/// Offers words other than options: commands, scenes, and images once a scene is named, unless there may be several.
std::string BashNames(const Program& program) {
  std::string text;
  if (!program.commands().empty())
    text += "  elif [[ $COMP_CWORD -eq 1 ]]; then\n    " + Offer(CommandNamesOf(program)) + "\n";
  if (program == Program::raypro)
    text += "  elif [[ $line == *.@(" + Joined(ExtensionsOf(FileKind::scene), "|") +
            ")' '* && $line != *' -out_folder '* ]]; then\n    " + OfferFiles(program, FileKind::image) + "\n";
  return text + "  else\n    " + OfferFiles(program, FirstFiles(program)) + "\n  fi\n";
}

/// Returns a function that offers folders, and files with certain extensions in any letter case.
std::string BashFiles(const std::string& name) {
  return "_" + name +
         "_files() {\n"
         "  local file IFS=$'\\n'\n"
         "  COMPREPLY=($(compgen -d -- \"$word\"))\n"
         "  for file in $(compgen -f -- \"$word\"); do\n"
         "    [[ ${file,,} != *.@($1) ]] || COMPREPLY+=(\"$file\")\n"
         "  done\n"
         "}\n";
}

}  // namespace

std::string BashCompletion(const Program& program) {
  const std::string name = NameOf(program);
  std::string cases;
  for (const OptionKind& option : OptionTable(program))
    if (MostArguments(option) > 0)
      cases += "    -" + std::string(option.name) + ") " + BashArgument(program, option) + "return ;;\n";
  // Bash splits "-bits=8" into three words.
  return BashFiles(name) + "_" + name +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local line=\" ${COMP_WORDS[*]:0:COMP_CWORD} \"\n"
         "  [[ $word != = ]] || word=\n"
         "  [[ $before != = ]] || before=${COMP_WORDS[COMP_CWORD-2]}\n"
         "  COMPREPLY=()\n"
         "  case $before in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n" +
         BashOptions(program) + BashNames(program) +
         "}\n"
         "complete -o filenames -F _" +
         name + " " + name + "\n";
}

}  // namespace ray
