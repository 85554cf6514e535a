#pragma once

#include <set>
#include <string>
#include <utility>

#include "source/parse/SceneError.h"
#include "source/parse/document/Document.h"

namespace ray {

/// Tells of mistakes in a document where they stand.
class DocumentReport {
 public:
  DocumentReport(const Document& document, Report& report) : document_(document), report_(report) {}

  /// "Objects[2].radius must be a number": the path of the value, then `what`, behind a blank or, where it begins with
  /// one, a colon.
  void Error(const Value& value, const std::string& what, const std::string& hint = {});
  /// A mistake where the path says nothing, as at a key.
  void ErrorAtKey(const Entry& entry, const std::string& message, const std::string& hint = {});
  /// What a file named by the value is to blame for, with the place that names it.
  void ErrorIn(const Value& value, SceneError error);

  void Warn(const Extent& extent, const std::string& message);
  /// Only once of each `subject`.
  void WarnOnce(const std::string& subject, const Extent& extent, const std::string& message);

  /// How many mistakes so far: who reads something knows by it whether all went well.
  std::size_t Errors() const { return errors_; }
  /// Returns HexColorHint for a key without a value.
  std::string HexColorBehind(const Entry& entry) const;
  std::string PathOf(const Value& value) const;
  /// "scene.yaml:12"
  std::string PlaceOf(const Extent& extent) const;
  Token At(const Extent& extent) const { return document_.At(extent); }
  const Document& Source() const { return document_; }

 private:
  const Document& document_;
  Report& report_;
  std::size_t errors_ = 0;
  std::set<std::string> warned_;
};

}  // namespace ray
