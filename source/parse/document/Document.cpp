#include "source/parse/document/Document.h"


namespace ray {
namespace {

/// Returns the last entry that is written at `offset` or before it; the values of aliases are written elsewhere.
const Entry* EntryAround(const Value& value, std::size_t offset, std::size_t& index) {
  const Entry* found = nullptr;
  const auto& entries = value.Entries();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].value.is_alias || entries[i].value.extent.offset > offset) continue;
    found = &entries[i];
    index = i;
  }
  return found;
}

}  // namespace

std::string Document::PathOf(const Value& value) const {
  std::string path;
  const Value* at = &root_;
  while (at != &value) {
    std::size_t index = 0;
    const Entry* entry = EntryAround(*at, value.extent.offset, index);
    if (!entry) break;
    if (at->kind == Value::Kind::sequence)
      path += "[" + std::to_string(index) + "]";
    else
      path += (path.empty() ? "" : ".") + Escaped(entry->key.substr(0, most_quoted));
    at = &entry->value;
  }
  return path;
}

const std::vector<Entry>& Value::Entries() const {
  static const std::vector<Entry> none;
  return collection ? collection->entries : none;
}

const char* NameOf(Value::Kind kind) {
  switch (kind) {
    case Value::Kind::null:
      return "nothing";
    case Value::Kind::scalar:
      return "a single value";
    case Value::Kind::sequence:
      return "a list";
    case Value::Kind::mapping:
      return "a mapping";
  }
  return "";
}

}  // namespace ray
