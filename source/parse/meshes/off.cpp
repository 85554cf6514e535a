#include <optional>

#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/MeshWords.h"
#include "source/parse/meshes/VertexColors.h"
#include "source/text/Number.h"

namespace ray {
namespace {

/// The data of each vertex in addition to its position, as stated by the header: [ST][C][N][4][n]OFF. MeshLab writes
/// the letters in another order, NCSTOFF, and a vertex's color before its normal.
/// Source: the manual of Geomview, OFF files; files of MeshLab 2025.07.
struct Header {
  bool has_uv = false, has_color = false, has_normal = false;
  bool color_is_first = false;
  std::optional<Token> vertices;  // their number, if it follows without a blank, as in "OFF8 6 12"

  std::size_t NumbersOfVertex(std::size_t numbers_of_color) const {
    return 3 + (has_normal ? 3 : 0) + (has_color ? numbers_of_color : 0) + (has_uv ? 2 : 0);
  }
};

Header ReadHeader(MeshWords& words) {
  const Token word = words.Need({"OFF"});
  std::string_view rest = word.text;
  const auto takes = [&](std::string_view letters, bool& has) {
    if (has || !rest.starts_with(letters)) return false;
    rest.remove_prefix(letters.size());
    return has = true;
  };
  Header header;
  header.color_is_first = rest.find("NC") != std::string_view::npos;
  while (takes("ST", header.has_uv) || takes("C", header.has_color) || takes("N", header.has_normal)) {
  }
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF")
    words.Fail(word, "vertices of four or more dimensions are not supported");
  if (rest.starts_with("OFF#")) words.SkipLine();  // a comment; meshio writes one
  if (rest == "OFF" || rest.starts_with("OFF#")) return header;
  if (!rest.starts_with("OFF") || rest.find_first_not_of("0123456789", 3) != std::string_view::npos)
    words.Fail(word, "an .off file must begin with 'OFF', got " + Quoted(word.text));
  const std::size_t bytes = word.text.size() - rest.size() + 3;
  header.vertices = Token{word.text.substr(bytes), word.line, word.column + bytes};
  return header;
}

std::size_t CountIn(const MeshWords& words, const Token& word, const char* what) {
  const std::int64_t count = words.WholeIn(word, {what});
  if (count < 0) words.Fail(word, std::string(what) + " must not be negative");
  return static_cast<std::size_t>(count);
}

void CheckDeclared(const MeshWords& words, std::size_t count, const char* what, std::size_t least_bytes) {
  if (count <= words.BytesLeft() / least_bytes + 1) return;
  words.Fail(words.Last(), "the header declares " + std::to_string(count) + " " + what + ", but only " +
                               BytesThatFollow(words.BytesLeft()));
}

/// A reader of consecutive numbers, regardless of line ends; only the color after the corners of a face ends with its
/// line. Files whose vertices have more numbers than their header declares are also read: there each vertex takes a
/// line.
class OffReader {
 public:
  OffReader(const Text& file, Report& report) : words_(file, Tokenizer::Comments::hash), report_(report) {}

  MeshFile Read() {
    header_ = ReadHeader(words_);
    if (words_.NextIs("BINARY"))
      words_.Fail(*words_.Peek(), "binary .off files are not supported", "save it as text, or as .ply");
    vertices_ = CountIn(words_, header_.vertices ? *header_.vertices : words_.Need({"the number of vertices"}),
                        "the number of vertices");
    CheckDeclared(words_, vertices_, "vertices", 6);  // "0 0 0\n"
    faces_ = CountIn(words_, words_.Need({"the number of faces"}), "the number of faces");
    CheckDeclared(words_, faces_, "faces", 2);  // "0\n"
    SkipEdges();
    Faces faces(mesh_);
    try {
      ReadVertices();
      ReadFaces(faces);
    } catch (SceneError& error) {
      if (error.hint.empty()) error.hint = HintOfVertices();
      throw;
    }
    mesh_.colors = colors_.Take(mesh_.positions.size());
    Warn();
    faces.AddVertices();
    return {.data = std::move(mesh_), .has_8_bit_colors = colors_.WereBytes()};
  }

 private:
  /// Skips the number of edges, which many files get wrong and some omit. It is on the line of the other two or alone
  /// on the next. Vertices may follow it on its line.
  void SkipEdges() {
    MeshWords ahead = words_;
    const std::size_t on_line = ahead.SkipLine();
    if (on_line > 0 ? on_line > 3 : ahead.Next() && !ahead.HasMoreOnLine())
      words_.Next();
    else
      words_.SkipLine();
  }

  void ReadVertices() {
    R1::ReserveOnHugePages(mesh_.positions, vertices_);
    for (std::size_t i = 0; i < vertices_; ++i) {
      ReadVertex(i);
      if (!words_.HasMoreOnLine()) continue;
      if (!has_line_each_) has_line_each_ = words_.LinesLeft() >= vertices_ - 1 - i + faces_;
      if (!*has_line_each_) continue;
      words_.Next();
      long_vertices_.Add(words_.Last());
      words_.SkipLine();
    }
  }

  void ReadVertex(std::size_t i) {
    mesh_.positions.push_back(words_.Place("vertex", i));
    if (i == 0) CountNumbersOfColor();
    if (header_.has_color && header_.color_is_first) ReadColor(i);
    if (header_.has_normal) ReadNormal(i);
    if (header_.has_color && !header_.color_is_first) ReadColor(i);
    if (header_.has_uv) ReadUv(i);
  }

  void ReadNormal(std::size_t i) {
    const auto normal = words_.VectorIfUsable("the normal of vertex", i);
    if (!normal) absent_normals_.Add(words_.Last());
    mesh_.normals.push_back(AsNormal(normal.value_or(R3::Vector{})));
  }

  void ReadUv(std::size_t i) {
    const auto s = words_.NumberIfUsable({"s", "vertex", i}), t = words_.NumberIfUsable({"t", "vertex", i});
    if (!s || !t) absent_uvs_.Add(words_.Last());
    mesh_.uvs.push_back(s && t ? R2::Point{*s, *t} : R2::Point{});
  }

  /// Determines the numbers per color: red, green, blue and alpha; some programs omit alpha, which the first vertex's
  /// line shows.
  void CountNumbersOfColor() {
    MeshWords ahead = words_;
    numbers_of_color_ = 3 + ahead.SkipLine() == header_.NumbersOfVertex(3) ? 3 : 4;
  }

  void ReadColor(std::size_t i) {
    const double red = words_.AnyNumber({"red", "vertex", i});
    const Token first = words_.Last();
    const double green = words_.AnyNumber({"green", "vertex", i});
    const double blue = words_.AnyNumber({"blue", "vertex", i});
    if (numbers_of_color_ == 4) words_.AnyNumber({"alpha", "vertex", i});
    colors_.Add(i, {red, green, blue}, first);
  }

  void ReadFaces(Faces& faces) {
    std::vector<std::uint32_t> corners;
    faces.Reserve(faces_, words_.BytesLeft());
    std::size_t i = 0;
    for (; i < faces_ && !words_.AtEnd(); ++i) {
      const std::int64_t count = words_.Whole({"number of corners", "face", i});
      const Token start = words_.Last();
      if (count < 0 || static_cast<std::uint64_t>(count) > words_.BytesLeft() / 2 + 1)
        words_.Fail(start, "face " + std::to_string(i) + " cannot have " + Escaped(start.text) + " corners");
      corners.clear();
      for (std::int64_t k = 0; k < count; ++k)
        corners.push_back(words_.Index({"a corner", "face", i}, mesh_.positions.size()));
      SkipFaceColor();
      if (count < 3 && has_line_each_) words_.Fail(start, "face " + std::to_string(i) + " has fewer than 3 corners");
      if (const char* problem = faces.Add(corners, start)) words_.Fail(start, problem);
    }
    if (i < faces_) WarnOfFewFaces(i);
    if (i == faces_ && !words_.AtEnd()) WarnOfMoreData();
    faces.Warn(words_.Source(), report_);
  }

  /// Skips the color of a face: an index into a map, or three or four channels. A face that requires its own line may
  /// follow instead.
  void SkipFaceColor() {
    if (!words_.HasMoreOnLine()) return;
    const Token first = *words_.Peek();
    const std::size_t numbers = words_.SkipLine();
    if (numbers == 2 || numbers > 4) long_faces_.Add(first);
    if (numbers > 3 && ParseWhole(first.text).value + 1 == static_cast<std::int64_t>(numbers)) hidden_faces_.Add(first);
  }

  void WarnOfFewFaces(std::size_t found) {
    const std::string message =
        "the header declares " + std::to_string(faces_) + " faces, but the file has " + std::to_string(found);
    if (has_line_each_) words_.Fail(words_.Last(), message);
    for (const Tally& dropped : {hidden_faces_, long_faces_})
      if (!dropped.IsEmpty())
        words_.Fail(dropped.First(), message, "numbers after a face on its line are read as its color");
    WarnOf(message);
  }

  void WarnOfMoreData() {
    const std::string message = "the file has more data than the header declares";
    if (has_line_each_) words_.Fail(*words_.Peek(), message);
    WarnOf(message);
  }

  /// Returns a hint if vertices do not end with their lines: oddities of faces are then errors, because their numbers
  /// may have been misread.
  std::string HintOfVertices() const {
    if (!has_line_each_) return {};
    return "the header declares " + std::to_string(header_.NumbersOfVertex(numbers_of_color_)) +
           " numbers for each vertex, but there are lines with more";
  }

  void Warn() {
    long_vertices_.Warn(words_.Source(), report_, "vertex has ignored numbers after those that the header declares",
                        "vertices have ignored numbers after those that the header declares");
    long_faces_.Warn(words_.Source(), report_, "face has ignored numbers after its corners, more than a color has",
                     "faces have ignored numbers after their corners, more than a color has");
    WarnOfAbsent(absent_normals_, absent_uvs_, words_.Source(), report_);
    colors_.Warn(words_.Source(), report_);
  }
  void WarnOf(const std::string& message) { report_.Warn(Escaped(words_.Source().name), message); }

  MeshWords words_;
  Report& report_;
  Header header_;
  std::size_t vertices_ = 0, faces_ = 0;
  std::size_t numbers_of_color_ = 4;
  std::optional<bool> has_line_each_;  // of vertices; known once one of them does not end with its line
  R3::MeshData mesh_;
  VertexColors colors_;
  Tally long_vertices_, long_faces_, hidden_faces_, absent_normals_, absent_uvs_;
};

MeshFile ReadOff(const Text& file, Report& report) { return OffReader(file, report).Read(); }

}  // namespace

extern const MeshFormat off_mesh_format{".off", ReadOff};

}  // namespace ray
