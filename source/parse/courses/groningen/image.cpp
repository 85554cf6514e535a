#include <array>

#include "source/parse/courses/groningen/GroningenReader.h"
#include "source/text/LowerCase.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"

namespace ray {

void GroningenReader::ReadImageSettings(Mapping& scene) {
  Set("clamp", "samples");
  Set("bytes", "truncated");
  Set("min_luminance", "0");
  Set("internal_reflection", "on");
  Set("shadows", "off");
  Set("max_depth", "0");
  if (const auto shadows = scene.Find({"Shadows", "shadows"}))
    if (const auto on = shadows->Bool()) Set("shadows", *on ? "on" : "off", &shadows->What());
  if (const auto depth = scene.Find({"MaxRecursionDepth", "maxRecursionDepth", "RecursionDepth"}))
    if (const auto bounces = depth->Whole(0, std::numeric_limits<int>::max()))
      Set("max_depth", ToText(*bounces), &depth->What());
  ReadMode(scene);
  ReadZBuffer(scene);
  ReadGooch(scene);
}

// The modes in the order of their numbers in the course's programs.
void GroningenReader::ReadMode(Mapping& scene) {
  struct Name {
    const char *word, *number;
    Mode mode;
    const char* option;
  };
  static constexpr std::array names{
      Name{"phong", "0", Mode::phong, "whitted"},
      Name{"zbuffer", "1", Mode::zbuffer, "zbuffer"},
      Name{"normal", "2", Mode::normal, "normal_color"},
      Name{"gooch", "3", Mode::gooch, "gooch"},
      Name{"texcoord", "", Mode::uv, "uv_color"},
      Name{"texturecoordinate", "", Mode::uv, "uv_color"},
      Name{"flat", "", Mode::flat, "flat"},
      Name{"toon", "", Mode::toon, "toon"},
      Name{"hatching", "", Mode::hatching, "hatching"},
  };
  const auto field = scene.Find({"RenderMode", "renderMode", "rendermode"});
  const auto word = field ? field->Word() : std::nullopt;
  if (!word) return;
  const std::string lower = LowerCase(*word);
  std::vector<std::string> known;
  for (const Name& name : names) {
    known.emplace_back(name.word);
    if (lower != name.word && (lower != name.number || lower.empty())) continue;
    mode_ = name.mode;
    return Set("mode", name.option, &field->What());
  }
  report_.Warn(field->What().extent,
               "unknown RenderMode " + Quoted(*word) + "; phong is used" + DidYouMean(*word, known));
}

// The course does not state where the two distances belong.
void GroningenReader::FindRange(Mapping& mapping) {
  if (auto found = mapping.Find({"near", "Near", "DistMin"})) near_ = found;
  if (auto found = mapping.Find({"far", "Far", "DistMax"})) far_ = found;
}

namespace {

bool IsNegative(const Field& field) {
  const auto [value, problem] = ParseNumber(field.What().scalar);
  return !problem && value < 0;
}

}  // namespace

// Without them, those of the image itself are used.
void GroningenReader::ReadZBuffer(Mapping& scene) {
  FindRange(scene);
  if (const auto field = scene.Find({"ZBuffer", "zbuffer"})) {
    if (auto zbuffer = field->AsMapping("a z-buffer")) {
      FindRange(*zbuffer);
      zbuffer->Finish();
    }
  }
  if (!near_ && !far_) return;
  if (!far_) return near_->Error("goes with far, which is missing");
  if (!near_) return far_->Error("goes with near, which is missing");
  if (mode_ != Mode::zbuffer && IsNegative(*near_))
    return report_.Warn(near_->What().extent, "ignoring a negative distance, which this image does not use");
  const auto near = near_->Number(not_negative), far = far_->Number(not_negative);
  if (!near || !far) return;
  if (!(*near < *far)) return far_->Error("must be greater than near, which is " + ToText(*near));
  Set("zbuffer_range", ToText(*near) + " " + ToText(*far), &near_->What());
}

// A width in pixels, or a switch for the lines. The course's reference image has none.
void GroningenReader::ReadOutline(Mapping& gooch) {
  constexpr double usual = 2;
  const auto field = gooch.Find({"outline"});
  if (!field) return;
  if (const Value& said = field->What(); !ParseNumber(said.scalar).problem) {
    if (const auto width = field->Number(not_negative)) Set("outline", ToText(*width), &said);
  } else if (const auto is_on = field->Bool()) {
    Set("outline", ToText(*is_on ? usual : 0.0), &said);
  }
}

void GroningenReader::ReadGooch(Mapping& scene) {
  // The defaults are those of the course's example.
  double b = 0.55, y = 0.3, alpha = 0.25, beta = 0.5;
  const auto field = scene.Find({"GoochParameters", "gooch", "Gooch"});
  if (!field && mode_ != Mode::gooch) return;
  if (field) {
    auto gooch = field->AsMapping("Gooch shading");
    if (!gooch) return;
    b = gooch->Number({"b"}, not_negative, b);
    y = gooch->Number({"y"}, not_negative, y);
    alpha = gooch->Number({"alpha"}, not_negative, alpha);
    beta = gooch->Number({"beta"}, not_negative, beta);
    ReadOutline(*gooch);
    gooch->Finish();
  }
  Set("gooch", ToText(b) + " " + ToText(y) + " " + ToText(alpha) + " " + ToText(beta),
      field ? &field->What() : nullptr);
}

}  // namespace ray
