#include "source/parse/meshes/PlyValues.h"

namespace ray {

PlyValues::PlyValues(MeshWords& words, const PlyHeader& header)
    : words_(words),
      bytes_(words.Source().bytes, header.data_offset,
             header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little),
      is_text_(header.encoding == PlyEncoding::ascii) {}

double PlyValues::Next(PlyType type, const PlyPlace& place, const std::string& property) {
  if (is_text_) return words_.AnyNumber({property.c_str(), place.element.c_str(), place.number});
  last_offset_ = bytes_.Offset();
  if (bytes_.Left() < SizeOf(type)) Fail(place, "the file ends here");
  return NextBinary(type);
}

bool PlyValues::AtEnd() { return is_text_ ? words_.AtEnd() : bytes_.Left() == 0; }

void PlyValues::Fail(const PlyPlace& place, const std::string& message) const {
  if (is_text_) words_.Fail(words_.Last(), Escaped(place.Words()) + ": " + message);
  throw ErrorIn(words_.Source().name,
                Escaped(place.Words()) + " (byte " + std::to_string(last_offset_) + "): " + message);
}

double PlyValues::NextBinary(PlyType type) {
  switch (type) {
    case PlyType::int8:
      return bytes_.Next<std::int8_t>();
    case PlyType::uint8:
      return bytes_.Next<std::uint8_t>();
    case PlyType::int16:
      return bytes_.Next<std::int16_t>();
    case PlyType::uint16:
      return bytes_.Next<std::uint16_t>();
    case PlyType::int32:
      return bytes_.Next<std::int32_t>();
    case PlyType::uint32:
      return bytes_.Next<std::uint32_t>();
    case PlyType::float32:
      return bytes_.Next<float>();
    case PlyType::float64:
      return bytes_.Next<double>();
  }
  return 0;
}

}  // namespace ray
