#include "source/app/rayimg/CommandLine.h"

#include <algorithm>
#include <optional>
#include <set>

#include "source/app/Status.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

std::string Usage(const CommandKind& command) {
  return "; type rayimg " + std::string(command.name) + " " + command.files + " [options]";
}

bool IsHelp(const std::string& word) {
  if (!LooksLikeOption(word)) return false;
  const std::string name = SplitOption(word).name;
  return name == "help" || name == "h";
}

/// Commands, and "markdown", the README's table.
std::string CheckedSubject(const std::string& word) {
  std::vector<std::string> subjects = CommandNames();
  subjects.emplace_back("markdown");
  if (std::ranges::find(subjects, word) != subjects.end()) return word;
  throw UsageError("-help must be of " + OneOf(subjects) + ", got " + Quoted(word) + DidYouMean(word, subjects));
}

/// -help anywhere is answered, whatever else is wrong.
std::optional<Job> HelpAnywhere(std::span<const std::string> words) {
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    if (!IsHelp(words[i])) continue;
    Job job;
    job.request = "help";
    if (const auto attached = SplitOption(words[i]).attached)
      job.subject = CheckedSubject(*attached);
    else if (FindCommand(words[0]))
      job.subject = words[0];
    else if (i == 0 && words.size() == 2)
      job.subject = CheckedSubject(words[1]);
    return job;
  }
  return {};
}

/// -version, -complete shell, -man
Job ReadRequest(std::span<const std::string> words) {
  const auto [name, attached] = SplitOption(words[0]);
  std::vector<std::string> names;
  for (const RequestKind& request : Requests()) names.push_back("-" + std::string(request.name));
  if (std::ranges::find(names, "-" + name) == names.end())
    throw UsageError(Quoted(words[0]) + " is neither a command nor a request" + DidYouMean("-" + name, names) +
                     " (rayimg -help lists them all)");
  std::vector<std::string> arguments(words.begin() + 1, words.end());
  if (attached) arguments.insert(arguments.begin(), *attached);
  const std::size_t wanted = name == "complete" ? 1 : 0;
  if (arguments.size() != wanted)
    throw UsageError("-" + name + " needs " + Counted(wanted, "argument") + ", got " +
                     std::to_string(arguments.size()));
  const std::vector<std::string> choices = Shells();
  if (wanted == 1 && std::ranges::find(choices, arguments[0]) == choices.end())
    throw UsageError("-complete must be " + OneOf(choices) + ", got " + Quoted(arguments[0]) +
                     DidYouMean(arguments[0], choices));
  Job job;
  job.request = name;
  if (wanted == 1) job.subject = arguments[0];
  return job;
}

const CommandKind& KnownCommand(const std::string& word) {
  if (const CommandKind* command = FindCommand(word)) return *command;
  const std::string hint = DidYouMean(word, CommandNames());
  throw UsageError("unknown command " + Quoted(word) + (hint.empty() ? "; it must be " + OneOf(CommandNames()) : hint));
}

const OptionKind& Known(const CommandKind& command, const std::string& word) {
  const std::string name = SplitOption(word).name;
  const OptionKind* option = FindOption(name);
  if (option && Takes(command, *option)) return *option;
  if (option)
    throw UsageError(Quoted(word) + " is no option of rayimg " + command.name + ", but of " +
                     OneOf({option->commands.begin(), option->commands.end()}));
  std::vector<std::string> names;
  for (const OptionKind& known : OptionTable())
    if (Takes(command, known)) names.push_back("-" + std::string(known.name));
  throw UsageError("unknown option " + Quoted(word) + DidYouMean("-" + name, names) + " (rayimg " + command.name +
                   " -help lists them all)");
}

/// Stores the option at the front of `words`; how many of them it took.
std::size_t TakeOption(const OptionKind& option, std::span<const std::string> words, Options& options) {
  const std::string synopsis = Synopsis(option.name, option.argument);
  const auto attached = SplitOption(words[0]).attached;
  if (!*option.argument) {
    if (attached) throw UsageError(Quoted(words[0]) + ": -" + option.name + " takes no argument");
    Store(option, "", options);
    return 1;
  }
  if (attached) {
    Store(option, *attached, options);
    return 1;
  }
  if (words.size() < 2 || LooksLikeOption(words[1]))
    throw UsageError("-" + std::string(option.name) + " needs an argument; type " + synopsis);
  Store(option, words[1], options);
  return 2;
}

void TakeName(const std::string& word, const CommandKind& command, Options& options) {
  if (word.empty()) throw UsageError("a file name is empty");
  if (options.names.size() == command.most) throw UsageError(Quoted(word) + " is one name too many" + Usage(command));
  options.names.push_back(word);
}

void CheckTogether(const CommandKind& command, const Options& options) {
  if (options.names.size() < command.fewest)
    throw UsageError("rayimg " + std::string(command.name) + " needs " + Counted(command.fewest, "name") + ", got " +
                     std::to_string(options.names.size()) + Usage(command));
  if (options.fail_percent && !options.fail) throw UsageError("-fail_percent needs -fail, which says what fails");
  if (std::string(command.name) == "merge" && options.out.empty())
    throw UsageError("rayimg merge needs -out picture, the picture to write");
  if (!options.weights.empty() && options.weights.size() != options.names.size())
    throw UsageError("-weights has " + Counted(options.weights.size(), "number") + " for " +
                     Counted(options.names.size(), "picture"));
}

}  // namespace

Job ReadCommandLine(std::span<const std::string> words) {
  if (const auto help = HelpAnywhere(words)) return *help;
  if (words.empty()) throw UsageError("no command is named; it must be " + OneOf(CommandNames()) + " (rayimg -help)");
  if (LooksLikeOption(words[0])) return ReadRequest(words);

  Job job;
  const CommandKind& command = KnownCommand(words[0]);
  job.command = &command;
  std::set<const OptionKind*> seen;
  bool only_names = false;
  for (std::size_t i = 1; i < words.size();) {
    const std::string& word = words[i];
    if (!only_names && word == "--") {
      only_names = true;
      ++i;
    } else if (only_names || !LooksLikeOption(word)) {
      TakeName(word, command, job.options);
      ++i;
    } else {
      const OptionKind& option = Known(command, word);
      if (!seen.insert(&option).second)
        throw UsageError(Quoted(word) + " comes a second time; an option may be given once");
      i += TakeOption(option, words.subspan(i), job.options);
    }
  }
  CheckTogether(command, job.options);
  return job;
}

}  // namespace ray::rayimg
