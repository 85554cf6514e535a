#include <utility>

#include "source/parse/CsgOf.h"
#include "source/parse/scn/ScnReader.h"
#include "source/text/Quoting.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

R3::CsgOperation ReadOperation(Statement& statement) {
  const Token word = statement.Word("operation");
  for (std::size_t i = 0; i < csg_operations.size(); ++i)
    if (word.text == csg_operations[i]) return static_cast<R3::CsgOperation>(i);
  statement.Error(word, "csg must be followed by union, intersection or difference, got " + Quoted(word.text),
                  Suggestion(word.text, csg_operations, "operations"));
  return {};
}

/// An extension. What is inside it up to its end is combined; it is opened whatever is wrong, so that its end finds it.
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

extern const Command csg_command{
    "csg", "csg union|intersection|difference mat_id",
    "combines the closed solids up to its end: all of them, what they have in common, or the first without the others",
    ReadCsg};

}  // namespace ray
