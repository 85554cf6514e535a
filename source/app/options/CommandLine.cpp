#include "source/app/options/CommandLine.h"

#include <set>
#include <vector>

#include "source/app/Status.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/FileNames.h"
#include "source/app/options/OptionTable.h"
#include "source/text/LookAlike.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// Returns "; -crop is an option of raypro", or the probable intention.
std::string HintAt(const Program& program, const std::string& name) {
  const std::string without_digits = name.substr(0, name.find_last_not_of("0123456789") + 1);  // -spp4
  for (const OptionKind& option : OptionTable(program))
    for (const std::string elsewhere : option.facts.elsewhere)
      if (elsewhere == name || elsewhere == without_digits)
        return "; did you mean '-" + std::string(option.name) + "'?";
  for (const char* names_file : {"o", "out", "outfile", "output", "f", "file", "i", "in", "input", "scene"})
    if (name == names_file) return "; files need no option: " + Usage(program);
  for (const Program* other : {&Program::raypro, &Program::rayview})
    if (const OptionKind* option = FindOption(*other, name))
      return "; -" + std::string(option->name) + " is an option of " + other->name;
  std::vector<std::string> names;
  for (const OptionKind& known : OptionTable(program)) names.push_back("-" + std::string(known.name));
  return DidYouMean("-" + name, names);
}

const OptionKind& Known(const Program& program, const std::string& word) {
  const std::string name = SplitOption(word).name;
  if (const OptionKind* option = FindOption(program, name)) return *option;
  throw UsageError("unknown option " + Quoted(word) + HintAt(program, name) + " (" + NameOf(program) +
                   " -help lists them all)");
}

/// Rejects "–width", which begins with a dash other than the ASCII one and would be a file name.
void RefuseLookAlikes(const Program& program, std::span<const std::string> words) {
  for (const std::string& word : words) {
    if (word == "--") return;
    const std::string plain = WithoutLookAlikes(word);
    if (plain == word || LooksLikeOption(word) || !LooksLikeOption(plain)) continue;
    if (FindOption(program, SplitOption(plain).name))
      throw UsageError("unknown option " + Quoted(word) + "; " + LookAlikeHint(word));
  }
}

/// The arguments of the option at the front of `words`, and the total number of words.
struct Arguments {
  std::vector<std::string> values;
  std::size_t words_taken = 1;
};

Arguments TakeArguments(const OptionKind& option, std::span<const std::string> words) {
  const std::string synopsis = Synopsis(option);
  Arguments arguments;
  if (const auto attached = SplitOption(words[0]).attached) {
    if (MostArguments(option) == 0) throw UsageError(Quoted(words[0]) + ": " + Quoted(synopsis) + " takes no value");
    if (MostArguments(option) != 1) throw UsageError(Quoted(words[0]) + ": '=' takes exactly one value: " + synopsis);
    arguments.values.push_back(*attached);
    return arguments;
  }
  while (arguments.values.size() < MostArguments(option) && arguments.words_taken < words.size() &&
         !LooksLikeOption(words[arguments.words_taken]))
    arguments.values.push_back(words[arguments.words_taken++]);
  if (arguments.values.size() >= FewestArguments(option)) return arguments;
  if (arguments.values.empty())
    throw UsageError("-" + std::string(option.name) +
                     (MostArguments(option) == 1 ? " needs a value: " : " needs values: ") + synopsis);
  throw UsageError("-" + std::string(option.name) + " needs " + Counted(MostArguments(option), "value") + ", got " +
                   std::to_string(arguments.values.size()) + ": " + synopsis);
}

void RefuseSecondRequest(const OptionKind& option, const std::string& word, const Options& options) {
  if (IsSetting(option) || !options.request || options.request == &option) return;
  throw UsageError(Quoted(word) + " cannot be combined with -" + options.request->name);
}

const CommandKind& KnownCommand(const Program& program, const std::string& word) {
  if (const CommandKind* command = FindCommand(program, word)) return *command;
  const std::vector<std::string> names = CommandNamesOf(program);
  const std::string hint = DidYouMean(word, names);
  throw UsageError("unknown command " + Quoted(word) + (hint.empty() ? "; it must be " + OneOf(names) : hint));
}

void TakeName(const std::string& word, Options& options) {
  if (word.empty()) throw UsageError("a file name is empty");
  if (!options.command && !options.program->commands().empty())
    options.command = &KnownCommand(*options.program, word);
  else if (options.command && options.names.size() == options.command->most)
    RefuseName(word, UsageOf(*options.program, options.command));
  else
    options.names.push_back(word);
}

/// Rejects "-h 512", which was meant as a height.
void RefuseHeight(const OptionKind& option, std::span<const std::string> words) {
  const auto [name, attached] = SplitOption(words[0]);
  const std::string value = attached ? *attached : words.size() > 1 ? words[1] : "";
  const auto height = ParseWhole(value);
  if (name == option.name || height.problem || height.value < 1) return;
  throw UsageError(Quoted("-" + name + " " + value) + ": -" + name + " is -" + option.name +
                   "; did you mean '-height " + value + "'?");
}

/// Answers -help anywhere, even if other words are wrong. (The course's program then exits with failure; ours succeeds,
/// as users of other programs expect.) Returns null if there is no -help.
std::unique_ptr<Options> HelpAnywhere(const Program& program, std::span<const std::string> words) {
  const OptionKind* const help = FindOption(program, "help");
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    if (!LooksLikeOption(words[i]) || FindOption(program, SplitOption(words[i]).name) != help) continue;
    RefuseHeight(*help, words.subspan(i));
    auto options = program.defaults();
    options->request = help;
    // After other words, the word behind -help may be a file or a topic, and plain help is never wrong.
    const bool has_topic = SplitOption(words[i]).attached || (i == 0 && words.size() == 2);
    if (has_topic)
      Store(*help, TakeArguments(*help, words.subspan(i)).values, *options);
    else if (FindCommand(program, words[0]))
      options->subject = words[0];
    return options;
  }
  return nullptr;
}

void CheckCommand(const Options& options) {
  const Program& program = *options.program;
  if (options.request && options.command) RefuseName(options.command->name, "");
  if (options.request || program.commands().empty()) return;
  if (!options.command)
    throw UsageError("no command is named; it must be " + OneOf(CommandNamesOf(program)) + UsageOf(program));
  const CommandKind& command = *options.command;
  for (const std::string& name : options.given)
    if (const OptionKind* option = FindOption(program, name); !Takes(command, *option))
      throw UsageError("-" + name + " is an option of " + program.name + " " +
                       OneOf({option->commands.begin(), option->commands.end()}) + ", not of " + command.name);
  if (options.names.size() < command.fewest)
    throw UsageError(std::string(command.name) + " needs " + Counted(command.fewest, "file name") + ", got " +
                     std::to_string(options.names.size()) + UsageOf(program, &command));
}

void CheckContradictions(const Options& options) {
  for (const OptionKind& option : OptionTable(*options.program))
    for (const char* other : option.facts.excludes)
      if (options.IsGiven(option.name) && options.IsGiven(other))
        throw UsageError("-" + std::string(option.name) + " and -" + other + " contradict each other");
}

}  // namespace

std::unique_ptr<Options> ReadWords(const Program& program, std::span<const std::string> words) {
  if (auto help = HelpAnywhere(program, words)) return help;

  RefuseLookAlikes(program, words);
  auto options = program.defaults();
  std::set<const OptionKind*> seen;
  bool only_names = false;
  for (std::size_t i = 0; i < words.size();) {
    const std::string& word = words[i];
    if (!only_names && word == "--") {
      only_names = true;
      ++i;
    } else if (only_names || !LooksLikeOption(word)) {
      TakeName(word, *options);
      ++i;
    } else {
      const OptionKind& option = Known(program, word);
      seen.insert(&option);
      RefuseSecondRequest(option, word, *options);
      const Arguments arguments = TakeArguments(option, words.subspan(i));
      Store(option, arguments.values, *options);
      i += arguments.words_taken;
    }
  }

  for (const OptionKind* option : seen) options->given.emplace_back(option->name);
  if (options->request && !AnswerTo(*options->request))
    throw UsageError("-" + std::string(options->request->name) + " " + options->subject + " must come first");
  CheckCommand(*options);
  CheckContradictions(*options);
  program.complete(*options, words);
  return options;
}

}  // namespace ray
