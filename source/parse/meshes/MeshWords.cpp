#include "source/parse/meshes/MeshWords.h"

#include "source/parse/Coordinate.h"
#include "source/text/Number.h"
#include "source/text/Words.h"

namespace ray {

std::string BytesThatFollow(std::size_t bytes) {
  return Counted(bytes, "byte") + (bytes == 1 ? " follows" : " follow");
}

std::optional<Token> MeshWords::Next() {
  auto next = tokens_.Next();
  if (next) last_ = *next;
  return next;
}

Token MeshWords::Need(const Part& part) {
  if (const auto next = Next()) return *next;
  if (last_.line == 0) throw ErrorIn(Source().name, "the file is empty");
  Fail(last_, "the file ends before " + part.Words());
}

double MeshWords::Number(const Part& part) {
  const Token word = Need(part);
  const auto [value, problem] = ParseNumber(word.text);
  if (problem) Fail(word, part.Words() + " " + problem + ", got " + Quoted(word.text));
  return value;
}

double MeshWords::Coordinate(const Part& part) {
  const double value = Number(part);
  if (!IsCoordinate(value))
    Fail(last_, part.Words() + " must not exceed 1e150 in magnitude, got " + Escaped(last_.text));
  return value;
}

R3::Point MeshWords::Place(const char* of, std::size_t number) {
  const double x = Coordinate({"x", of, number});
  const double y = Coordinate({"y", of, number});
  const double z = Coordinate({"z", of, number});
  return {x, y, z};
}

std::int64_t MeshWords::Whole(const Part& part) {
  const Token word = Need(part);
  const auto [value, problem] = ParseWhole(word.text);
  if (problem) Fail(word, part.Words() + " " + problem + ", got " + Quoted(word.text));
  return value;
}

std::uint32_t MeshWords::Index(const Part& part, std::size_t below) {
  const std::int64_t value = Whole(part);
  if (value < 0 || static_cast<std::uint64_t>(value) >= below)
    Fail(last_, part.Words() + " must be an index below " + std::to_string(below) + ", got " + Escaped(last_.text));
  return static_cast<std::uint32_t>(value);
}

bool MeshWords::HasMoreOnLine() { return tokens_.Peek() && tokens_.Peek()->line == last_.line; }

void MeshWords::Fail(const Token& at, const std::string& message, const std::string& hint) const {
  throw ErrorAt(Source(), at, message, hint);
}

}  // namespace ray
