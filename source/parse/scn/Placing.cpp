#include "source/parse/scn/Placing.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "R3/Placement.h"
#include "source/text/Number.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

R3::Vector VectorOf(const Arguments& read, std::size_t first = 0) {
  return {read.values[first], read.values[first + 1], read.values[first + 2]};
}

constexpr auto translation = R3::ArgumentsNamed("x", "y", "z");

R3::Matrix ReadTranslation(Statement& statement) { return Translation(VectorOf(statement.Coordinates(translation))); }

constexpr auto rotation = R3::ArgumentsNamed("degrees", "ax", "ay", "az");

R3::Matrix ReadRotation(Statement& statement) {
  const Arguments read = statement.Coordinates(rotation);
  if (!statement.IsGood()) return {};
  if (VectorOf(read, 1) == R3::Vector{}) {
    statement.Error(read.words[1], "rotate: the axis must not be 0 0 0", "rotate 90 0 1 0 turns about the y axis");
    return {};
  }
  return R3::RotationAbout(VectorOf(read, 1), read.values[0]);
}

constexpr auto first_factor = R3::ArgumentsNamed("s");
constexpr auto more_factors = R3::ArgumentsNamed("sy", "sz");

/// Reads one factor, or three.
R3::Matrix ReadScaling(Statement& statement) {
  const double x = statement.Coordinates(first_factor).values[0];
  const auto& next = statement.Peek();
  if (!next || (ParseNumber(next->text).problem && !SaysNanOrInfinity(next->text))) return R3::Scaling({x, x, x});
  const Arguments more = statement.Coordinates(more_factors);
  return R3::Scaling({x, more.values[0], more.values[1]});
}

R3::Matrix ReadLookAt(Statement& statement) {
  const Arguments read = statement.Coordinates(look_at_arguments);
  if (!statement.IsGood()) return {};
  const R3::Vector eye = VectorOf(read), target = VectorOf(read, 3);
  const auto frame = LookingAt(R3::Point{} + eye, R3::Point{} + target, VectorOf(read, 6));
  if (!frame)
    statement.Error(read.words[3], "look_at: ex ey ez must differ from tx ty tz, and up must not be along the view",
                    "look_at 0 1 5  0 1 0  0 1 0 stands at (0, 1, 5) and faces (0, 1, 0)");
  return frame.value_or(R3::Matrix{});
}

struct Placement {
  std::string_view word, usage;
  R3::Matrix (*read)(Statement&);
};

constexpr std::array placements{Placement{"translate", "translate x y z", ReadTranslation},
                                Placement{"rotate", "rotate degrees ax ay az", ReadRotation},
                                Placement{"scale", "scale s or scale sx sy sz", ReadScaling},
                                Placement{"look_at", "look_at ex ey ez tx ty tz ux uy uz", ReadLookAt}};

const Placement* NextPlacement(Statement& statement) {
  const auto& next = statement.Peek();
  const auto found = next ? std::ranges::find(placements, next->text, &Placement::word) : placements.end();
  return found == placements.end() ? nullptr : &*found;
}

bool IsFinite(const R3::Matrix& matrix) {
  return std::ranges::all_of(matrix.m, [](const auto& row) {
    return std::ranges::all_of(row, [](double entry) { return std::isfinite(entry); });
  });
}

}  // namespace

std::string UsageOfPlacements() {
  std::string all;
  for (const Placement& placement : placements) all += (all.empty() ? "" : ", ") + std::string(placement.usage);
  return all;
}

bool BeginsPlacement(Statement& statement) { return NextPlacement(statement) != nullptr; }

R3::Matrix ReadPlacement(Statement& statement) {
  R3::Matrix all;
  while (const Placement* placement = NextPlacement(statement)) {
    statement.Takes(placement->word);
    statement.BeginPart(placement->word, placement->usage);
    all = all * placement->read(statement);
  }
  if (statement.IsGood() && !IsFinite(all))
    statement.Error(statement.CommandWord(), "the combined transform exceeds the range of a double");
  return all;
}

void RefusePlacement(Statement& statement) {
  const Token word = *statement.Peek();
  std::array<std::string_view, placements.size()> words;
  std::ranges::transform(placements, words.begin(), &Placement::word);
  statement.Error(word, "expected a matrix or a word that places the group, got " + Quoted(word.text),
                  Suggestion(word.text, words, "words"));
  statement.RestOfLine();
}

}  // namespace ray
