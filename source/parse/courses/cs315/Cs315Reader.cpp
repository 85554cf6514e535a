#include "source/parse/courses/cs315/Cs315Reader.h"

#include <array>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Placement.h"
#include "source/parse/Format.h"
#include "source/parse/courses/objects/SharedKeys.h"
#include "source/text/NumberText.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

Scene ReadCs315(const ParseOptions& options, const Document& document, Assets& assets, Report& report) {
  return Cs315Reader(options, document, assets, report).Read();
}

}  // namespace

extern const SceneFormat cs315_scene_format{
    .name = "cs315",
    .extensions = {".json"},
    .about = "CS 315, JSON",
    .read_document = ReadCs315,
    .keys = {"camera", "lights", "materials", "surfaces"},
};

Scene Cs315Reader::Read() {
  auto scene = Field(report_, report_.Source().Root()).AsMapping("a scene");
  if (!scene) return {};
  Made().files.push_back(report_.Source().Source().name);
  for (const auto& [option, value] : {std::pair{"width", "512"},
                                      {"height", "512"},
                                      {"samples", "1"},
                                      {"sampler", "grid"},
                                      {"bytes", "truncated"},
                                      {"min_luminance", "0"}})
    Set(option, value);
  const auto depth = scene->Find({"bounce_depth"});
  const auto bounces = depth ? depth->Whole(0, std::numeric_limits<int>::max()) : std::nullopt;
  Set("max_depth", ToText(bounces.value_or(0)), depth ? &depth->What() : nullptr);
  constexpr double usual_bias = 0.0001;  // in most of the course's files, if one states none
  Made().shadow_bias = scene->Number({"shadow_bias"}, not_negative, usual_bias);
  ReadCamera(*scene);
  const auto each = [&](const char* key, void (Cs315Reader::*read)(const Field&)) {
    const auto field = scene->Find({key});
    const auto list = field ? field->List() : std::nullopt;
    if (!list) return;
    for (const Field& one : *list) (this->*read)(one);
  };
  each("lights", &Cs315Reader::ReadLight);
  each("materials", &Cs315Reader::ReadMaterial);
  each("surfaces", &Cs315Reader::ReadSurface);
  Made().background = scene->Color({"background"}, {});
  scene->Ignore({"name", "comment", "include"});
  scene->Finish();
  objects_.Builder().has_camera = objects_.Builder().has_light = true;
  return objects_.Finish();
}

void Cs315Reader::Set(const std::string& option, const std::string& value, const Value* said) {
  Made().settings.push_back({option, value, said ? report_.PlaceOf(said->extent) : "CS 315"});
}

// The angle is vertical. `aspect` is the ratio of width to height, independent of the pixels.
void Cs315Reader::ReadCamera(Mapping& scene) {
  const auto field = scene.Need({"camera"});
  auto camera = field ? field->AsMapping("a camera") : std::nullopt;
  if (!camera) return;
  const R3::Point eye = camera->NeedPoint({"eye"}), at = camera->NeedPoint({"at"});
  const R3::Vector up = camera->NeedVector({"up"});
  const auto fovy = camera->Need({"fovy"});
  const double degrees = fovy ? fovy->Number().value_or(0) : 0;
  if (fovy && camera->IsGood() && !(degrees > 0 && degrees < 180))
    fovy->Error("must be between 0 and 180 degrees, got " + Escaped(fovy->What().scalar));
  const double aspect = camera->Number({"aspect"}, positive, 1);
  if (const auto radius = camera->Find({"aperture"}))
    if (const auto lens = radius->Number(not_negative)) Set("aperture", ToText(*lens), &radius->What());
  exposure_time_ = camera->Number({"exposureTime"}, not_negative, exposure_time_);
  for (Mapping* mapping : {&scene, &*camera})  // students' programs read it from either
    if (const auto depth = mapping->Find({"focal_depth"}))
      if (const auto focus = depth->Number(positive)) Set("focus", ToText(*focus), &depth->What());
  Camera projected;
  ReadProjection(*camera, projected);
  camera->Ignore({"name", "comment"});
  if (!camera->FinishedWell()) return;
  if (eye == at) return report_.Error(camera->What(), "has its eye at the point that it looks at");
  const AimedCamera aimed = Aim(eye, at - eye, up);
  if (aimed.up_was_replaced) return report_.Error(camera->What(), "has an up vector along the view direction");
  Made().camera = aimed.camera;
  Made().camera.TakeViewOf(projected);
  Made().camera.aspect = aspect;
  Made().camera.xfov = R1::Atan(aspect * R1::Tan(degrees / 2 * std::numbers::pi / 180));
}

// Ambient, Point and Directional are the course's; all except Ambient and Environment are also kinds of ours.
void Cs315Reader::ReadLight(const Field& field) {
  static const std::vector<std::string_view> sources{"Point",  "Directional", "Spot",       "Area",
                                                     "Sphere", "Ambient",     "Environment"};
  constexpr std::size_t ambient = 5, environment = 6;
  auto light = field.AsMapping("a light");
  if (!light) return;
  light->Ignore({"name", "comment"});
  const auto source = light->Need({"source"});
  if (!source) return light->Finish();
  const std::size_t which = source->Choice(sources, "sources").value_or(sources.size());
  if (which < ambient) {
    if (auto read = ray::ReadLight(which, *light)) Made().lights.push_back(std::move(read));
  } else if (which == ambient) {
    Made().ambient += light->NeedColor({"color"});
    light->Finish();
  } else if (which == environment) {
    if (const auto file = light->Need({"file"})) Made().environment = objects_.EnvironmentNamed(*file);
    light->Finish();
  }
}

// Reserved first, so that a material with mistakes also has its index.
void Cs315Reader::ReadMaterial(const Field& field) {
  materials_.push_back(static_cast<int>(Made().materials.size()));
  Material& read = Made().materials.emplace_back();
  auto material = field.AsMapping("a material");
  if (!material) return;
  const R2::Color black;
  read.ka = material->Color({"ka"}, black);
  read.kd = material->Color({"kd"}, black);
  read.ks = material->Color({"ks"}, black);
  read.kr = material->Color({"kr"}, black);
  read.kt = material->Color({"kt"}, black);
  read.emission = material->Color({"emission"}, black);
  read.n = material->Number({"shininess"}, not_negative, 0);
  if (read.n == 0) read.ks = black;  // the course's rule: no highlight, instead of one everywhere
  read.ir = material->Number({"ior"}, positive, 1);
  if (const auto texture = material->Find({"texture"})) read.texture = objects_.Image(*texture, Assets::Use::color);
  if (const auto map = material->Find({"normal_map"})) read.normal_map = objects_.Image(*map, Assets::Use::data);
  if (const auto bump = material->Find({"bump"})) {
    read.bump = objects_.Image(*bump, Assets::Use::data);
    read.bump_height = material->Number({"bump_height"}, any_number, 1);
  }
  ReadGloss(*material, {"gloss"}, {"gloss_samples"}, read);
  material->Ignore({"name", "comment"});
  material->Finish();
}

void Cs315Reader::ReadSurface(const Field& field) {
  auto first = field.AsMapping("a surface");
  if (!first) return;
  const auto shape = first->Need({"shape"});
  const auto name = shape ? shape->Word() : std::nullopt;
  if (!name) return first->Finish();
  std::vector<std::string_view> shapes{"Sphere", "Triangle", "csg"};
  const auto kinds = ObjectReader::Kinds();
  shapes.insert(shapes.end(), kinds.begin(), kinds.end());
  if (std::find(shapes.begin(), shapes.end(), *name) == shapes.end())
    return shape->Error("is unknown: " + Quoted(*name), Suggestion(*name, shapes, "shapes"));

  Mapping surface(report_, field.What(), "a " + *name);
  surface.Ignore({"shape", "name", "comment"});
  const auto material = surface.Need({"material"});
  const auto index = material ? material->Whole(0, std::numeric_limits<int>::max()) : std::nullopt;
  const bool is_known = index && *index < static_cast<std::int64_t>(materials_.size());
  if (index && !is_known)
    material->Error("must be an index into materials, of which there are " + std::to_string(materials_.size()) +
                    ", got " + ToText(*index));
  const int used = is_known ? materials_[static_cast<std::size_t>(*index)] : 0;
  std::optional<R3::Matrix> transform;
  if (const auto transforms = surface.Find({"transforms"})) transform = ReadTransforms(*transforms);
  const R3::Vector way = exposure_time_ * surface.Vector({"velocity"}).value_or(R3::Vector{});
  if (*name == "csg")
    return objects_.AddCsg(surface, "surfaces", transform, way, used, [this](const Field& part) { ReadSurface(part); });
  const Material& look = Made().materials[static_cast<std::size_t>(used)];
  const bool has_texture = look.texture || look.bump || look.normal_map;
  auto placed = ReadShape(*name, surface, has_texture);
  surface.Finish();
  if (placed && surface.IsGood()) objects_.Add(surface, std::move(*placed), transform, way, used);
}

std::optional<PlacedShape> Cs315Reader::ReadShape(const std::string& name, Mapping& surface, bool has_texture) {
  const std::string_view kind = name == "Sphere" ? "sphere" : name == "Triangle" ? "triangle" : std::string_view(name);
  return objects_.Read(kind, surface, has_texture);
}

std::optional<R3::Matrix> Cs315Reader::ReadTransforms(const Field& field) {
  const auto list = field.List();
  if (!list || list->empty()) return {};
  R3::Matrix product;
  for (const Field& one : *list)
    if (const auto transform = ReadTransform(one)) product = product * *transform;
  return product;
}

std::optional<R3::Matrix> Cs315Reader::ReadTransform(const Field& field) {
  static constexpr std::array<std::string_view, 3> names{"Translate", "Rotate", "Scale"};
  const auto both = field.ListOf(2, "a list of a name and three numbers");
  if (!both) return {};
  const auto name = (*both)[0].Choice(names, "transforms");
  const auto v = (*both)[1].Vector();
  if (!name || !v) return {};
  if (*name == 0) return Translation(*v);
  if (*name == 1) return R3::RotationAbout(0, v->x) * R3::RotationAbout(1, v->y) * R3::RotationAbout(2, v->z);
  if (v->x == 0 || v->y == 0 || v->z == 0) {
    (*both)[1].Error("must not have a factor of 0: nothing would be left");
    return {};
  }
  return Scaling(*v);
}

}  // namespace ray
