#include "source/parse/document/Document.h"
#include "source/parse/document/DocumentBuilder.h"

#ifdef RAYPRO_YAML

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <istream>
#include <map>
#include <streambuf>

namespace ray {
namespace {

/// Bytes in memory as a stream, without a copy.
class BytesBuffer : public std::streambuf {
 public:
  explicit BytesBuffer(std::string_view bytes) {
    char* const begin = const_cast<char*>(bytes.data());  // only read
    setg(begin, begin, begin + bytes.size());
  }
};

/// Thrown at the start of a second document; yaml-cpp can be stopped only by an exception.
struct SecondDocument {
  Extent extent;
};

std::size_t BeginOfLine(std::string_view bytes, std::size_t offset) {
  std::size_t begin = std::min(offset, bytes.size());
  while (begin > 0 && !EndsLine(bytes[begin - 1])) --begin;
  return begin;
}

std::string_view WithoutComment(std::string_view line) {
  for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1))
    if (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t') return line.substr(0, i);
  return line;
}

// Every level of the text takes a few stack frames of yaml-cpp; the builder's limit ends that by an exception.
class YamlEvents : public YAML::EventHandler {
 public:
  YamlEvents(const Text& text, DocumentBuilder& builder)
      : text_(text), byte_order_mark_(ByteOrderMark(text)), builder_(builder) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) throw SecondDocument{{OffsetOf(mark), 1}};
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    Value null;
    // An absent value has the mark of the next token.
    if (builder_.IsInSequence())
      null.extent = ExtentOfItem(OffsetOf(mark));
    else
      null.extent = builder_.ExpectsKey() ? Extent{OffsetOf(mark), 1} : builder_.LastKey();
    Name(anchor, builder_.Add(std::move(null)));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const Extent extent{OffsetOf(mark), WordLength(OffsetOf(mark))};
    const auto named = named_.find(anchor);
    if (named == named_.end()) builder_.Fail(extent, "this alias is inside the value that it repeats");
    builder_.AddAlias(named->second, extent);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& scalar) override {
    CheckTag(mark, tag);
    Value value;
    value.kind = Value::Kind::scalar;
    value.scalar = scalar;
    value.is_quoted = tag == "!";
    value.extent = ExtentOf(BehindAnchor(OffsetOf(mark)), scalar);
    Name(anchor, builder_.Add(std::move(value)));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Begin(Value::Kind::sequence, mark, tag, anchor);
  }
  void OnSequenceEnd() override { End(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    Begin(Value::Kind::mapping, mark, tag, anchor);
  }
  void OnMapEnd() override { End(); }

  std::size_t OffsetOf(const YAML::Mark& mark) const {
    return byte_order_mark_ + static_cast<std::size_t>(std::max(0, mark.pos));
  }

 private:
  void Begin(Value::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    CheckTag(mark, tag);
    builder_.Begin(kind, {BehindAnchor(OffsetOf(mark)), 1});
    anchors_.push_back(anchor);
  }

  void End() {
    const YAML::anchor_t anchor = anchors_.back();
    anchors_.pop_back();
    Name(anchor, builder_.End());
  }

  /// Registers an anchor, which happens after its value is complete.
  void Name(YAML::anchor_t anchor, const Value& value) {
    if (anchor != YAML::NullAnchor) named_[anchor] = value;
  }

  void CheckTag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag == "?" || tag == "!" || tag.empty()) return;
    const std::size_t offset = OffsetOf(mark);
    builder_.Fail({offset, WordLength(offset)}, "tags have no meaning in scenes", "remove it");
  }

  std::size_t WordLength(std::size_t offset) const {
    const std::size_t end = text_.bytes.find_first_of(" \t\r\n,]}", offset);
    return std::min(end, text_.bytes.size()) - offset;
  }

  /// Returns the offset after the anchor of a value, if it has one; a value's mark is that of its anchor.
  std::size_t BehindAnchor(std::size_t offset) const {
    if (offset >= text_.bytes.size() || text_.bytes[offset] != '&') return offset;
    const std::size_t value = text_.bytes.find_first_not_of(" \t", offset + WordLength(offset));
    return value == std::string::npos ? offset : value;
  }

  Extent ExtentOf(std::size_t offset, const std::string& scalar) const {
    const std::string_view rest = std::string_view(text_.bytes).substr(offset);
    if (rest.starts_with('"') || rest.starts_with('\'')) return {offset, QuotedLength(offset)};
    return {offset, rest.starts_with(scalar) ? scalar.size() : 1};
  }

  /// Returns the extent of an empty item: the last word before `offset`, which is its dash, without comments; or the
  /// word at `offset` if that is "null".
  Extent ExtentOfItem(std::size_t offset) const {
    const std::string_view bytes = text_.bytes;
    const std::string_view word = bytes.substr(std::min(offset, bytes.size()), WordLength(offset));
    for (const std::string_view null : {"~", "null", "Null", "NULL"})
      if (word == null) return {offset, null.size()};
    for (std::size_t end = offset;;) {
      const std::size_t begin = BeginOfLine(bytes, end);
      const std::string_view line = WithoutComment(bytes.substr(begin, end - begin));
      const std::size_t last = line.find_last_not_of(" \t\r\n");
      if (last != std::string_view::npos) return {begin + last, 1};
      if (begin == 0) return {offset, 1};
      end = begin - 1;
    }
  }

  /// Returns the length of quoted text; yaml-cpp itself closes a quotation at the end of the file.
  std::size_t QuotedLength(std::size_t offset) const {
    const std::string& bytes = text_.bytes;
    const char quote = bytes[offset];
    for (std::size_t i = offset + 1; i < bytes.size(); ++i) {
      if ((quote == '"' && bytes[i] == '\\') ||
          (quote == '\'' && bytes[i] == '\'' && i + 1 < bytes.size() && bytes[i + 1] == '\''))
        ++i;
      else if (bytes[i] == quote)
        return i + 1 - offset;
    }
    builder_.Fail({offset, 1}, "this quoted text is not closed");
  }

  const Text& text_;
  std::size_t byte_order_mark_;
  DocumentBuilder& builder_;
  std::vector<YAML::anchor_t> anchors_;  // of the open collections
  std::map<YAML::anchor_t, Value> named_;
  int documents_ = 0;
};

// A bracket may turn out to begin a key. yaml-cpp keeps its tokens until it is closed, about 90 bytes per byte of text:
// 3 GB at most.
constexpr std::size_t max_bytes = std::size_t{1} << 25;

bool HasTabInIndentation(const Text& text, std::size_t offset) {
  const std::size_t begin = BeginOfLine(text.bytes, offset);
  const std::size_t end = std::min(text.bytes.find_first_not_of(" \t", begin), text.bytes.size());
  return text.bytes.substr(begin, end - begin).find('\t') != std::string::npos;
}

/// Returns yaml-cpp's message for a mistake, reworded in terms of the file if it refers to internal tables.
std::string Explained(const std::string& message) {
  namespace Says = YAML::ErrorMsg;
  if (message == Says::MAP_VALUE) return "unexpected ':'";
  if (message == Says::MAP_KEY) return "unexpected key";
  if (message == Says::BLOCK_ENTRY) return "unexpected '-'";
  if (message == Says::END_OF_MAP || message == Says::END_OF_SEQ) return "this line does not fit the indentation";
  if (message == Says::END_OF_MAP_FLOW) return "a '}' is missing before this";
  if (message == Says::END_OF_SEQ_FLOW) return "a ']' is missing before this";
  if (message == Says::FLOW_END) return "unexpected end of brackets";
  if (message == Says::UNKNOWN_TOKEN) return "unexpected character";
  if (message == Says::EOF_IN_SCALAR) return "the file ends inside quoted text";
  if (message == Says::UNKNOWN_ANCHOR) return "no anchor with that name precedes this alias";
  return message;
}

/// Returns the colon that lacks a space after it, if that explains a mistake at `offset`: in the word before, or at the
/// beginning of the line above, because yaml-cpp continues the word on the next line.
std::optional<std::size_t> ColonWithoutSpace(const std::string& bytes, std::size_t offset) {
  if (offset > 0 && offset < bytes.size() && bytes[offset - 1] == ':') return offset - 1;
  const std::size_t line = BeginOfLine(bytes, offset);
  if (line == 0) return {};
  const std::size_t above = BeginOfLine(bytes, line - 1);
  const std::size_t colon = bytes.find(':', above);
  if (colon >= line || std::string_view(" \t\r\n").find(bytes[colon + 1]) != std::string_view::npos) return {};
  const std::string_view before = std::string_view(bytes).substr(above, colon - above);
  const bool is_key = before.find_first_of("#\"'[]{},") == std::string_view::npos;
  return is_key ? std::optional(colon) : std::nullopt;
}

SceneError ErrorOf(const YAML::Exception& error, const Extent& extent, const std::optional<Extent>& innermost,
                   const Text& text, const TextPlaces& places) {
  const Token token = places.At(extent);
  if (HasTabInIndentation(text, extent.offset))
    return ErrorAt(text, token, "tab in the indentation", "YAML allows only spaces");
  namespace Says = YAML::ErrorMsg;
  const bool is_of_colon =
      error.msg == Says::MAP_VALUE || error.msg == Says::END_OF_MAP_FLOW || error.msg == Says::END_OF_SEQ_FLOW;
  if (const auto colon = is_of_colon ? ColonWithoutSpace(text.bytes, extent.offset) : std::nullopt)
    return ErrorAt(text, places.At({*colon, 1}), "a space is missing after this colon");
  std::string hint;
  if (error.msg == Says::MAP_VALUE) hint = "is the indentation the same as in the line above?";
  if (innermost && (error.msg == Says::END_OF_MAP_FLOW || error.msg == Says::END_OF_SEQ_FLOW))
    hint = "opened in line " + std::to_string(places.At(*innermost).line);
  return ErrorAt(text, token, Explained(error.msg), hint);
}

}  // namespace

Document ReadYaml(const Text& text, const TextPlaces& places, Report& report) {
  if (text.bytes.size() > max_bytes) throw ErrorIn(text.name, "the file exceeds the limit of 32 MiB for YAML");
  CheckCharacters(text, places);
  BytesBuffer buffer(std::string_view(text.bytes).substr(ByteOrderMark(text)));
  std::istream stream(&buffer);
  DocumentBuilder builder(text, places, report, DocumentBuilder::Repeated::first_counts);
  YamlEvents events(text, builder);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(events)) continue;
  } catch (const YAML::Exception& error) {
    throw ErrorOf(error, {events.OffsetOf(error.mark), 1}, builder.Innermost(), text, places);
  } catch (const SecondDocument& second) {
    const Token token = places.At(second.extent);
    report.Warn(Place(text.name, token.line, token.column), "a second document is ignored");
  }
  return {text, places, builder.TakeRoot()};
}

}  // namespace ray

#else

namespace ray {

Document ReadYaml(const Text& text, const TextPlaces&, Report&) {
  throw ErrorIn(text.name, "this program was built without YAML", "install libyaml-cpp-dev and build it again");
}

}  // namespace ray

#endif
