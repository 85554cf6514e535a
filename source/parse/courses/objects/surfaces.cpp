#include "R3/Implicit.h"
#include "source/parse/courses/objects/Kinds.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

/// Adds the numbers of a ball: its center, its radius, and its strength, by default 1.
void AddBall(const Field& field, std::vector<double>& numbers) {
  auto ball = field.AsMapping("a ball");
  if (!ball) return;
  const R3::Point center = ball->NeedPoint({"position", "center"});
  const double radius = ball->NeedNumber({"radius", "r"}, positive);
  const double strength = ball->Number({"strength"}, any_number, 1);
  ball->Ignore({"comment", "name"});
  ball->Finish();
  numbers.insert(numbers.end(), {center.x, center.y, center.z, radius, strength});
}

/// Reads 16 control points, row by row.
std::optional<PlacedShape> ReadPatch(const char* kind, Mapping& object) {
  const auto field = object.Need({"points"});
  const auto points = field ? field->ListOf(16, "a list of 16 points") : std::nullopt;
  if (!points) return {};
  std::vector<double> numbers;
  for (const Field& point : *points) {
    const R3::Vector p = point.Vector().value_or(R3::Vector{});
    numbers.insert(numbers.end(), {p.x, p.y, p.z});
  }
  if (!object.IsGood()) return {};
  return PlacedShape{ShapeOf(kind, numbers)};
}

std::optional<R3::Expression> ReadFormula(Mapping& object) {
  const auto field = object.Need({"formula"});
  const auto text = field ? field->Word() : std::nullopt;
  if (!text) return {};
  try {
    return R3::Expression(*text);
  } catch (const R3::ExpressionError& error) {
    const std::string place = error.at < text->size() ? ", at character " + ToText(error.at + 1) : ", at its end";
    field->Error("is not a formula" + place + ": " + error.what(), error.hint);
    return {};
  }
}

std::optional<PlacedShape> ReadBlob(Mapping& object) {
  std::vector<double> numbers{object.NeedNumber({"threshold"}, positive)};
  const auto field = object.Need({"balls", "components"});
  const auto balls = field ? field->List() : std::nullopt;
  if (!balls) return {};
  if (balls->empty()) field->Error("must be a list of at least one ball");
  for (const Field& ball : *balls) AddBall(ball, numbers);
  if (!object.IsGood()) return {};
  return PlacedShape{ShapeOf("blob", numbers)};
}

std::optional<PlacedShape> ReadImplicit(Mapping& object) {
  auto formula = ReadFormula(object);
  const R3::Point low = object.NeedPoint({"min"}), high = object.NeedPoint({"max"});
  if (!formula || !object.IsGood()) return {};
  R3::Box box;
  box.Extend(low), box.Extend(high);
  return PlacedShape{std::make_shared<const R3::Implicit>(std::move(*formula), box)};
}

}  // namespace

extern const std::vector<ObjectKind> surface_kinds{
    {{"blob", "metaball"}, ReadBlob},
    {{"bezier"}, [](Mapping& object) { return ReadPatch("bezier", object); }},
    {{"bspline"}, [](Mapping& object) { return ReadPatch("bspline", object); }},
    {{"implicit"}, ReadImplicit},
};

}  // namespace ray
