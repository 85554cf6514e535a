#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "R2/Color.h"
#include "R3/Point.h"
#include "source/parse/document/DocumentReport.h"

namespace ray {

/// What a number may be.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool excludes_low = false;
};
inline constexpr Range any_number{};
inline constexpr Range not_negative{0};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};

class Mapping;

/// A value to be read as what its reader needs. Whatever it is not goes to the report, and the answer is nothing.
class Field {
 public:
  Field(DocumentReport& report, const Value& value) : report_(&report), value_(&value) {}

  std::optional<double> Number(const Range& range = any_number) const;
  std::optional<std::int64_t> Whole(std::int64_t low, std::int64_t high) const;
  /// true, yes, on, 1 and false, no, off, 0, in any letter case.
  std::optional<bool> Bool() const;
  std::optional<std::string> Word() const;
  /// One of `names`, in any letter case: its index. `plural` names them in a hint: "shapes".
  std::optional<std::size_t> Choice(std::span<const std::string_view> names, const std::string& plural) const;
  /// Three numbers, each within the range of coordinates.
  std::optional<R3::Vector> Vector() const;
  std::optional<R2::Color> Color() const;
  std::optional<std::vector<Field>> List() const;
  std::optional<std::vector<Field>> ListOf(std::size_t count, const std::string& what) const;
  /// `what` it describes, for messages, with its article: "a sphere".
  std::optional<Mapping> AsMapping(const std::string& what) const;

  bool IsList() const { return value_->kind == Value::Kind::sequence; }
  bool IsMapping() const { return value_->kind == Value::Kind::mapping; }
  const Value& What() const { return *value_; }
  /// "must be positive, got -1" behind the path.
  void Error(const std::string& what, const std::string& hint = {}) const { report_->Error(*value_, what, hint); }
  DocumentReport& Reporter() const { return *report_; }

 private:
  bool IsScalar(const std::string& wanted) const;
  bool MayBeNumber(const std::string& wanted) const;
  /// The numbers of a list of three.
  std::optional<std::vector<double>> Triple(const Range& range) const;

  DocumentReport* report_;
  const Value* value_;
};

/// The keys of a mapping, each asked for by its names: the usual one first, then others that mean the same. Finish()
/// must be called when all have been asked for: it reports missing keys and unknown ones.
class Mapping {
 public:
  using Names = std::initializer_list<std::string_view>;

  Mapping(DocumentReport& report, const Value& value, std::string what);

  /// Null values count as absent. Two keys of one meaning are a mistake.
  std::optional<Field> Find(Names names);
  /// Takes the field of a key that must be there.
  std::optional<Field> Need(Names names);
  /// Whether one of them is there; nothing is noted as known by it.
  bool Has(Names names) const;

  double Number(Names names, const Range& range, double otherwise);
  std::int64_t Whole(Names names, std::int64_t low, std::int64_t otherwise);
  bool Bool(Names names, bool otherwise);
  std::optional<std::string> Word(Names names);
  std::optional<R3::Vector> Vector(Names names);
  R2::Color Color(Names names, const R2::Color& otherwise);
  /// 0 after a mistake; then IsGood() is false.
  double NeedNumber(Names names, const Range& range);
  R3::Vector NeedVector(Names names);
  R3::Point NeedPoint(Names names);
  R2::Color NeedColor(Names names);

  /// Keys that may be there and say nothing.
  void Ignore(Names names);
  /// A key that is known and does nothing: said once.
  void NotSupported(Names names);
  void Finish();
  /// Finish, once every key was asked for, in a mapping that is worth nothing with one missing.
  bool FinishedWell() {
    Finish();
    return IsGood();
  }

  /// Whether no mistake was found since this was made, and nothing is missing so far.
  bool IsGood() const { return missing_.empty() && report_->Errors() == errors_before_; }

  const Value& What() const { return *value_; }
  DocumentReport& Reporter() const { return *report_; }
  const std::string& Subject() const { return what_; }

 private:
  const Entry* EntryOf(std::string_view name) const;
  void Know(Names names);

  DocumentReport* report_;
  const Value* value_;
  std::string what_;
  std::size_t errors_before_;
  std::vector<std::string_view> known_;
  std::vector<std::vector<std::string_view>> missing_;  // the names of each
};

}  // namespace ray
