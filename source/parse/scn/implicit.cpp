#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "R3/Implicit.h"
#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

const std::array<R3::Argument, 6> box_corners{{{"x"}, {"y"}, {"z"}, {"X"}, {"Y"}, {"Z"}}};

/// What is between the quotes, if there are any.
Token InnerOf(Token word) {
  if (word.text.size() < 2 || word.text.front() != '"' || word.text.back() != '"') return word;
  word.text = word.text.substr(1, word.text.size() - 2);
  ++word.column;
  return word;
}

/// Nothing after a mistake, which is pointed at.
std::optional<R3::Expression> ReadFormula(Statement& statement) {
  const Token text = InnerOf(statement.Word("formula"));
  try {
    return R3::Expression(text.text);
  } catch (const R3::ExpressionError& error) {
    Token part = text;
    part.text = text.text.substr(std::min(error.at, text.text.size()), error.length);
    part.column += error.at;  // what is before it is ASCII
    statement.Error(part, error.what(), error.hint);
    return {};
  }
}

/// An extension: where a formula of x, y and z is not above 0, within a box.
void ReadImplicit(ScnReader& reader, Statement& statement) {
  const int material = reader.ReadMaterial(statement);
  auto formula = ReadFormula(statement);
  const Arguments read = statement.Coordinates(box_corners);
  if (!formula || !statement.IsGood()) return;
  R3::Box box;
  box.Extend(R3::Point{read.values[0], read.values[1], read.values[2]});
  box.Extend(R3::Point{read.values[3], read.values[4], read.values[5]});
  reader.AddShape(statement, material, std::make_shared<const R3::Implicit>(std::move(*formula), box));
}

}  // namespace

extern const Command implicit_command{
    "implicit", "implicit mat_id \"formula\"" + ArgumentNames(box_corners),
    "the solid where a formula of x, y and z is not above 0, within a box of two opposite corners", ReadImplicit};

}  // namespace ray
