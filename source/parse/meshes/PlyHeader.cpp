#include "source/parse/meshes/PlyHeader.h"

#include <array>

namespace ray {
namespace {

constexpr std::size_t max_properties = 1000;  // each is read once for every element, so many of them cost time

struct TypeName {
  std::string_view name;
  PlyType type;
};

// The first eight are Turk's, the others came with later libraries.
constexpr std::array type_names{
    TypeName{"char", PlyType::int8},       TypeName{"uchar", PlyType::uint8},    TypeName{"short", PlyType::int16},
    TypeName{"ushort", PlyType::uint16},   TypeName{"int", PlyType::int32},      TypeName{"uint", PlyType::uint32},
    TypeName{"float", PlyType::float32},   TypeName{"double", PlyType::float64}, TypeName{"int8", PlyType::int8},
    TypeName{"uint8", PlyType::uint8},     TypeName{"int16", PlyType::int16},    TypeName{"uint16", PlyType::uint16},
    TypeName{"int32", PlyType::int32},     TypeName{"uint32", PlyType::uint32},  TypeName{"float32", PlyType::float32},
    TypeName{"float64", PlyType::float64},
};

class HeaderReader {
 public:
  explicit HeaderReader(MeshWords& words) : words_(words) {}

  PlyHeader Read() {
    if (Need("ply").text != "ply") words_.Fail(words_.Last(), "a .ply file must begin with 'ply'");
    while (Need("end_header").text != "end_header") ReadLine();
    header_.data_offset = BehindLine();
    return std::move(header_);
  }

 private:
  Token Need(const char* what) { return words_.Need({what}); }

  void ReadLine() {
    const Token keyword = words_.Last();
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

  void ReadComment() {
    if (words_.HasMoreOnLine() && words_.NextIs("TextureFile")) {
      words_.Next();
      if (const Token name = words_.RestOfLine(); !name.text.empty()) header_.textures.push_back(name);
    }
    words_.SkipLine();
  }

  void ReadFormat() {
    const Token word = Need("the format");
    if (word.text == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (word.text == "binary_little_endian")
      header_.encoding = PlyEncoding::little_endian;
    else if (word.text == "binary_big_endian")
      header_.encoding = PlyEncoding::big_endian;
    else
      words_.Fail(word, "unknown format " + Quoted(word.text),
                  "supported: ascii, binary_little_endian, binary_big_endian");
    const Token version = Need("the version");
    if (version.text != "1.0") words_.Fail(version, "the version must be 1.0, got " + Quoted(version.text));
  }

  void ReadElement() {
    PlyElement element;
    element.name = Need("the name of an element").text;
    const std::int64_t count = words_.Whole({"the number of elements"});
    element.where = words_.Last();
    if (count < 0) words_.Fail(words_.Last(), "the number of elements must not be negative");
    element.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void ReadProperty() {
    if (header_.elements.empty()) words_.Fail(words_.Last(), "property before any element");
    PlyProperty property;
    Token type = Need("the rest of a property");
    if (type.text == "list") {
      property.count_type = TypeOf(Need("the rest of a property"));
      if (*property.count_type == PlyType::float32 || *property.count_type == PlyType::float64)
        words_.Fail(words_.Last(), "the count of a list must have an integer type");
      type = Need("the rest of a property");
    }
    property.type = TypeOf(type);
    property.name = Need("the rest of a property").text;
    if (++properties_ > max_properties) words_.Fail(words_.Last(), "more than 1000 properties");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType TypeOf(const Token& word) const {
    for (const TypeName& type : type_names)
      if (word.text == type.name) return type.type;
    words_.Fail(word, "unknown type " + Quoted(word.text),
                "supported: char, uchar, short, ushort, int, uint, float, double");
  }

  // In binary files the data may begin with a byte that looks like a line end, so exactly one is passed over, of the
  // kind that ends the first line.
  std::size_t BehindLine() const {
    const std::string_view bytes = words_.Source().bytes;
    const std::size_t end = bytes.find_first_of("\r\n");
    if (end == std::string_view::npos) return bytes.size();
    const std::string_view kind = bytes.substr(end).starts_with("\r\n") ? "\r\n" : bytes.substr(end, 1);
    const auto behind = static_cast<std::size_t>(words_.Last().text.data() + words_.Last().text.size() - bytes.data());
    const std::size_t line_end = bytes.find(kind, behind);
    return line_end == std::string_view::npos ? bytes.size() : line_end + kind.size();
  }

  MeshWords& words_;
  PlyHeader header_;
  std::size_t properties_ = 0;
};

}  // namespace

std::size_t SizeOf(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 0;
}

std::optional<std::size_t> PlyElement::Find(std::string_view property, bool is_list) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property && properties[i].count_type.has_value() == is_list) return i;
  return {};
}

std::string PlyElement::PropertyNames() const {
  std::string names;
  for (const PlyProperty& property : properties) names += (names.empty() ? "" : ", ") + Escaped(property.name);
  return names;
}

PlyHeader ReadPlyHeader(MeshWords& words) { return HeaderReader(words).Read(); }

}  // namespace ray
