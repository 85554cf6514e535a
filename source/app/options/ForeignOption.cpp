#include "source/app/options/ForeignOption.h"

#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "source/app/Status.h"
#include "source/app/options/OptionTable.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr const char* name_image = "the image's name follows the scene's: raypro scene.scn out.png";
constexpr const char* name_scene = "the scene needs no option: raypro scene.scn out.png";
constexpr const char* of_comp30019 =
    "raypro scene.scn out.png names both; '-as comp30019' before all else takes that course's options";
constexpr const char* by_extension = "the extension of the image's name chooses its format";
constexpr const char* both_sizes = "use -width and -height";
constexpr const char* in_scene = "the scene states its camera, lights and background";
constexpr const char* no_window = "raypro opens no window; leave it out";
constexpr const char* no_gpu = "raypro renders on the processor alone; leave it out";
constexpr const char* no_parameters =
    "a scene has no parameters; options such as -samples 64 take their place";
constexpr const char* afterwards =
    "values are written as they are, or with -srgb; rayimg convert has -exposure and -tonemap";

/// Words for which no single option is the answer. Where one is, its row of the option table has the word.
constexpr std::pair<const char*, const char*> phrases[] = {
    {"-size", both_sizes},       {"-r", both_sizes},           {"-res", both_sizes},       {"-resolution", both_sizes},
    {"-o", name_image},          {"-out", name_image},         {"-outfile", name_image},   {"-output", name_image},
    {"-f", of_comp30019},        {"-file", name_scene},        {"-i", name_scene},         {"-in", name_scene},
    {"-input", name_scene},      {"-scene", name_scene},       {"-F", by_extension},       {"-camera", in_scene},
    {"-background", in_scene},   {"-b", no_window},            {"-display", no_window},    {"-gpu", no_gpu},
    {"-cuda", no_gpu},           {"-D", no_parameters},        {"-P", no_parameters},      {"-gamma", afterwards},
    {"-exposure", afterwards},   {"-tonemap", afterwards},     {"-gui", "rayview shows a scene in a window"},
    {"-path", "did you mean '-mode path'?"}, {"-bvh", "did you mean '-accel bvh'?"},
    {"+I", name_scene},          {"+O", name_image},           {"+F", by_extension},       {"+D", no_window},
};

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Another renderer's word, with its dash or plus, and the answer to it.
struct Foreign {
  std::string word, answer;  // the answer is an option of ours with its dash, or a phrase
};

/// The options' own words come before phrases, so that -o is -image in rayview, which has that option.
std::vector<Foreign> ForeignWords(const Program& program) {
  std::vector<Foreign> words;
  for (const OptionKind& option : OptionTable(program))
    for (const std::string word : option.facts.elsewhere)
      words.push_back({word.starts_with('+') ? word : "-" + word, "-" + std::string(option.name)});
  for (const auto& [word, phrase] : phrases) words.push_back({word, phrase});
  return words;
}

bool Accepts(const Program& program, const OptionKind& option, const std::string& value) {
  if (MostArguments(option) != 1) return false;
  try {
    const std::vector<std::string> words{value};
    Store(option, words, *program.defaults());
    return true;
  } catch (const UsageError&) {
    return false;
  }
}

/// The answer, with the value that was typed as one word with the option if the option accepts it.
std::string AnswerText(const Program& program, const Foreign& foreign, const std::string& value) {
  if (!foreign.answer.starts_with('-')) return "; " + foreign.answer;
  const OptionKind* option = FindOption(program, foreign.answer.substr(1));
  const bool shows_value = !value.empty() && option && Accepts(program, *option, value);
  return "; did you mean '" + foreign.answer + (shows_value ? " " + value : "") + "'?";
}

/// The answer to the entry that is the longest beginning of POV-Ray's option.
std::string AnswerToPlus(const Program& program, const std::string& word, const std::string& value) {
  Foreign best;
  for (const Foreign& foreign : ForeignWords(program))
    if (word.starts_with(foreign.word) && foreign.word.size() > best.word.size()) best = foreign;
  return best.word.empty() ? std::string() : AnswerText(program, best, value);
}

std::string AnswerTo(const Program& program, const std::string& word, const std::string& value) {
  for (const Foreign& foreign : ForeignWords(program))
    if (word == foreign.word) return AnswerText(program, foreign, value);
  return {};
}

/// "512" of "-w512", and of "+W512".
std::string DigitsAtTheEnd(const std::string& word) {
  std::size_t begin = word.size();
  while (begin > 0 && IsDigit(word[begin - 1])) --begin;
  return word.substr(begin);
}

}  // namespace

bool IsOfPovRay(const std::string& word) {
  return word.size() > 1 && word[0] == '+' && std::isalpha(static_cast<unsigned char>(word[1]));
}

std::string ForeignHint(const Program& program, const std::string& word) {
  if (!(program == Program::raypro || program == Program::rayview)) return {};
  if (IsOfPovRay(word)) return AnswerToPlus(program, word, DigitsAtTheEnd(word));
  const std::string option = "-" + SplitOption(word).name, digits = DigitsAtTheEnd(option);
  const std::string answer = AnswerTo(program, option, {});
  return answer.empty() ? AnswerTo(program, option.substr(0, option.size() - digits.size()), digits) : answer;
}

}  // namespace ray
