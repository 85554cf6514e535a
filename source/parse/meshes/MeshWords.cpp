#include "source/parse/meshes/MeshWords.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

double MeshWords::AnyNumber(const Part& part) {
  const Token word = Need(part);
  const auto [value, problem] = ParseNumber(word.text);
  if (!problem) return value;
  if (SaysNanOrInfinity(word.text) || std::isinf(value)) return std::numeric_limits<double>::quiet_NaN();
  Fail(word, part.Words() + " " + problem + ", got " + Quoted(word.text));
}

double MeshWords::Coordinate(const Part& part) {
  const Token word = Need(part);
  const auto [value, problem] = ParseNumber(word.text);
  if (problem) Fail(word, part.Words() + " " + problem + ", got " + Quoted(word.text));
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

std::optional<double> MeshWords::NumberIfUsable(const Part& part) {
  const double value = AnyNumber(part);
  return IsCoordinate(value) ? std::optional(value) : std::nullopt;
}

std::optional<R3::Vector> MeshWords::VectorIfUsable(const char* of, std::size_t number) {
  const auto x = NumberIfUsable({"x", of, number});
  const auto y = NumberIfUsable({"y", of, number});
  const auto z = NumberIfUsable({"z", of, number});
  return x && y && z ? std::optional(R3::Vector{*x, *y, *z}) : std::nullopt;
}

std::int64_t MeshWords::Whole(const Part& part) { return WholeIn(Need(part), part); }

std::int64_t MeshWords::WholeIn(const Token& word, const Part& part) const {
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

Token MeshWords::RestOfLine() {
  const std::string_view bytes = Source().bytes;
  const auto behind = static_cast<std::size_t>(last_.text.data() + last_.text.size() - bytes.data());
  std::string_view line = bytes.substr(behind, bytes.find_first_of("\r\n", behind) - behind);
  const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
  line = line.substr(first, line.find_last_not_of(" \t") + 1 - first);
  const Token rest{line, last_.line, last_.column + CountCharacters(last_.text) + first};
  while (HasMoreOnLine()) Next();
  return rest;
}

std::size_t MeshWords::LinesLeft() const {
  Tokenizer ahead = tokens_;
  ahead.SkipLine(last_.line);
  std::size_t lines = 0;
  for (; ahead.Peek(); ++lines) ahead.SkipLine(ahead.Peek()->line);
  return lines;
}

void MeshWords::Fail(const Token& at, const std::string& message, const std::string& hint) const {
  throw ErrorAt(Source(), at, message, hint);
}

void Tally::Warn(const Text& file, Report& report, const std::string& one, const std::string& many) const {
  if (IsEmpty()) return;
  const std::string number = std::to_string(count_) + " ";
  const bool has_line = first_.line > 0;
  report.Warn(Place(file.name, first_.line, first_.column),
              count_ == 1 ? number + one : number + many + (has_line ? ", the first of them here" : ""));
}

void WarnOfAbsent(const Tally& normals, const Tally& uvs, const Text& file, Report& report) {
  normals.Warn(file, report, "use of a normal that is not finite is ignored",
               "uses of normals that are not finite are ignored");
  uvs.Warn(file, report, "use of texture coordinates that are not finite counts as 0 0",
           "uses of texture coordinates that are not finite count as 0 0");
}

}  // namespace ray
