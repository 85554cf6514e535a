#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "R2/Color.h"
#include "R3/Point.h"
#include "source/parse/SceneError.h"
#include "source/parse/document/Document.h"

namespace ray {

/// Reports mistakes in a document at their positions.
class DocumentReport {
 public:
  DocumentReport(const Document& document, Report& report) : document_(document), report_(report) {}

  /// Reports "Objects[2].radius must be a number": the path of the value, then `what`, separated by a blank, or by a
  /// colon if `what` begins with a blank.
  void Error(const Value& value, const std::string& what, const std::string& hint = {});
  /// Reports a mistake where the path is not informative, as at a key.
  void ErrorAtKey(const Entry& entry, const std::string& message, const std::string& hint = {});
  /// Reports an error in a file named by the value, with the position of the name.
  void ErrorIn(const Value& value, SceneError error);

  void Warn(const Extent& extent, const std::string& message);
  /// Warns only once per `subject`.
  void WarnOnce(const std::string& subject, const Extent& extent, const std::string& message);

  /// Returns the number of mistakes so far, by which readers know whether everything went well.
  std::size_t Errors() const { return errors_; }
  /// Returns HexColorHint for a key without a value.
  std::string HexColorBehind(const Entry& entry) const;
  std::string PathOf(const Value& value) const;
  /// Returns "scene.yaml:12".
  std::string PlaceOf(const Extent& extent) const;
  Token At(const Extent& extent) const { return document_.At(extent); }
  const Document& Source() const { return document_; }

 private:
  const Document& document_;
  Report& report_;
  std::size_t errors_ = 0;
  std::set<std::string> warned_;
};

/// The range of a number.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool excludes_low = false;
};
inline constexpr Range any_number{};
inline constexpr Range not_negative{0};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};

class Mapping;

/// A value to be read as the type that its reader needs. A mismatch goes to the report, and the result is std::nullopt.
class Field {
 public:
  Field(DocumentReport& report, const Value& value) : report_(&report), value_(&value) {}

  std::optional<double> Number(const Range& range = any_number) const;
  std::optional<std::int64_t> Whole(std::int64_t low, std::int64_t high) const;
  /// Reads true, yes, on, 1 or false, no, off, 0, in any letter case.
  std::optional<bool> Bool() const;
  std::optional<std::string> Word() const;
  /// Reads one of `names`, in any letter case, and returns its index. `plural` is their name in a hint: "shapes".
  std::optional<std::size_t> Choice(std::span<const std::string_view> names, const std::string& plural) const;
  /// Reads three numbers, each within the range of coordinates.
  std::optional<R3::Vector> Vector() const;
  std::optional<R2::Color> Color() const;
  std::optional<std::vector<Field>> List() const;
  std::optional<std::vector<Field>> ListOf(std::size_t count, const std::string& what) const;
  /// Reads a mapping; `what` is its description in messages, with its article: "a sphere".
  std::optional<Mapping> AsMapping(const std::string& what) const;

  bool IsList() const { return value_->kind == Value::Kind::sequence; }
  bool IsMapping() const { return value_->kind == Value::Kind::mapping; }
  const Value& What() const { return *value_; }
  /// Reports "must be positive, got -1" after the path.
  void Error(const std::string& what, const std::string& hint = {}) const { report_->Error(*value_, what, hint); }
  DocumentReport& Reporter() const { return *report_; }

 private:
  bool IsScalar(const std::string& wanted) const;
  bool MayBeNumber(const std::string& wanted) const;
  /// Reads a list of three numbers.
  std::optional<std::vector<double>> Triple(const Range& range) const;

  DocumentReport* report_;
  const Value* value_;
};

/// The keys of a mapping, each looked up by its names: the usual one first, then synonyms. Finish() must be called
/// after all keys were looked up: it reports missing and unknown ones.
class Mapping {
 public:
  using Names = std::initializer_list<std::string_view>;

  Mapping(DocumentReport& report, const Value& value, std::string what);

  /// Looks up a field. Null values count as absent. Two keys with one meaning are a mistake.
  std::optional<Field> Find(Names names);
  /// Looks up a required field.
  std::optional<Field> Need(Names names);
  /// Returns true if one of the keys is present; does not mark it as known.
  bool Has(Names names) const;

  double Number(Names names, const Range& range, double otherwise);
  std::int64_t Whole(Names names, std::int64_t low, std::int64_t otherwise);
  bool Bool(Names names, bool otherwise);
  std::optional<std::string> Word(Names names);
  std::optional<R3::Vector> Vector(Names names);
  R2::Color Color(Names names, const R2::Color& otherwise);
  /// Returns a required number; 0 after a mistake, and then IsGood() is false.
  double NeedNumber(Names names, const Range& range);
  R3::Vector NeedVector(Names names);
  R3::Point NeedPoint(Names names);
  R2::Color NeedColor(Names names);

  /// Accepts keys that have no effect.
  void Ignore(Names names);
  /// Warns once about a key that is known but not supported.
  void NotSupported(Names names);
  void Finish();
  /// Finishes a mapping that is useless if a key is missing, and returns true if there was no mistake.
  bool FinishedWell() {
    Finish();
    return IsGood();
  }

  /// Returns true if no mistake was found since construction, and nothing is missing so far.
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
  std::vector<std::vector<std::string_view>> missing_;  // the names of each missing key
};

}  // namespace ray
