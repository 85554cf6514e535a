#include "R3/Placement.h"
#include "source/parse/courses/groningen/GroningenReader.h"
#include "source/parse/courses/objects/SharedKeys.h"
#include "source/text/Words.h"

namespace ray {

void GroningenReader::ReadLights(Mapping& scene) {
  const auto field = scene.Find({"Lights", "lights"});
  const auto lights = field ? field->List() : std::nullopt;
  if (!lights) return;
  for (const Field& light : *lights) ReadLight(light);
}

// Each light adds its color to the factor of ka, in shadow or not. The course has point lights only.
void GroningenReader::ReadLight(const Field& field) {
  auto light = field.AsMapping("a light");
  if (!light) return;
  light->Ignore({"comment", "name"});
  const auto type = light->Find({"type"});
  const auto which = type ? type->Choice(LightNames(), "lights") : std::optional<std::size_t>(0);
  if (!which) return;
  auto read = ray::ReadLight(*which, *light);
  if (!read) return;
  Made().ambient += light->Color({"color", "colour"}, {});
  Made().lights.push_back(std::move(read));
}

void GroningenReader::ReadObjects(Mapping& scene) {
  const auto field = scene.Need({"Objects"});
  const auto objects = field ? field->List() : std::nullopt;
  if (!objects) return;
  for (const Field& object : *objects) ReadObject(object);
}

void GroningenReader::ReadObject(const Field& field) {
  auto object = field.AsMapping("an object");
  if (!object) return;
  const auto type = object->Need({"type"});
  const auto kind = type ? type->Word() : std::nullopt;
  if (!kind) return object->Finish();
  if (*kind == "csg") return ReadCsg(*object);
  if (!ObjectReader::IsKind(*kind)) {
    const auto kinds = ObjectReader::Kinds();
    return report_.Warn(type->What().extent, "type " + Quoted(*kind) + " is not supported; the object is skipped" +
                                                 DidYouMean(*kind, {kinds.begin(), kinds.end()}));
  }
  Mapping named(report_, object->What(), "a " + *kind);
  const int material = ReadMaterial(named);
  const Material& used = Made().materials[static_cast<std::size_t>(material)];
  const bool wants_uv = used.texture || used.specular_map || used.bump || used.normal_map || mode_ == Mode::uv;
  auto placed = objects_.Read(*kind, named, wants_uv);
  const R3::Vector motion = ReadMotion(named);
  named.Ignore({"type", "comment", "name"});
  named.Finish();
  if (placed && named.IsGood()) objects_.Add(named, std::move(*placed), StartOf(motion), motion, material);
}

// An extension: a solid made of the solids in its list.
void GroningenReader::ReadCsg(Mapping& object) {
  Mapping named(report_, object.What(), "a csg");
  const int material = named.Has({"material"}) ? ReadMaterial(named) : Node::inherit;
  const R3::Vector motion = ReadMotion(named);
  named.Ignore({"type", "comment", "name"});
  objects_.AddCsg(named, "objects", StartOf(motion), motion, material, [this](const Field& part) { ReadObject(part); });
}

R3::Vector GroningenReader::ReadMotion(Mapping& object) const {
  return exposure_time_ * object.Vector({"velocity"}).value_or(R3::Vector{});
}

// The object is at its stated position in the middle of the exposure.
std::optional<R3::Matrix> GroningenReader::StartOf(const R3::Vector& motion) {
  if (motion == R3::Vector{}) return {};
  return Translation(-0.5 * motion);
}

int GroningenReader::ReadMaterial(Mapping& object) {
  Material read;
  const auto texture_of_object = object.Find({"texture"});
  const auto normals_of_object = object.Find({"normals"});
  if (object.Word({"specular"}).value_or("none") != "none") object.NotSupported({"specular"});
  const auto field = object.Need({"material"});
  auto material = field ? field->AsMapping("a material") : std::nullopt;
  if (material) {
    auto texture = material->Find({"texture"});
    if (!texture) texture = texture_of_object;
    const auto name = texture ? texture->Word() : std::nullopt;
    if (name && *name != "none") {
      read.texture = objects_.Image(*texture, Assets::Use::color);
      read.texture_multiplies_ka = true;
    }
    ReadColors(*material, name && *name != "none", read);
    auto normals = material->Find({"normalMap"});
    if (!normals) normals = normals_of_object;
    const auto map = normals ? normals->Word() : std::nullopt;
    if (map && *map != "none") read.normal_map = objects_.Image(*normals, Assets::Use::data);
    ReadGloss(*material, {"gloss"}, {"glossSamples"}, read);
    const auto specular = material->Find({"specularMap"});
    const auto specular_name = specular ? specular->Word() : std::nullopt;
    if (specular_name && *specular_name != "none") read.specular_map = objects_.Image(*specular, Assets::Use::color);
    material->Ignore({"comment", "name"});
    material->Finish();
  }
  Made().materials.push_back(std::move(read));
  return static_cast<int>(Made().materials.size()) - 1;
}

// The coefficients are gray. Missing ones are 0, and the exponent 1.
void GroningenReader::ReadColors(Mapping& material, bool has_texture, Material& read) {
  const R2::Color white{1, 1, 1};
  R2::Color color = white;
  if (has_texture)
    material.Ignore({"color", "colour"});
  else
    color = material.NeedColor({"color", "colour"});
  const double ka = material.Number({"ka", "ambient"}, not_negative, 0);
  const double kd = material.Number({"kd", "diffuse"}, not_negative, 0);
  const double ks = material.Number({"ks", "specular"}, not_negative, 0);
  const double kt = material.Number({"refract", "kt"}, not_negative, 0);
  const double index = material.Number({"eta", "index", "refractive_index"}, not_negative, 1);
  read.n = material.Number({"n", "shininess"}, not_negative, 1);
  read.ka = ka * color;
  read.kd = kd * color;
  read.ks = read.kr = ks * white;
  read.kt = kt * white;
  read.ir = index > 0 ? index : 1;
  read.color = color;
  if (const auto bump = material.Find({"bump"})) {
    read.bump = objects_.Image(*bump, Assets::Use::data);
    read.bump_height = material.Number({"bumpHeight"}, any_number, 1);
  }
}

}  // namespace ray
