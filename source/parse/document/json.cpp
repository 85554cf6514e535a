#include "source/parse/document/Document.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "source/parse/document/DocumentBuilder.h"

namespace ray {
namespace {

/// The event handler of nlohmann's reader, which reports no positions. A cursor follows the events: at each event it
/// skips the text between tokens, and is then at the event's token.
class JsonEvents : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonEvents(const Text& text, DocumentBuilder& builder)
      : text_(text), builder_(builder), cursor_(ByteOrderMark(text)) {}

  bool null() override {
    Value value;
    value.extent = Next();
    builder_.Add(std::move(value));
    return true;
  }
  bool boolean(bool) override { return Scalar(); }
  bool number_integer(number_integer_t) override { return Scalar(); }
  bool number_unsigned(number_unsigned_t) override { return Scalar(); }
  bool number_float(number_float_t, const string_t&) override { return Scalar(); }
  bool string(string_t& text) override { return Quotation(text); }
  bool key(string_t& text) override { return Quotation(text); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return Begin(Value::Kind::mapping); }
  bool start_array(std::size_t) override { return Begin(Value::Kind::sequence); }
  bool end_object() override { return End(); }
  bool end_array() override { return End(); }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::detail::exception& error) override;

 private:
  bool Scalar() {
    const Extent extent = Next();
    Value value;
    value.kind = Value::Kind::scalar;
    value.extent = extent;
    value.scalar = text_.bytes.substr(extent.offset, extent.length);
    builder_.Add(std::move(value));
    return true;
  }

  bool Quotation(string_t& text) {
    Value value;
    value.kind = Value::Kind::scalar;
    value.is_quoted = true;
    value.may_be_number = false;
    value.extent = Next();
    value.scalar = std::move(text);
    builder_.Add(std::move(value));
    return true;
  }

  bool Begin(Value::Kind kind) {
    builder_.Begin(kind, Next());
    return true;
  }

  bool End() {
    Next();
    builder_.End();
    return true;
  }

  /// Returns the next token, and moves the cursor after it. The text up to here is known to be valid.
  Extent Next() {
    const std::size_t begin = std::min(text_.bytes.find_first_not_of(" \t\r\n,:", cursor_), text_.bytes.size());
    cursor_ = EndOfToken(begin);
    return {begin, cursor_ - begin};
  }

  std::size_t EndOfToken(std::size_t begin) const {
    const std::string& bytes = text_.bytes;
    if (begin == bytes.size()) return begin;
    if (std::string_view("[]{}").find(bytes[begin]) != std::string_view::npos) return begin + 1;
    if (bytes[begin] != '"') return std::min(bytes.find_first_of(" \t\r\n,:[]{}", begin), bytes.size());
    std::size_t end = begin + 1;
    while (bytes[end] != '"') end += bytes[end] == '\\' ? 2 : 1;
    return end + 1;
  }

  const Text& text_;
  DocumentBuilder& builder_;
  std::size_t cursor_;
};

/// Returns "unexpected ']'; expected ..." for "[json.exception...] parse error at line 1, column 2: syntax error while
/// parsing value - unexpected ']'; expected ...; last read: '...'".
std::string WithoutPlace(std::string message) {
  if (const std::size_t i = message.find(" - "); i != std::string::npos) message.erase(0, i + 3);
  if (const std::size_t i = message.find("; last read: "); i != std::string::npos) message.erase(i);
  return message;
}

char LastBefore(const std::string& bytes, std::size_t offset) {
  const std::size_t i = offset == 0 ? std::string::npos : bytes.find_last_not_of(" \t\r\n", offset - 1);
  return i == std::string::npos ? '\0' : bytes[i];
}

std::string HintAt(const std::string& bytes, std::size_t offset) {
  const char c = offset < bytes.size() ? bytes[offset] : '\0';
  if (c == '/' || c == '#') return "JSON has no comments";
  if (c == '\'') return "JSON takes double quotes only";
  if ((c == ']' || c == '}') && LastBefore(bytes, offset) == ',') return "there is an extra comma before it";
  return {};
}

bool JsonEvents::parse_error(std::size_t position, const std::string& last_token,
                             const nlohmann::detail::exception& error) {
  constexpr int out_of_range = 406;  // the library's code for a number that no double represents
  const std::string message = WithoutPlace(error.what());
  const std::size_t size = text_.bytes.size();
  // An unexpected token is reported at its beginning: punctuation is one byte (the library's last token still contains
  // the previous one), a word as long as the last token. In a malformed token, the wrong byte is the last one read.
  const bool is_word =
      error.id == out_of_range || (message.starts_with("unexpected") && !message.starts_with("unexpected '"));
  const std::size_t length = is_word ? std::max<std::size_t>(1, last_token.size()) : 1;
  const bool is_end = message.starts_with("unexpected end of input");
  const std::size_t offset = is_end ? size : std::min(position - std::min(position, length), size);
  Extent extent{offset, length};
  if (error.id == out_of_range) builder_.Fail(extent, "a number must fit a double, whose largest is 1.8e308");
  if (offset == size) {  // shown at the end of the text, not in the empty line after it
    const std::size_t last = text_.bytes.find_last_not_of(" \t\r\n");
    extent = {last == std::string::npos ? 0 : last + 1, 1};
    builder_.Fail(extent, "the file ends too early" + message.substr(std::min(message.find(';'), message.size())));
  }
  builder_.Fail(extent, message, HintAt(text_.bytes, offset));
}

}  // namespace

Document ReadJson(const Text& text, const TextPlaces& places, Report& report) {
  CheckCharacters(text, places);
  DocumentBuilder builder(text, places, report, DocumentBuilder::Repeated::last_counts);
  JsonEvents events(text, builder);
  nlohmann::json::sax_parse(text.bytes, &events);
  return {text, places, builder.TakeRoot()};
}

}  // namespace ray
