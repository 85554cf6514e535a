#pragma once

#include <optional>
#include <string>

#include "source/parse/document/Document.h"
#include "tests/source/parse/Folder.h"

namespace ray {

/// A document from text.
struct Read {
  enum class Language { yaml, json };

  Read(Language language, std::string bytes)
      : text{language == Language::yaml ? "a.yaml" : "a.json", std::move(bytes)} {
    places.emplace(text);
    try {
      document.emplace(language == Language::yaml ? ReadYaml(text, *places, report) : ReadJson(text, *places, report));
      report.ThrowErrors();
    } catch (const SceneError& error) {
      message = error.Format();
    } catch (const SceneErrors& errors) {
      message = errors.what();
    }
  }

  const Value& Root() const { return document->Root(); }

  Text text;
  std::optional<TextPlaces> places;
  Report report;
  std::optional<Document> document;
  std::string message;  // the error; empty if there is none
};

inline Read Json(const std::string& bytes) { return {Read::Language::json, bytes}; }
inline Read Yaml(const std::string& bytes) { return {Read::Language::yaml, bytes}; }

/// Returns a value on one line: mappings in braces, lists in brackets, "-" for nothing. Depth is within the document's
/// limit.
inline std::string Written(const Value& value) {
  if (value.kind == Value::Kind::null) return "-";
  if (value.kind == Value::Kind::scalar) return value.is_quoted ? "'" + value.scalar + "'" : value.scalar;
  const bool is_list = value.kind == Value::Kind::sequence;
  std::string all;
  for (const Entry& entry : value.Entries())
    all += (all.empty() ? "" : " ") + (is_list ? "" : entry.key + ":") + Written(entry.value);
  return is_list ? "[" + all + "]" : "{" + all + "}";
}

}  // namespace ray
