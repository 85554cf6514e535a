#include <array>
#include <utility>

#include "source/parse/CsgOf.h"
#include "source/parse/scn/Placing.h"
#include "source/parse/scn/ScnReader.h"
#include "source/scene/Singular.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

constexpr auto entries = R3::ArgumentsNamed("m00", "m01", "m02", "m03", "m10", "m11", "m12", "m13", "m20", "m21", "m22",
                                            "m23", "m30", "m31", "m32", "m33");

R3::Matrix MatrixOf(const std::vector<double>& entry) {
  R3::Matrix matrix;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) matrix.m[row][column] = entry[4 * row + column];
  return matrix;
}

void CheckLastRow(Statement& statement, const Arguments& read) {
  constexpr std::array<double, 4> affine{0, 0, 0, 1};
  for (std::size_t i = 0; i < affine.size(); ++i) {
    if (read.values[12 + i] == affine[i]) continue;
    statement.Error(read.words[12 + i], "the last row of a matrix must be 0 0 0 1",
                    "only affine transforms are supported");
    return;
  }
}

void WarnOfCondition(ScnReader& reader, const Statement& statement, const R3::Matrix& matrix) {
  if (IsSingular(matrix))
    reader.Warn(statement, "singular matrix: the group is not rendered");
  else if (Condition(matrix) > nearly_singular_condition)
    reader.Warn(statement, "nearly singular matrix: precision may suffer");
}

/// Returns true for a word in the place of a matrix that cannot start a statement.
bool IsWordForMatrix(const std::optional<Token>& next) {
  return next && !BeginsStatement(*next) && ParseNumber(next->text).problem && !SaysNanOrInfinity(next->text);
}

/// Reads 16 numbers, as in the course; or any number of placement words, an extension.
R3::Matrix ReadMatrix(Statement& statement) {
  const std::optional<Token>& next = statement.Peek();
  if (BeginsPlacement(statement) || !next || BeginsStatement(*next)) return ReadPlacement(statement);
  if (IsWordForMatrix(statement.Peek())) {
    RefusePlacement(statement);
    throw Statement::Incomplete{};
  }
  const Arguments read = statement.Numbers(entries);
  if (statement.IsGood()) CheckLastRow(statement, read);
  return MatrixOf(read.values);
}

// The group is opened despite mistakes in its numbers, so that its end finds it.
void ReadBegin(ScnReader& reader, Statement& statement) {
  Node group;
  try {
    group.material = reader.ReadMaterial(statement);
    group.transform = ReadMatrix(statement);
    if (statement.IsGood()) WarnOfCondition(reader, statement, group.transform);
  } catch (const Statement::Incomplete&) {
    reader.OpenGroup(statement, std::move(group));
    throw;
  }
  reader.OpenGroup(statement, std::move(group));
}

void ReadEnd(ScnReader& reader, Statement& statement) { reader.CloseGroup(statement); }

constexpr auto way = R3::ArgumentsNamed("dx", "dy", "dz");

/// Reads an extension: the displacement of the enclosing group while the shutter is open, in its parent's coordinates.
void ReadMotion(ScnReader& reader, Statement& statement) {
  const Arguments read = statement.Numbers(way);
  Node* group = reader.InnermostGroup();
  if (!group) statement.Error(statement.CommandWord(), "motion is only allowed inside a group, between begin and end");
  if (reader.Builder().IsInCsg())
    return statement.Error(statement.CommandWord(), "solids of a csg cannot move on their own",
                           "motion of a group around all of the csg moves it");
  if (group && statement.IsGood()) group->motion = {read.values[0], read.values[1], read.values[2]};
}

R3::CsgOperation ReadOperation(Statement& statement) {
  const Token word = statement.Word("operation");
  for (std::size_t i = 0; i < csg_operations.size(); ++i)
    if (word.text == csg_operations[i]) return static_cast<R3::CsgOperation>(i);
  statement.Error(word, "csg must be followed by union, intersection or difference, got " + Quoted(word.text),
                  Suggestion(word.text, csg_operations, "operations"));
  return {};
}

/// Reads an extension: a csg, which combines its contents up to its end. It is opened despite mistakes, so that its end
/// finds it.
void ReadCsg(ScnReader& reader, Statement& statement) {
  Node csg;
  csg.operation = R3::CsgOperation::unite;
  try {
    csg.operation = ReadOperation(statement);
    csg.material = reader.ReadMaterial(statement);
    const auto fault = statement.IsGood() ? reader.Builder().FaultOfCsg(csg) : std::nullopt;
    if (fault) statement.Error(statement.CommandWord(), fault->message, fault->hint);
  } catch (const Statement::Incomplete&) {
    reader.OpenGroup(statement, std::move(csg));
    throw;
  }
  reader.OpenGroup(statement, std::move(csg));
}

}  // namespace

extern const Command motion_command{"motion", "motion dx dy dz",
                                    "displacement of the enclosing group while the shutter is open", ReadMotion};
extern const Command begin_command{
    "begin", "begin mat_id m00 m01 m02 m03 m10 ... m33, or begin mat_id translate x y z ...",
    "opens a group with a material and a 4x4 matrix, row by row, or any number of " + UsageOfPlacements(), ReadBegin};
extern const Command end_command{"end", "end", "closes the innermost group of the file", ReadEnd};

extern const Command csg_command{
    "csg", "csg union|intersection|difference mat_id",
    "combines the closed solids up to its end: all of them, what they have in common, or the first without the others",
    ReadCsg};

}  // namespace ray
