#include "source/parse/meshes/Mtl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <unordered_map>

#include "source/parse/meshes/MeshWords.h"
#include "source/text/LookAlike.h"
#include "source/text/LowerCase.h"
#include "source/text/Number.h"

namespace ray {
namespace {

/// An option of a texture, and the number of its arguments.
struct MapOption {
  std::string_view name;
  bool has_words;
  std::size_t least, most;
};

constexpr std::array map_options{
    MapOption{"-s", false, 1, 3},     MapOption{"-o", false, 1, 3},         MapOption{"-t", false, 1, 3},
    MapOption{"-bm", false, 1, 1},    MapOption{"-mm", false, 2, 2},        MapOption{"-texres", false, 1, 1},
    MapOption{"-boost", false, 1, 1}, MapOption{"-clamp", true, 1, 1},      MapOption{"-blendu", true, 1, 1},
    MapOption{"-blendv", true, 1, 1}, MapOption{"-cc", true, 1, 1},         MapOption{"-imfchan", true, 1, 1},
    MapOption{"-type", true, 1, 1},   MapOption{"-colorspace", true, 1, 1},
};

const MapOption* OptionNamed(std::string_view name) {
  const auto found = std::ranges::find(map_options, name, &MapOption::name);
  return found == map_options.end() ? nullptr : &*found;
}

/// A reader of the statements of one file. Keywords are case-insensitive, as in most programs.
class MtlReader {
 public:
  MtlReader(const Text& file, Report& report)
      : words_(file, Tokenizer::Comments::hash, Tokenizer::Joints::backslash), report_(report) {}

  std::vector<MtlMaterial> Read() {
    while (const auto word = words_.Next()) {
      keyword_ = *word;
      ReadStatement(LowerCase(std::string(word->text)));
      while (ContinuesStatement()) words_.Next();
    }
    WarnOfMapsOfKa();
    for (const Remark& remark : remarks_)
      report_.Warn(PlaceOf(remark.first), remark.message + (remark.count == 1 ? ""
                                                                              : ", " + std::to_string(remark.count) +
                                                                                    " times, the first of them here"));
    return std::move(materials_);
  }

 private:
  struct MapOfKa {
    std::size_t material;
    Token keyword, rest;
  };
  /// A warning that may apply to every material.
  struct Remark {
    std::string message;
    Token first;
    std::size_t count = 0;
  };

  void ReadStatement(const std::string& keyword) {
    if (keyword == "newmtl") return BeginMaterial();
    if (materials_.empty()) return Warn(keyword_, Quoted(keyword_.text) + " before the first newmtl ignored");
    if (ReadNumberOrColor(keyword)) return;
    if (keyword == "map_kd") return ReadMap(Last().map_Kd);
    if (keyword == "map_bump" || keyword == "bump") return ReadMap(Last().bump);
    if (keyword == "norm") return ReadMap(Last().norm);
    if (keyword == "map_ka") return maps_of_ka_.push_back({materials_.size() - 1, keyword_, words_.RestOfLine()});
    const std::string hint = LookAlikeHint(keyword_.text);
    Warn(keyword_, Quoted(keyword_.text) + " is not supported and ignored" + (hint.empty() ? "" : "; " + hint));
  }

  void BeginMaterial() {
    const Token name = words_.RestOfLine();
    if (name.text.empty()) Warn(keyword_, "the material has no name; 'usemtl' without a name uses it");
    MtlMaterial& material = materials_.emplace_back();
    material.name = name.text;
    material.place = PlaceOf(name);
  }

  bool ReadNumberOrColor(const std::string& keyword) {
    if (keyword == "ka") return ReadColor(Last().Ka);
    if (keyword == "kd") return ReadColor(Last().Kd);
    if (keyword == "ks") return ReadColor(Last().Ks);
    if (keyword == "ke") return ReadColor(Last().Ke);
    if (keyword == "tf") return ReadColor(Last().Tf);
    if (keyword == "ns") return ReadNumber(Last().Ns);
    if (keyword == "ni") return ReadNumber(Last().Ni);
    if (keyword == "d") return ReadNumber(Last().d);
    if (keyword == "tr") return ReadNumber(Last().Tr);
    if (keyword == "illum") return ReadIllumination();
    return false;
  }

  /// Reads a color; a single number applies to all three channels.
  bool ReadColor(std::optional<R2::Color>& color) {
    if (NextIs("spectral") || NextIs("xyz")) {
      Warn(*words_.Peek(), "a color must be r g b; " + Quoted(words_.Peek()->text) + " is not supported and ignored");
      return true;
    }
    const double r = Number();
    color = R2::Color{r, r, r};
    if (!ContinuesStatement()) return true;
    color->g = Number();
    color->b = Number();
    return true;
  }

  bool ReadNumber(std::optional<double>& number) {
    if (NextIs("-halo")) {
      Warn(*words_.Peek(), "'-halo' is not supported and ignored");
      words_.Next();
    }
    number = Number();
    return true;
  }

  bool ReadIllumination() {
    const double model = Number();
    constexpr int last_model = 10;
    if (model > last_model || model != std::floor(model))
      words_.Fail(words_.Last(), "illum must be a whole number from 0 to 10, got " + Escaped(words_.Last().text));
    Last().illum = static_cast<int>(model);
    return true;
  }

  /// Reads a nonnegative number.
  double Number() {
    const double value = AnyNumber();
    if (value < 0)
      words_.Fail(words_.Last(), Escaped(keyword_.text) + " must not be negative, got " + Escaped(words_.Last().text));
    return value;
  }

  double AnyNumber() {
    if (!ContinuesStatement())
      words_.Fail(words_.Last(), Escaped(keyword_.text) + ": a number is missing",
                  HexColorHint(words_.Source(), words_.Last()));
    const Token word = *words_.Next();
    const auto [value, problem] = ParseNumber(word.text);
    if (problem) words_.Fail(word, Escaped(keyword_.text) + " " + problem + ", got " + Quoted(word.text));
    return value;
  }

  void ReadMap(std::optional<MtlMap>& map) {
    MtlMap read;
    while (ContinuesStatement() && words_.Peek()->text[0] == '-') ReadOption(read, *words_.Next());
    const Token file = NameBeforeOptions();
    if (file.text.empty() || file.text.starts_with("# "))
      return Warn(keyword_, Quoted(keyword_.text) + " names no file and is ignored");
    while (ContinuesStatement()) ReadOption(read, *words_.Next());
    read.file = file.text;
    read.place = PlaceOf(file);
    map = std::move(read);
  }

  /// Reads the rest of the line, or the part before options that some programs write after the name.
  Token NameBeforeOptions() {
    MeshWords ahead = words_;
    for (std::size_t words = 1; ahead.HasMoreOnLine(); ++words) {
      ahead.Next();
      if (!ahead.HasMoreOnLine() || !BeginsOptions(ahead)) continue;
      Token name = *words_.Peek();
      for (std::size_t i = 0; i < words; ++i) words_.Next();
      const std::string_view last = words_.Last().text;
      name.text = {name.text.data(), static_cast<std::size_t>(last.data() + last.size() - name.text.data())};
      return name;
    }
    return words_.RestOfLine();
  }

  /// Returns true if the rest of the line consists of options and their arguments.
  static bool BeginsOptions(MeshWords words) {
    const auto next_is_word = [&] { return words.HasMoreOnLine() && words.Peek()->text[0] != '-'; };
    const auto next_is_number = [&] { return words.HasMoreOnLine() && !ParseNumber(words.Peek()->text).problem; };
    while (words.HasMoreOnLine()) {
      const MapOption* option = OptionNamed(words.Next()->text);
      if (!option) return false;
      std::size_t arguments = 0;
      for (; arguments < option->most && (option->has_words ? next_is_word() : next_is_number()); ++arguments)
        words.Next();
      if (arguments < option->least) return false;
    }
    return true;
  }

  void ReadOption(MtlMap& map, const Token& option) {
    if (option.text == "-s") return ReadVector(map.scale, 1);
    if (option.text == "-o") return ReadVector(map.offset, 0);
    if (option.text == "-bm") {
      map.multiplier = AnyNumber();
    } else if (option.text == "-clamp") {
      map.is_clamped = ReadSwitch();
    } else {
      PassOverOption(option);
    }
  }

  /// Reads up to three numbers, u v w; a missing v is set to `missing`.
  void ReadVector(R2::Vector& v, double missing) {
    v = {AnyNumber(), missing};
    if (NextIsNumber()) v.y = AnyNumber();
    if (NextIsNumber()) AnyNumber();
  }

  bool ReadSwitch() {
    const bool is_on = NextIs("on");
    if (!is_on && !NextIs("off")) words_.Fail(words_.Last(), "-clamp must be followed by on or off");
    words_.Next();
    return is_on;
  }

  void PassOverOption(const Token& option) {
    const MapOption* known = OptionNamed(option.text);
    if (!known) words_.Fail(option, "unknown option " + Quoted(option.text) + " of a texture");
    if (known->has_words && ContinuesStatement()) words_.Next();
    while (!known->has_words && NextIsNumber()) words_.Next();
    // Interpolation of texels, and the luminance as their channel, are the default anyway.
    if (option.text == "-blendu" || option.text == "-blendv" || option.text == "-imfchan") return;
    Warn(option, Quoted(option.text) + " is not supported and ignored");
  }

  /// Warns about separate maps of ka. Programs repeat the image of kd as that of ka, which textures multiply anyway.
  void WarnOfMapsOfKa() {
    for (const MapOfKa& map : maps_of_ka_) {
      const auto& map_Kd = materials_[map.material].map_Kd;
      if (!map_Kd || !map.rest.text.ends_with(map_Kd->file))
        Warn(map.keyword, Quoted(map.keyword.text) + " is not supported and ignored");
    }
  }

  bool ContinuesStatement() { return words_.Peek() && !words_.Peek()->starts_line; }
  bool NextIs(std::string_view word) { return ContinuesStatement() && words_.Peek()->text == word; }
  bool NextIsNumber() { return ContinuesStatement() && !ParseNumber(words_.Peek()->text).problem; }
  MtlMaterial& Last() { return materials_.back(); }
  std::string PlaceOf(const Token& word) const { return Place(words_.Source().name, word.line, word.column); }
  void Warn(const Token& at, const std::string& message) {
    const auto [known, is_new] = number_of_remark_.try_emplace(message, remarks_.size());
    if (is_new) remarks_.push_back({message, at});
    ++remarks_[known->second].count;
  }

  MeshWords words_;
  Report& report_;
  Token keyword_;
  std::vector<MtlMaterial> materials_;
  std::vector<MapOfKa> maps_of_ka_;
  std::vector<Remark> remarks_;
  std::unordered_map<std::string, std::size_t> number_of_remark_;  // by message
};

}  // namespace

std::vector<MtlMaterial> ReadMtl(const Text& file, Report& report) { return MtlReader(file, report).Read(); }

}  // namespace ray
