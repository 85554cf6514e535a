#include "source/parse/document/DocumentBuilder.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace ray {

void DocumentBuilder::Begin(Value::Kind kind, const Extent& extent) {
  if (ExpectsKey()) {
    const char first = extent.offset < text_.bytes.size() ? text_.bytes[extent.offset] : '\0';
    const bool is_bracket = first == '[' || first == '{';  // yaml-cpp treats an unclosed bracket as a key
    Fail(extent, "a key must be a word, not " + std::string(NameOf(kind)), is_bracket ? "is this bracket closed?" : "");
  }
  CheckDepth(open_.size() + 1, extent);
  Count(1, extent);
  Open& open = open_.emplace_back();
  open.value.kind = kind;
  open.value.extent = extent;
  open.expects_key = kind == Value::Kind::mapping;
}

const Value& DocumentBuilder::End() {
  Open open = std::move(open_.back());
  open_.pop_back();
  if (open.value.kind == Value::Kind::mapping) {
    DropRepeated(open.collection);
    Merge(open.collection);
  }
  for (const Entry& entry : open.collection.entries) {
    const Collection* below = entry.value.collection.get();
    open.collection.values += below ? below->values : 1;
    open.collection.height = std::max(open.collection.height, below ? below->height + 1 : 1);
  }
  open.value.collection = std::make_shared<const Collection>(std::move(open.collection));
  return Place(std::move(open.value));
}

const Value& DocumentBuilder::Add(Value value) {
  Count(1, value.extent);
  return Place(std::move(value));
}

void DocumentBuilder::AddAlias(Value value, const Extent& extent) {
  if (ExpectsKey()) Fail(extent, "a key must be a word, not an alias");
  if (value.collection) CheckDepth(open_.size() + static_cast<std::size_t>(value.collection->height), extent);
  Count(value.collection ? value.collection->values : 1, extent);
  value.is_alias = true;
  Place(std::move(value));
}

Extent DocumentBuilder::LastKey() const {
  if (open_.empty()) return {};
  const Open& open = open_.back();
  if (open.value.kind == Value::Kind::mapping && !open.collection.entries.empty())
    return open.collection.entries.back().key_extent;
  return open.value.extent;
}

std::optional<Extent> DocumentBuilder::Innermost() const {
  if (open_.empty()) return {};
  return open_.back().value.extent;
}

const Value& DocumentBuilder::Place(Value value) {
  if (open_.empty()) return root_ = std::move(value);
  Open& open = open_.back();
  if (open.expects_key) {
    if (value.kind != Value::Kind::scalar) Fail(value.extent, "a key must be a word, not nothing");
    open.collection.entries.push_back({std::move(value.scalar), value.extent, {}});
    open.expects_key = false;
    return open.collection.entries.back().value;
  }
  if (open.value.kind == Value::Kind::mapping) {
    open.expects_key = true;
    return open.collection.entries.back().value = std::move(value);
  }
  open.collection.entries.push_back({{}, {}, std::move(value)});
  return open.collection.entries.back().value;
}

void DocumentBuilder::Count(std::size_t values, const Extent& extent) {
  values_ += values;  // no overflow: the contents of an alias were counted within the limit before
  if (values_ > Document::max_values)
    Fail(extent, "more than " + std::to_string(Document::max_values) + " values", "aliases count as what they repeat");
}

void DocumentBuilder::CheckDepth(std::size_t depth, const Extent& extent) const {
  if (depth > std::size_t{Document::max_depth})
    Fail(extent, "nested deeper than " + std::to_string(Document::max_depth) + " levels");
}

void DocumentBuilder::DropRepeated(Collection& mapping) {
  std::vector<std::size_t> sorted(mapping.entries.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  const auto key = [&](std::size_t i) -> const std::string& { return mapping.entries[i].key; };
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<bool> is_dropped(sorted.size());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (key(sorted[i - 1]) != key(sorted[i])) continue;
    const Token earlier = places_.At(mapping.entries[sorted[i - 1]].key_extent),
                later = places_.At(mapping.entries[sorted[i]].key_extent);
    const bool first_counts = repeated_ == Repeated::first_counts;
    report_.Warn(ray::Place(text_.name, later.line, later.column),
                 "duplicate key " + Quoted(key(sorted[i])) + ", already given in line " + std::to_string(earlier.line) +
                     "; the " + (first_counts ? "first" : "last") + " one counts");
    is_dropped[first_counts ? sorted[i] : sorted[i - 1]] = true;
  }
  std::size_t i = 0;
  std::erase_if(mapping.entries, [&](const Entry&) { return is_dropped[i++]; });
}

// YAML's merge key: https://yaml.org/type/merge.html. The mapping's own keys take precedence, then the first of a list.
void DocumentBuilder::Merge(Collection& mapping) {
  const auto merge = std::ranges::find(mapping.entries, "<<", &Entry::key);
  if (merge == mapping.entries.end() || repeated_ == Repeated::last_counts) return;  // an ordinary key in JSON
  const Value from = std::move(merge->value);
  mapping.entries.erase(merge);
  const std::vector<Entry> one{{{}, {}, from}};
  std::set<std::string> known;
  for (const Entry& entry : mapping.entries) known.insert(entry.key);
  for (const Entry& source : from.kind == Value::Kind::sequence ? from.Entries() : one) {
    if (source.value.kind != Value::Kind::mapping)
      Fail(from.extent, "<< must be followed by a mapping or a list of mappings, such as an alias of one");
    for (const Entry& entry : source.value.Entries()) {
      if (!known.insert(entry.key).second) continue;
      Count(entry.value.collection ? entry.value.collection->values : 1, from.extent);
      mapping.entries.push_back(entry);
      mapping.entries.back().value.is_alias = true;
    }
  }
}

void DocumentBuilder::Fail(const Extent& extent, const std::string& message, const std::string& hint) const {
  throw ErrorAt(text_, places_.At(extent), message, hint);
}

std::size_t ByteOrderMark(const Text& text) {
  return text.bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

void CheckCharacters(const Text& text, const TextPlaces& places) {
  if (text.bytes.starts_with("\xFE\xFF") || text.bytes.starts_with("\xFF\xFE"))
    throw ErrorIn(text.name, "the file is UTF-16", "save it as UTF-8");
  const auto is_bad = [](char c) { return c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r'; };
  const auto bad = std::find_if(text.bytes.begin(), text.bytes.end(), is_bad);
  if (bad == text.bytes.end()) return;
  const Extent extent{static_cast<std::size_t>(bad - text.bytes.begin()), 1};
  throw ErrorAt(text, places.At(extent), "control character " + Escaped({&*bad, 1}), "not a text file?");
}

}  // namespace ray
