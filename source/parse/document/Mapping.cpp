#include "source/parse/document/Mapping.h"

#include <algorithm>

#include "source/parse/Coordinate.h"
#include "source/text/LookAlike.h"
#include "source/text/LowerCase.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Suggestion.h"
#include "source/text/Words.h"

namespace ray {

void DocumentReport::Error(const Value& value, const std::string& what, const std::string& hint) {
  ++errors_;
  const std::string message = PathOf(value) + (what.starts_with(':') ? "" : " ") + what;
  report_.Error(ErrorAt(document_.Source(), At(value.extent), message, hint));
}

void DocumentReport::ErrorAtKey(const Entry& entry, const std::string& message, const std::string& hint) {
  ++errors_;
  report_.Error(ErrorAt(document_.Source(), At(entry.key_extent), message, hint));
}

void DocumentReport::ErrorIn(const Value& value, SceneError error) {
  ++errors_;
  error.included_from.push_back(PlaceOf(value.extent));
  report_.Error(std::move(error));
}

void DocumentReport::Warn(const Extent& extent, const std::string& message) {
  const Token token = At(extent);
  report_.Warn(Place(document_.Source().name, token.line, token.column), message);
}

void DocumentReport::WarnOnce(const std::string& subject, const Extent& extent, const std::string& message) {
  if (warned_.insert(subject).second) Warn(extent, message);
}

std::string DocumentReport::HexColorBehind(const Entry& entry) const {
  return entry.value.kind == Value::Kind::null ? HexColorHint(document_.Source(), At(entry.key_extent)) : "";
}

std::string DocumentReport::PathOf(const Value& value) const {
  const std::string path = document_.PathOf(value);
  return path.empty() ? "the scene" : path;
}

std::string DocumentReport::PlaceOf(const Extent& extent) const {
  return document_.Source().name + ":" + std::to_string(At(extent).line);
}

namespace {

/// Returns the description of a value for "got ...": the word itself, or the kind of value.
std::string Shown(const Value& value) {
  return value.kind == Value::Kind::scalar ? Quoted(value.scalar) : NameOf(value.kind);
}

std::string Rule(const Range& range) {
  if (range.low == 0 && std::isinf(range.high)) return range.excludes_low ? "must be positive" : "must not be negative";
  return "must be " + std::string(range.excludes_low ? "above " : "from ") + ToText(range.low) +
         (range.excludes_low ? " and at most " : " to ") + ToText(range.high);
}

bool IsWithin(double x, const Range& range) {
  return (range.excludes_low ? x > range.low : x >= range.low) && x <= range.high;
}

std::string Listed(std::span<const std::string_view> names) {
  std::vector<std::string> all;
  for (const std::string_view name : names) all.push_back(Escaped(name));
  return OneOf(all);
}

}  // namespace

bool Field::IsScalar(const std::string& wanted) const {
  if (value_->kind == Value::Kind::scalar) return true;
  Error("must be " + wanted + ", got " + Shown(*value_));
  return false;
}

bool Field::MayBeNumber(const std::string& wanted) const {
  if (value_->may_be_number) return true;
  Error("must be " + wanted + ", got " + Shown(*value_) + " in quotation marks");
  return false;
}

std::optional<double> Field::Number(const Range& range) const {
  if (!IsScalar("a number")) return {};
  const auto [number, problem] = ParseNumber(value_->scalar);
  if (problem) {
    Error(std::string(problem) + ", got " + Shown(*value_));
    return {};
  }
  if (!MayBeNumber("a number")) return {};
  if (!IsWithin(number, range)) {
    Error(Rule(range) + ", got " + Escaped(value_->scalar));
    return {};
  }
  return number;
}

std::optional<std::int64_t> Field::Whole(std::int64_t low, std::int64_t high) const {
  if (!IsScalar("a whole number")) return {};
  const auto [number, problem] = ParseWhole(value_->scalar);
  if (problem) {
    Error(std::string(problem) + ", got " + Shown(*value_));
    return {};
  }
  if (!MayBeNumber("a whole number")) return {};
  if (number < low || number > high) {
    Error("must be from " + ToText(low) + " to " + ToText(high) + ", got " + Escaped(value_->scalar));
    return {};
  }
  return number;
}

std::optional<bool> Field::Bool() const {
  if (!IsScalar("true or false")) return {};
  const std::string word = LowerCase(value_->scalar);
  for (const char* yes : {"true", "yes", "on", "1"})
    if (word == yes) return true;
  for (const char* no : {"false", "no", "off", "0"})
    if (word == no) return false;
  Error("must be true or false, got " + Shown(*value_));
  return {};
}

std::optional<std::string> Field::Word() const {
  if (!IsScalar("a word")) return {};
  return value_->scalar;
}

std::optional<std::size_t> Field::Choice(std::span<const std::string_view> names, const std::string& plural) const {
  if (!IsScalar("a word")) return {};
  const std::string word = LowerCase(value_->scalar);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (word == LowerCase(std::string(names[i]))) return i;
  Error("is unknown: " + Shown(*value_), Suggestion(value_->scalar, names, plural));
  return {};
}

std::optional<std::vector<Field>> Field::List() const {
  if (!IsList()) {
    Error("must be a list, got " + Shown(*value_));
    return {};
  }
  std::vector<Field> fields;
  for (const Entry& entry : value_->Entries()) fields.emplace_back(*report_, entry.value);
  return fields;
}

std::optional<std::vector<Field>> Field::ListOf(std::size_t count, const std::string& what) const {
  if (!IsList()) {
    Error("must be " + what + ", got " + Shown(*value_));
    return {};
  }
  if (value_->Entries().size() != count) {
    Error("must be " + what + ", got a list of " + std::to_string(value_->Entries().size()));
    return {};
  }
  return List();
}

std::optional<std::vector<double>> Field::Triple(const Range& range) const {
  const auto fields = ListOf(3, "a list of three numbers");
  if (!fields) return {};
  std::vector<double> numbers;
  for (const Field& field : *fields)
    if (const auto number = field.Number(range)) numbers.push_back(*number);
  if (numbers.size() != fields->size()) return {};
  return numbers;
}

std::optional<R3::Vector> Field::Vector() const {
  const auto numbers = Triple({-largest_coordinate, largest_coordinate});
  if (!numbers) return {};
  return R3::Vector{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

std::optional<R2::Color> Field::Color() const {
  const auto numbers = Triple(not_negative);
  if (!numbers) return {};
  return R2::Color{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

std::optional<Mapping> Field::AsMapping(const std::string& what) const {
  if (IsMapping()) return Mapping(*report_, *value_, what);
  Error("must be a mapping, got " + Shown(*value_));
  return {};
}

Mapping::Mapping(DocumentReport& report, const Value& value, std::string what)
    : report_(&report), value_(&value), what_(std::move(what)), errors_before_(report.Errors()) {}

const Entry* Mapping::EntryOf(std::string_view name) const {
  for (const Entry& entry : value_->Entries())
    if (entry.key == name) return &entry;
  return nullptr;
}

void Mapping::Know(Names names) { known_.insert(known_.end(), names.begin(), names.end()); }

bool Mapping::Has(Names names) const {
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    const Entry* entry = EntryOf(name);
    return entry && entry->value.kind != Value::Kind::null;
  });
}

std::optional<Field> Mapping::Find(Names names) {
  Know(names);
  const Entry* found = nullptr;
  for (const std::string_view name : names) {
    const Entry* entry = EntryOf(name);
    if (!entry || entry->value.kind == Value::Kind::null) continue;
    if (found)
      report_->ErrorAtKey(*entry, "'" + entry->key + "' means the same as '" + found->key + "'", "give one of them");
    if (!found) found = entry;
  }
  if (!found) return {};
  return Field(*report_, found->value);
}

std::optional<Field> Mapping::Need(Names names) {
  auto field = Find(names);
  if (!field) missing_.emplace_back(names);
  return field;
}

double Mapping::Number(Names names, const Range& range, double otherwise) {
  const auto field = Find(names);
  return field ? field->Number(range).value_or(otherwise) : otherwise;
}

std::int64_t Mapping::Whole(Names names, std::int64_t low, std::int64_t otherwise) {
  const auto field = Find(names);
  return field ? field->Whole(low, std::numeric_limits<int>::max()).value_or(otherwise) : otherwise;
}

bool Mapping::Bool(Names names, bool otherwise) {
  const auto field = Find(names);
  return field ? field->Bool().value_or(otherwise) : otherwise;
}

std::optional<std::string> Mapping::Word(Names names) {
  const auto field = Find(names);
  return field ? field->Word() : std::nullopt;
}

std::optional<R3::Vector> Mapping::Vector(Names names) {
  const auto field = Find(names);
  return field ? field->Vector() : std::nullopt;
}

R2::Color Mapping::Color(Names names, const R2::Color& otherwise) {
  const auto field = Find(names);
  return field ? field->Color().value_or(otherwise) : otherwise;
}

double Mapping::NeedNumber(Names names, const Range& range) {
  const auto field = Need(names);
  return field ? field->Number(range).value_or(0) : 0;
}

R3::Vector Mapping::NeedVector(Names names) {
  const auto field = Need(names);
  return field ? field->Vector().value_or(R3::Vector{}) : R3::Vector{};
}

R3::Point Mapping::NeedPoint(Names names) { return R3::Point{} + NeedVector(names); }

R2::Color Mapping::NeedColor(Names names) {
  const auto field = Need(names);
  return field ? field->Color().value_or(R2::Color{}) : R2::Color{};
}

void Mapping::Ignore(Names names) { Know(names); }

void Mapping::NotSupported(Names names) {
  Know(names);
  for (const std::string_view name : names)
    if (const Entry* entry = EntryOf(name))
      report_->WarnOnce(what_ + " " + entry->key, entry->key_extent,
                        "'" + entry->key + "' is not supported and ignored");
}

void Mapping::Finish() {
  std::vector<const Entry*> unknown;
  for (const Entry& entry : value_->Entries())
    if (std::find(known_.begin(), known_.end(), entry.key) == known_.end()) unknown.push_back(&entry);
  for (const auto& names : missing_) {
    // A key with a similar name was certainly meant for it.
    const auto meant = std::find_if(unknown.begin(), unknown.end(), [&](const Entry* entry) {
      return Suggestion(entry->key, names, "").starts_with("did you mean");
    });
    if (meant != unknown.end()) {
      report_->ErrorAtKey(**meant, "unknown key " + Quoted((*meant)->key) + " in " + what_,
                          Suggestion((*meant)->key, names, ""));
      unknown.erase(meant);
      continue;
    }
    std::string hint = names.size() > 1 ? "the key is " + Listed(names) : "";
    for (const std::string_view name : names)
      if (const Entry* entry = EntryOf(name))
        if (std::string color = report_->HexColorBehind(*entry); !color.empty()) hint = std::move(color);
    report_->Error(*value_, "lacks " + std::string(names.front()), hint);
  }
  missing_.clear();
  if (report_->Errors() == errors_before_)
    for (const Entry& entry : value_->Entries())
      if (const std::string color = report_->HexColorBehind(entry); !color.empty())
        report_->Warn(entry.key_extent, Quoted(entry.key) + " has no value: " + color);
  for (const Entry* entry : unknown) {
    const std::vector<std::string> choices(known_.begin(), known_.end());
    const std::string look_alike = LookAlikeHint(entry->key);
    report_->WarnOnce(
        what_ + " " + entry->key, entry->key_extent,
        "unknown key " + Quoted(entry->key) + " in " + what_ + " is ignored" +
            (look_alike.empty() ? DidYouMean(entry->key.substr(0, most_quoted), choices) : "; " + look_alike));
  }
}

}  // namespace ray
