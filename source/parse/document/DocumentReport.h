#pragma once

#include <set>
#include <string>
#include <utility>

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

}  // namespace ray
