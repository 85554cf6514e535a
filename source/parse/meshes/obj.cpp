#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "source/parse/Coordinate.h"
#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/MeshWords.h"
#include "source/parse/meshes/VertexColors.h"
#include "source/text/LookAlike.h"
#include "source/text/Number.h"

namespace ray {
namespace {

// Statements of groups, names and rendering attributes, which have no visible effect; and those of curves and surfaces.
constexpr std::string_view invisible[] = {"g",     "o",        "mg",       "lod",        "usemap",    "maplib",
                                          "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "csh"};
constexpr std::string_view curves[] = {"vp",    "cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",
                                       "parm",  "trim",   "hole", "scrv", "sp",   "end",  "con",   "ctech",
                                       "stech", "bzp",    "bsp",  "cdc",  "cdp",  "res",  "call"};

/// A reader of vertices and faces. Other statements are skipped; those with a visible effect, and unknown ones, with a
/// warning.
/// Source: Wavefront, Advanced Visualizer manual, appendix B1: object files.
class ObjReader {
 public:
  explicit ObjReader(const Text& file) : words_(file, Tokenizer::Comments::hash, Tokenizer::Joints::backslash) {}

  MeshFile Read(Report& report) {
    while (const auto word = words_.Next()) {
      ReadStatement(*word);
      SkipStatement();
    }
    if (mesh_.positions.empty() && !unknown_.IsEmpty())
      words_.Fail(unknown_.First(),
                  "not one line defines a vertex in OBJ; unknown statement " + Quoted(unknown_.First().text));
    CheckMissing(missing_uvs_, uvs_.size(), "texture vertex");
    CheckMissing(missing_normals_, normals_.size(), "normal");
    mesh_.colors = colors_.Take(mesh_.positions.size());
    Warn(report);
    read_.has_8_bit_colors = colors_.WereBytes();
    MakeVertices(mesh_, corners_, faces_.Added(), uvs_, normals_);
    faces_.AddVertices();
    return std::move(read_);
  }

 private:
  /// Reads one statement; "fo" is an old name of "f".
  void ReadStatement(const Token& word) {
    const std::string_view name = word.text;
    if (name == "v") return ReadPlace();
    if (name == "f" || name == "fo") return ReadFace();
    if (name == "vt") return ReadUv();
    if (name == "vn") return ReadNormal();
    if (name == "s") return ReadSmoothing();
    if (name == "usemtl") return ReadMaterial();
    if (name == "mtllib") return ReadLibraries();
    if (name == "l" || name == "p") return lines_.Add(word);
    if (std::ranges::find(curves, name) != std::end(curves)) return curves_.Add(word);
    if (std::ranges::find(invisible, name) == std::end(invisible)) unknown_.Add(word);
  }

  void ReadPlace() {
    const std::size_t number = mesh_.positions.size() + 1;
    const double x = Coordinate({"x", "vertex", number});
    const double y = Coordinate({"y", "vertex", number});
    const double z = Coordinate({"z", "vertex", number});
    mesh_.positions.push_back({x, y, z});
    if (ContinuesStatement()) ReadBehindPlace(number);
  }

  /// Reads what follows a position: a weight, which only curves use, or a color without or with alpha.
  void ReadBehindPlace(std::size_t number) {
    const Token first = *words_.Peek();
    std::array<double, 3> color{};
    std::size_t numbers = 3;
    for (; ContinuesStatement(); ++numbers) {
      const double value = words_.AnyNumber({"a number", "vertex", number});
      if (numbers < 6) color[numbers - 3] = value;
    }
    if (numbers == 6 || numbers == 7) return colors_.Add(number - 1, color, first);
    if (numbers != 4)
      words_.Fail(words_.Last(), "vertex " + std::to_string(number) + " has " + std::to_string(numbers) + " numbers",
                  "supported: x y z, followed by a weight w, or a color r g b or r g b a");
  }

  void ReadUv() {
    const std::size_t number = uvs_.size() + 1;
    const double u = NumberOrNan({"u", "texture vertex", number});
    const double v = ContinuesStatement() ? NumberOrNan({"v", "texture vertex", number}) : 0;
    if (ContinuesStatement()) words_.AnyNumber({"w", "texture vertex", number});
    if (ContinuesStatement()) FailAtNext("a texture vertex has at most 3 numbers");
    uvs_.push_back({u, v});
  }

  void ReadNormal() {
    const std::size_t number = normals_.size() + 1;
    const double x = NumberOrNan({"x", "normal", number});
    const double y = NumberOrNan({"y", "normal", number});
    const double z = NumberOrNan({"z", "normal", number});
    if (ContinuesStatement()) FailAtNext("a normal has 3 numbers");
    normals_.push_back(AsNormal(R3::Vector{x, y, z}));
  }

  /// Reads a coordinate. Unlike elsewhere, the words of a statement end with its line.
  double Coordinate(const Part& part) {
    CheckContinues(part);
    return words_.Coordinate(part);
  }

  /// Reads a number; NaN if it is not finite or too large, which matters only if a face uses it.
  double NumberOrNan(const Part& part) {
    CheckContinues(part);
    return words_.NumberIfUsable(part).value_or(std::numeric_limits<double>::quiet_NaN());
  }

  void CheckContinues(const Part& part) {
    if (!ContinuesStatement()) words_.Fail(words_.Last(), part.Words() + " is missing");
  }

  [[noreturn]] void FailAtNext(const char* rule) {
    words_.Next();
    words_.Fail(words_.Last(), std::string(rule) + ", unexpected " + Quoted(words_.Last().text));
  }

  void ReadFace() {
    const Token command = words_.Last();
    const std::size_t first = corners_.size();
    places_.clear();
    names_.clear();
    while (ContinuesStatement()) {
      corners_.push_back(ReadCorner(*words_.Next()));
      places_.push_back(corners_.back().place);
    }
    names_.resize(places_.size());
    std::iota(names_.begin(), names_.end(), static_cast<std::uint32_t>(first));
    if (const char* problem = faces_.Add(places_, names_, command)) words_.Fail(command, problem);
  }

  /// Reads the name of a material; programs write an empty name if the material's name is empty.
  void ReadMaterial() {
    const Token name = words_.RestOfLine();
    const auto number = static_cast<std::uint32_t>(read_.materials.size());
    const auto [known, is_new] = numbers_of_materials_.try_emplace(std::string(name.text), number);
    if (is_new) read_.materials.push_back(NameAt(name));
    BeginRun(read_.material_runs, known->second);
  }

  void ReadLibraries() {
    const Token names = words_.RestOfLine();
    if (!names.text.empty()) read_.material_files.push_back(NameAt(names));
  }

  /// Reads a number, or "off" or 0.
  void ReadSmoothing() {
    const std::int64_t group = ContinuesStatement() ? ParseWhole(words_.Next()->text).value : 0;
    BeginRun(read_.smoothing_runs, static_cast<std::uint32_t>(group));
  }

  void BeginRun(std::vector<TriangleRun>& runs, std::uint32_t value) const {
    const std::size_t first = mesh_.triangles.size();
    if (!runs.empty() && runs.back().first_triangle == first) runs.pop_back();
    runs.push_back({first, value});
  }

  MeshName NameAt(const Token& name) const {
    return {std::string(name.text), Place(words_.Source().name, name.line, name.column)};
  }

  /// Reads place, place/uv, place//normal or place/uv/normal.
  Corner ReadCorner(const Token& word) {
    std::string_view rest = word.text;
    const auto next = [&] {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view part = rest.substr(0, slash);
      rest.remove_prefix(std::min(slash + 1, rest.size()));
      return part;
    };
    const std::string_view place = next(), uv = next(), normal = next();
    if (!rest.empty()) words_.Fail(word, "a corner must be vertex/texture/normal, got " + Quoted(word.text));
    Corner corner{IndexOf(word, place, mesh_.positions.size(), "vertex")};
    if (!uv.empty()) corner.uv = UvOf(word, uv);
    if (!normal.empty()) corner.normal = NormalOf(word, normal);
    return corner;
  }

  std::uint32_t UvOf(const Token& word, std::string_view text) {
    if (uvs_.empty()) return Missing(word, text, "texture vertex", missing_uvs_);
    const std::uint32_t index = IndexOf(word, text, uvs_.size(), "texture vertex");
    if (IsCoordinate(uvs_[index].x) && IsCoordinate(uvs_[index].y)) return index;
    absent_uvs_.Add(word);
    return Corner::none;
  }

  std::uint32_t NormalOf(const Token& word, std::string_view text) {
    if (normals_.empty()) return Missing(word, text, "normal", missing_normals_);
    const std::uint32_t index = IndexOf(word, text, normals_.size(), "normal");
    const R3::Normal& n = normals_[index];
    if (IsCoordinate(n.x) && IsCoordinate(n.y) && IsCoordinate(n.z)) return index;
    absent_normals_.Add(word);
    return Corner::none;
  }

  /// Converts an index: 1-based; negative ones count back from the last one so far.
  std::uint32_t IndexOf(const Token& word, std::string_view text, std::size_t count, const char* what) const {
    const std::int64_t number = WholeIn(word, text, what);
    const auto known = static_cast<std::int64_t>(count);
    if (number == 0 || number > known || number < -known) FailOfIndex(word, text, count, what);
    return static_cast<std::uint32_t>(number > 0 ? number - 1 : known + number);
  }

  std::int64_t WholeIn(const Token& word, std::string_view text, const char* what) const {
    const auto [number, problem] = ParseWhole(text);
    if (problem) words_.Fail(word, std::string("a ") + what + " " + problem + ", got " + Quoted(word.text));
    return number;
  }

  [[noreturn]] void FailOfIndex(const Token& word, std::string_view text, std::size_t count, const char* what) const {
    words_.Fail(word, std::string("no ") + what + " " + Escaped(text),
                std::to_string(count) + " defined before this line, numbered from 1");
  }

  /// Counts an index into a list that the file lacks; some programs write them, often all 0 or 1.
  std::uint32_t Missing(const Token& word, std::string_view text, const char* what, Tally& missing) const {
    WholeIn(word, text, what);
    missing.Add(word);
    return Corner::none;
  }

  /// Throws if the list begins after faces that index it, so that it is not missing.
  void CheckMissing(const Tally& missing, std::size_t count, const char* what) const {
    if (missing.IsEmpty() || count == 0) return;
    words_.Fail(missing.First(), std::string("a ") + what + " is used before the first is defined");
  }

  void Warn(Report& report) const {
    const Text& file = words_.Source();
    faces_.Warn(file, report);
    missing_uvs_.Warn(file, report, "corner has an index of texture coordinates, but the file has none",
                      "corners have an index of texture coordinates, but the file has none");
    missing_normals_.Warn(file, report, "corner has an index of a normal, but the file has none",
                          "corners have an index of a normal, but the file has none");
    WarnOfAbsent(absent_normals_, absent_uvs_, file, report);
    colors_.Warn(file, report);
    lines_.Warn(file, report, "statement of lines or points skipped", "statements of lines or points skipped");
    curves_.Warn(file, report, "statement of curves or surfaces skipped", "statements of curves or surfaces skipped");
    const std::string hint = LookAlikeHint(unknown_.First().text), more = hint.empty() ? "" : "; " + hint;
    unknown_.Warn(file, report, "unknown statement skipped" + more, "unknown statements skipped" + more);
  }

  bool ContinuesStatement() { return words_.Peek() && !words_.Peek()->starts_line; }

  void SkipStatement() {
    while (ContinuesStatement()) words_.Next();
  }

  MeshWords words_;
  MeshFile read_;
  R3::MeshData& mesh_ = read_.data;
  VertexColors colors_;
  std::unordered_map<std::string, std::uint32_t> numbers_of_materials_;
  std::vector<R2::Point> uvs_;       // NaN if not usable
  std::vector<R3::Normal> normals_;  // NaN if not usable
  std::vector<Corner> corners_;
  Faces faces_{mesh_};
  Tally missing_uvs_, missing_normals_, absent_uvs_, absent_normals_;
  Tally lines_, curves_, unknown_;
  std::vector<std::uint32_t> places_, names_;
};

MeshFile ReadObj(const Text& file, Report& report) { return ObjReader(file).Read(report); }

}  // namespace

extern const MeshFormat obj_mesh_format{".obj", ReadObj};

}  // namespace ray
