// The kinds of options: how their values are read, formatted and described.
#include <algorithm>
#include <charconv>
#include <limits>
#include <type_traits>
#include <utility>

#include "source/app/Status.h"
#include "source/app/options/OptionTable.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

/// A set of functions for values of several types, for std::visit.
template <class... Lambda>
struct Overloaded : Lambda... {
  using Lambda::operator()...;
};
template <class... Lambda>
Overloaded(Lambda...) -> Overloaded<Lambda...>;

std::vector<std::string> ToTexts(const std::vector<int>& numbers) {
  std::vector<std::string> texts;
  for (const int number : numbers) texts.push_back(ToText(number));
  return texts;
}

std::string Joined(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

template <class T>
std::string Interval(const Number<T>& number) {
  // The largest double is not a useful limit to show, nor are the largest integers.
  if constexpr (std::is_floating_point_v<T>)
    if (number.high == std::numeric_limits<T>::max())
      return number.low == -number.high ? "a number" : "a number, at least " + ToText(number.low);
  return (std::is_floating_point_v<T> ? "a number, " : "a whole number, ") + ToText(number.low) + " to " +
         ToText(number.high);
}

[[noreturn]] void Refuse(const OptionKind& option, const std::string& word) {
  throw UsageError("-" + std::string(option.name) + " must be " + Range(option) + ", got " + Quoted(word));
}

/// Parses the whole word as a number of the type, or returns std::nullopt.
template <class T>
std::optional<T> Read(const std::string& word) {
  const auto whole = ParseWhole(word);
  if (whole.problem || !std::in_range<T>(whole.value)) return {};
  return static_cast<T>(whole.value);
}

template <>
std::optional<double> Read<double>(const std::string& word) {
  const auto number = ParseNumber(word);
  return number.problem ? std::nullopt : std::optional(number.value);
}

template <>
std::optional<std::uint64_t> Read<std::uint64_t>(const std::string& word) {
  const char* const first = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* const end = word.data() + word.size();
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(first, end, value);
  if (stop != end || error != std::errc()) return {};
  return value;
}

template <class T>
T ReadOrRefuse(const OptionKind& option, const std::string& word) {
  if (const auto value = Read<T>(word)) return *value;
  Refuse(option, word);
}

template <class T>
void StoreNumber(const OptionKind& option, const Number<T>& number, const std::string& word, Options& options) {
  const T value = ReadOrRefuse<T>(option, word);
  if (!(value >= number.low && value <= number.high)) Refuse(option, word);
  number.member.write(options) = value;
}

/// Returns the word if it is one of the choices; otherwise throws an error that names them, or the one that was meant.
const std::string& Choose(const OptionKind& option, const std::string& word, const std::vector<std::string>& choices) {
  if (std::ranges::find(choices, word) != choices.end()) return word;
  throw UsageError("-" + std::string(option.name) + " must be " + OneOf(choices) + ", got " + Quoted(word) +
                   DidYouMean(word, choices));
}

PixelRectangle ReadRectangle(const OptionKind& option, std::span<const std::string> words) {
  return {ReadOrRefuse<int>(option, words[0]), ReadOrRefuse<int>(option, words[1]), ReadOrRefuse<int>(option, words[2]),
          ReadOrRefuse<int>(option, words[3])};
}

void StoreNumbers(const OptionKind& option, const NumberList& list, std::span<const std::string> words,
                  Options& options) {
  std::vector<double> numbers;
  for (const std::string& word : words) numbers.push_back(ReadOrRefuse<double>(option, word));
  if (!list.write(options, numbers)) Refuse(option, Joined(words));
}

std::vector<std::string> ReadFileList(const OptionKind& option, const std::string& word) {
  const std::size_t comma = word.find(',');
  if (word.empty() || comma == 0 || comma + 1 == word.size()) Refuse(option, word);
  if (comma == std::string::npos) return {word};
  return {word.substr(0, comma), word.substr(comma + 1)};
}

int ReadChoice(const OptionKind& option, const OneNumberOf& one, const std::string& word) {
  const int value = ReadOrRefuse<int>(option, word);
  if (std::ranges::find(one.choices, value) == one.choices.end()) Refuse(option, word);
  return value;
}

std::string ChosenName(const OptionKind& option, const OneNameOf& one, const std::string& word) {
  const auto choices = one.choices();
  const auto place = one.by_number ? Read<std::uint64_t>(word) : std::nullopt;
  return place && *place < choices.size() ? choices[static_cast<std::size_t>(*place)] : Choose(option, word, choices);
}

void StoreRequest(const OptionKind& option, const Request& request, std::span<const std::string> words,
                  Options& options) {
  options.request = &option;
  if (words.empty()) return;
  // -help also takes the name of an option.
  const bool is_option = options.Asks("help") && FindOption(*options.program, WithoutDashes(words[0]));
  options.subject = is_option || !request.subjects ? words[0] : Choose(option, words[0], request.subjects());
}

void StorePixel(const OptionKind& option, const PixelRequest& request, std::span<const std::string> words,
                Options& options) {
  options.request = &option;
  request.member.write(options) = {ReadOrRefuse<int>(option, words[0]), ReadOrRefuse<int>(option, words[1])};
}

}  // namespace

void Store(const OptionKind& option, std::span<const std::string> words, Options& options) {
  std::visit(Overloaded{
                 [&]<class T>(const Number<T>& number) { StoreNumber(option, number, words[0], options); },
                 [&](const Flag& flag) { flag.member.write(options) = true; },
                 [&](const OnOff& on_off) {
                   on_off.member.write(options) = Choose(option, words[0], {"on", "off"}) == "on";
                 },
                 [&](const OneNumberOf& one) { one.member.write(options) = ReadChoice(option, one, words[0]); },
                 [&](const OneNameOf& one) { one.write(options, ChosenName(option, one, words[0])); },
                 [&](const Word& word) {
                   if (!word.store(options, words[0])) Refuse(option, words[0]);
                 },
                 [&](const NumberList& list) { StoreNumbers(option, list, words, options); },
                 [&](const FileList& files) { files.member.write(options) = ReadFileList(option, words[0]); },
                 [&](const FileName& file) {
                   if (words[0].empty()) Refuse(option, words[0]);
                   file.member.write(options) = words[0];
                 },
                 [&](const Repeated& list) {
                   if (!list.is_good(words[0])) Refuse(option, words[0]);
                   list.member.write(options).emplace_back(words[0]);
                 },
                 [&](const Rectangle& rectangle) { rectangle.member.write(options) = ReadRectangle(option, words); },
                 [&](const PixelRequest& request) { StorePixel(option, request, words, options); },
                 [&](const Request& request) { StoreRequest(option, request, words, options); },
             },
             option.value);
}

std::size_t MostArguments(const OptionKind& option) { return option.arguments.size(); }

std::size_t FewestArguments(const OptionKind& option) {
  const auto* request = std::get_if<Request>(&option.value);
  return request && request->takes_subject == Request::perhaps ? 0 : option.arguments.size();
}

bool IsSetting(const OptionKind& option) {
  return !std::holds_alternative<Request>(option.value) && !std::holds_alternative<PixelRequest>(option.value);
}

bool IsOfScene(const OptionKind& option) {
  const auto* request = std::get_if<Request>(&option.value);
  return request ? request->is_of_scene : std::holds_alternative<PixelRequest>(option.value);
}

Answer AnswerTo(const OptionKind& option) {
  const auto* request = std::get_if<Request>(&option.value);
  return request ? request->answer : std::get<PixelRequest>(option.value).answer;
}

std::vector<std::string_view> OptionsWith(const Program& program, Fact fact) {
  std::vector<std::string_view> names;
  for (const OptionKind& option : OptionTable(program))
    if (option.facts.Has(fact)) names.emplace_back(option.name);
  return names;
}

bool Options::Asks(const char* name) const { return request && std::string_view(request->name) == name; }

std::string Options::WhyWithoutEffect(const OptionKind& option) const {
  constexpr std::string_view without = "without ";
  std::string text;
  for (const auto& [is_met, otherwise] : option.facts.needs) {
    if (is_met(*this)) continue;
    const std::string_view why = otherwise;
    if (text.empty())
      text = why;
    else
      text += " and " + std::string(why.starts_with(without) ? why.substr(without.size()) : why);
  }
  return text;
}

std::string Options::Show(const OptionKind& option) const {
  return std::visit(Overloaded{
                        [this]<class T>(const Number<T>& number) { return ToText(number.member.read(*this)); },
                        [this](const Flag& flag) { return std::string(flag.member.read(*this) ? "on" : ""); },
                        [this](const OnOff& on_off) { return std::string(on_off.member.read(*this) ? "on" : "off"); },
                        [this](const OneNumberOf& one) { return ToText(one.member.read(*this)); },
                        [this](const OneNameOf& one) { return one.read(*this); },
                        [this](const FileName& file) { return file.member.read(*this); },
                        [this](const Word& word) { return word.show(*this); },
                        [this](const NumberList& list) {
                          std::vector<std::string> texts;
                          for (const double number : list.read(*this)) texts.push_back(ToText(number));
                          return Joined(texts);
                        },
                        [this](const FileList& pair) {
                          const auto& list = pair.member.read(*this);
                          return list.empty() ? std::string() : list.size() == 1 ? list[0] : list[0] + "," + list[1];
                        },
                        [this](const Repeated& list) { return Joined(list.member.read(*this)); },
                        [this](const Rectangle& rectangle) {
                          const auto& crop = rectangle.member.read(*this);
                          if (!crop) return std::string();
                          return ToText(crop->x0) + " " + ToText(crop->y0) + " " + ToText(crop->x1) + " " +
                                 ToText(crop->y1);
                        },
                        [](const PixelRequest&) { return std::string(); },
                        [](const Request&) { return std::string(); },
                    },
                    option.value);
}

std::vector<std::string> Options::TypedFor(const Program& reader, const OptionKind& option) const {
  const std::string name = "-" + std::string(option.name), value = Show(option);
  const bool goes_without_saying = !IsGiven(option.name) && value == reader.defaults()->Show(option);
  if (value.empty() || goes_without_saying) return {};
  if (std::holds_alternative<Flag>(option.value)) return {name};
  std::vector<std::string> words;
  if (const auto* list = std::get_if<Repeated>(&option.value)) {
    for (const auto& word : list->member.read(*this)) words.push_back(name + "=" + word);
    return words;
  }
  // A value that looks like an option needs "=".
  if (MostArguments(option) == 1 && LooksLikeOption(value)) return {name + "=" + value};
  words.push_back(name);
  if (MostArguments(option) == 1) {
    words.push_back(value);
    return words;
  }
  for (std::string& part : SplitWords(value)) words.push_back(std::move(part));
  return words;
}

std::vector<std::string> Choices(const OptionKind& option) {
  return std::visit(
      Overloaded{
          [](const OnOff&) {
            return std::vector<std::string>{"on", "off"};
          },
          [](const OneNumberOf& one) { return ToTexts(one.choices); },
          [](const OneNameOf& one) { return one.choices(); },
          [](const Request& request) { return request.subjects ? request.subjects() : std::vector<std::string>{}; },
          [](const auto&) { return std::vector<std::string>{}; },
      },
      option.value);
}

std::vector<std::string> NamedValues(const OptionKind& option) {
  const auto* word = std::get_if<Word>(&option.value);
  return word && word->names ? word->names() : Choices(option);
}

std::optional<FileKind> FileOf(const OptionKind& option) {
  return std::visit(Overloaded{
                        [](const FileName& file) { return std::optional(file.kind); },
                        [](const FileList& files) { return std::optional(files.kind); },
                        [](const Repeated& list) { return list.kind; },
                        [](const Request& request) {
                          const bool takes_file = request.takes_subject != Request::nothing && !request.subjects;
                          return takes_file ? std::optional(request.kind) : std::nullopt;
                        },
                        [](const auto&) { return std::optional<FileKind>(); },
                    },
                    option.value);
}

std::string Range(const OptionKind& option) {
  const std::string unit = *option.unit ? " " + std::string(option.unit) : "";
  return std::visit(
      Overloaded{
          [&]<class T>(const Number<T>& number) { return Interval(number) + unit; },
          [&](const Rectangle&) { return std::string("whole numbers with x0 < x1 and y0 < y1, inside the image"); },
          [&](const PixelRequest&) { return std::string("whole numbers, a column and a row of the image from 0"); },
          [&](const FileName&) { return std::string("a file name"); },
          [&](const Word& word) { return std::string(word.range) + unit; },
          [&](const NumberList& list) { return std::string(list.range) + unit; },
          [&](const FileList&) { return std::string("a file name, or two separated by a comma"); },
          [&](const Repeated& list) { return std::string(list.range); },
          [&](const Flag&) { return std::string(); },
          [&](const OneNameOf& one) {
            return OneOf(Choices(option)) + (one.by_number ? ", or its number from 0" : "") + unit;
          },
          [&](const auto&) { return OneOf(Choices(option)) + unit; },
      },
      option.value);
}

std::string Synopsis(const OptionKind& option) {
  std::string text = "-" + std::string(option.name);
  const bool is_optional = FewestArguments(option) < MostArguments(option);
  for (const char* argument : option.arguments)
    text += is_optional ? " [" + std::string(argument) + "]" : " " + std::string(argument);
  return text;
}

}  // namespace ray
