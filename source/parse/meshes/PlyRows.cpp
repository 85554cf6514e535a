#include "source/parse/meshes/PlyRows.h"

#include <algorithm>
#include <cmath>

#include "source/parse/Coordinate.h"
#include "source/text/NumberText.h"

namespace ray {

void PlyRows::Read(const PlyElement& element, std::size_t number, const PlyColumns& columns, PlyRow& row) {
  const PlyPlace place{element.name, number};
  row.numbers.assign(element.properties.size(), 0);
  row.corners.clear();
  row.uvs.clear();
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.count_type) {
      ReadList(property, place, p == columns.corners ? &row.corners : p == columns.uvs ? &row.uvs : nullptr);
      continue;
    }
    row.numbers[p] = values_.Next(property.type, place, property.name);
    if (IsCoordinate(row.numbers[p])) continue;
    row.unusable = values_.Last();
    if (std::ranges::find(columns.coordinates, p) != columns.coordinates.end())
      values_.Fail(place, Escaped(property.name) + " must be finite and must not exceed 1e150 in magnitude");
  }
  if (values_.HasMoreOnLine()) EndRow(element, number, columns, row);
}

void PlyRows::ReadList(const PlyProperty& property, const PlyPlace& place, std::vector<double>* list) {
  const double count = values_.Next(*property.count_type, place, property.name);
  if (!(count >= 0 && count == std::floor(count)))
    values_.Fail(place, "the length of the list " + Escaped(property.name) +
                            " must be a whole number, and not negative, got " + ToText(count));
  const std::size_t least = values_.LeastBytes(property.type);
  if (count > static_cast<double>((values_.BytesLeft() + 1) / least))
    values_.Fail(place, "a list of " + ToText(count) + " numbers does not fit in the remaining " +
                            std::to_string(values_.BytesLeft()) + " bytes");
  for (auto left = static_cast<std::size_t>(count); left > 0; --left) {
    const double value = values_.Next(property.type, place, property.name);
    if (list) list->push_back(value);
  }
}

// Which of a vertex's numbers is one too many cannot be told; which are a face's corners can, if they come first.
void PlyRows::EndRow(const PlyElement& element, std::size_t number, const PlyColumns& columns, const PlyRow& row) {
  if (!has_line_each_) has_line_each_ = words_.LinesLeft() >= RowsBehind(element, number);
  if (!*has_line_each_) return;
  const Token surplus = words_.Need({"a number"});
  if (columns.corners != std::size_t{0} || row.corners.size() < 3)
    words_.Fail(surplus,
                Escaped(element.name) + " " + std::to_string(number) + " has more numbers than the header declares",
                "declared: " + element.PropertyNames());
  long_faces_.Add(surplus);
  words_.SkipLine();
}

std::size_t PlyRows::RowsBehind(const PlyElement& element, std::size_t number) const {
  std::size_t rows = element.count - 1 - number;
  for (auto other = header_.elements.rbegin(); &*other != &element; ++other)
    if (!other->properties.empty()) rows += other->count;
  return rows;
}

}  // namespace ray
