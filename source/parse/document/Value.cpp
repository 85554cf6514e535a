#include "source/parse/document/Value.h"

namespace ray {

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
