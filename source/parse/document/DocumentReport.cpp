#include "source/parse/document/DocumentReport.h"

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

}  // namespace ray
