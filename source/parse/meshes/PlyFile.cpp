#include "source/parse/meshes/PlyFile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "source/parse/Coordinate.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr std::size_t max_properties = 1000;  // each is read once per element, so many of them take time

template <class T>
double NextAs(Bytes& bytes) {
  return bytes.Next<T>();
}

constexpr std::array types{
    PlyType{"char", "int8", 1, 1, true, NextAs<std::int8_t>},
    PlyType{"uchar", "uint8", 1, 255, true, NextAs<std::uint8_t>},
    PlyType{"short", "int16", 2, 1, true, NextAs<std::int16_t>},
    PlyType{"ushort", "uint16", 2, 65535, true, NextAs<std::uint16_t>},
    PlyType{"int", "int32", 4, 1, true, NextAs<std::int32_t>},
    PlyType{"uint", "uint32", 4, 1, true, NextAs<std::uint32_t>},
    PlyType{"float", "float32", 4, 1, false, NextAs<float>},
    PlyType{"double", "float64", 8, 1, false, NextAs<double>},
};

}  // namespace

std::optional<std::size_t> PlyElement::Find(std::string_view property, bool is_list) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property && (properties[i].count_type != nullptr) == is_list) return i;
  return {};
}

PlyFile::PlyFile(const Text& file)
    : words_(file, Tokenizer::Comments::none), bytes_(file.bytes, 0, std::endian::little) {
  if (words_.Need({"ply"}).text != "ply") words_.Fail(words_.Last(), "a .ply file must begin with 'ply'");
  while (words_.Need({"end_header"}).text != "end_header") ReadHeaderLine(words_.Last());
  bytes_.Skip(OffsetBehindHeader());
}

void PlyFile::ReadHeaderLine(const Token& keyword) {
  if (keyword.text == "format")
    ReadFormat();
  else if (keyword.text == "element")
    ReadElement();
  else if (keyword.text == "property")
    ReadProperty();
  else if (keyword.text == "comment")
    ReadComment();
  else if (keyword.text == "obj_info")
    words_.SkipLine();
  else
    words_.Fail(keyword, "unknown header keyword " + Quoted(keyword.text));
}

void PlyFile::ReadComment() {
  if (words_.HasMoreOnLine() && words_.NextIs("TextureFile")) {
    words_.Next();
    if (const Token name = words_.RestOfLine(); !name.text.empty()) textures_.push_back(name);
  }
  words_.SkipLine();
}

void PlyFile::ReadFormat() {
  const Token word = words_.Need({"the format"});
  is_text_ = word.text == "ascii";
  if (word.text == "binary_big_endian")
    bytes_ = Bytes(Source().bytes, 0, std::endian::big);
  else if (!is_text_ && word.text != "binary_little_endian")
    words_.Fail(word, "unknown format " + Quoted(word.text),
                "supported: ascii, binary_little_endian, binary_big_endian");
  const Token version = words_.Need({"the version"});
  if (version.text != "1.0") words_.Fail(version, "the version must be 1.0, got " + Quoted(version.text));
}

void PlyFile::ReadElement() {
  PlyElement& element = elements_.emplace_back();
  element.name = words_.Need({"the name of an element"}).text;
  const std::int64_t count = words_.Whole({"the number of elements"});
  element.where = words_.Last();
  if (count < 0) words_.Fail(words_.Last(), "the number of elements must not be negative");
  element.count = static_cast<std::size_t>(count);
}

void PlyFile::ReadProperty() {
  if (elements_.empty()) words_.Fail(words_.Last(), "property before any element");
  const auto next = [&] { return words_.Need({"the rest of a property"}); };
  Token type = next();
  const PlyType* count_type = nullptr;
  if (type.text == "list") {
    count_type = &TypeAt(next());
    if (!count_type->is_whole) words_.Fail(words_.Last(), "the count of a list must have an integer type");
    type = next();
  }
  const PlyType& known = TypeAt(type);
  elements_.back().properties.push_back({std::string(next().text), &known, count_type});
  if (++properties_ > max_properties) words_.Fail(words_.Last(), "more than 1000 properties");
}

const PlyType& PlyFile::TypeAt(const Token& word) const {
  for (const PlyType& type : types)
    if (word.text == type.name || word.text == type.later_name) return type;
  words_.Fail(word, "unknown type " + Quoted(word.text),
              "supported: char, uchar, short, ushort, int, uint, float, double");
}

// In binary files the data may begin with a byte that looks like a line end, so exactly one line end is skipped, of the
// kind that ends the first line.
std::size_t PlyFile::OffsetBehindHeader() const {
  const std::string_view bytes = Source().bytes;
  const std::size_t end = bytes.find_first_of("\r\n");
  if (end == std::string_view::npos) return bytes.size();
  const std::string_view kind = bytes.substr(end).starts_with("\r\n") ? "\r\n" : bytes.substr(end, 1);
  const auto behind = static_cast<std::size_t>(words_.Last().text.data() + words_.Last().text.size() - bytes.data());
  const std::size_t line_end = bytes.find(kind, behind);
  return line_end == std::string_view::npos ? bytes.size() : line_end + kind.size();
}

void PlyFile::CheckLength(const PlyElement& element) const {
  std::size_t least = 0;
  for (const PlyProperty& property : element.properties)
    least += LeastBytes(property.count_type ? *property.count_type : *property.type);
  if (least == 0 || element.count <= (BytesLeft() + 1) / least) return;
  words_.Fail(element.where, "the header declares " + std::to_string(element.count) + " elements, but only " +
                                 BytesThatFollow(BytesLeft()));
}

void PlyFile::Read(const PlyElement& element, std::size_t number, const PlyColumns& columns, PlyRow& row) {
  element_ = &element;
  number_ = number;
  row.numbers.assign(element.properties.size(), 0);
  row.corners.clear();
  row.uvs.clear();
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.count_type) {
      ReadList(property, p == columns.corners ? &row.corners : p == columns.uvs ? &row.uvs : nullptr);
      continue;
    }
    row.numbers[p] = Next(*property.type, property);
    if (IsCoordinate(row.numbers[p])) continue;
    row.unusable = Last();
    if (std::ranges::find(columns.coordinates, p) != columns.coordinates.end())
      Fail(Escaped(property.name) + " must be finite and must not exceed 1e150 in magnitude");
  }
  if (is_text_ && words_.HasMoreOnLine()) EndRow(columns, row);
}

/// Reads a number; NaN for one that is not finite in a text file.
double PlyFile::Next(const PlyType& type, const PlyProperty& property) {
  if (is_text_) return words_.AnyNumber({property.name.c_str(), element_->name.c_str(), number_});
  last_offset_ = bytes_.Offset();
  if (bytes_.Left() < type.bytes) Fail("the file ends here");
  return type.next(bytes_);
}

void PlyFile::ReadList(const PlyProperty& property, std::vector<double>* list) {
  const double count = Next(*property.count_type, property);
  if (!(count >= 0 && count == std::floor(count)))
    Fail("the length of the list " + Escaped(property.name) + " must be a whole number, and not negative, got " +
         ToText(count));
  if (count > static_cast<double>((BytesLeft() + 1) / LeastBytes(*property.type)))
    Fail("a list of " + ToText(count) + " numbers does not fit in the remaining " + std::to_string(BytesLeft()) +
         " bytes");
  for (auto left = static_cast<std::size_t>(count); left > 0; --left) {
    const double value = Next(*property.type, property);
    if (list) list->push_back(value);
  }
}

// Extra numbers in a vertex row are ambiguous and therefore an error. In a face row, numbers after the corners are
// ignored.
void PlyFile::EndRow(const PlyColumns& columns, const PlyRow& row) {
  if (!has_line_each_) has_line_each_ = words_.LinesLeft() >= RowsBehind();
  if (!*has_line_each_) return;
  const Token surplus = words_.Need({"a number"});
  if (columns.corners != std::size_t{0} || row.corners.size() < 3) {
    std::string names;
    for (const PlyProperty& property : element_->properties)
      names += (names.empty() ? "" : ", ") + Escaped(property.name);
    words_.Fail(surplus,
                Escaped(element_->name) + " " + std::to_string(number_) + " has more numbers than the header declares",
                "declared: " + names);
  }
  long_faces_.Add(surplus);
  words_.SkipLine();
}

std::size_t PlyFile::RowsBehind() const {
  std::size_t rows = element_->count - 1 - number_;
  for (auto other = elements_.rbegin(); &*other != element_; ++other)
    if (!other->properties.empty()) rows += other->count;
  return rows;
}

void PlyFile::CheckEnd(Report& report) {
  if (is_text_ ? words_.AtEnd() : bytes_.Left() == 0) return;
  const std::string message = "the file has more data than the header declares";
  if (IsIrregular()) words_.Fail(*words_.Peek(), message);
  report.Warn(Escaped(Source().name), message);
}

void PlyFile::Warn(Report& report) const {
  long_faces_.Warn(Source(), report, "face has ignored numbers after those that the header declares",
                   "faces have ignored numbers after those that the header declares");
}

void PlyFile::Fail(const std::string& message) const {
  const std::string row = Escaped(element_->name) + " " + std::to_string(number_);
  if (is_text_) words_.Fail(words_.Last(), row + ": " + message);
  throw ErrorIn(Source().name, row + " (byte " + std::to_string(last_offset_) + "): " + message);
}

}  // namespace ray
