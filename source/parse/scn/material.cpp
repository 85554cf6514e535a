#include <cmath>

#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

constexpr auto material_arguments =
    R3::ArgumentsFromZero("ka_r", "ka_g", "ka_b", "kd_r", "kd_g", "kd_b", "ks_r", "ks_g", "ks_b", "kt_r", "kt_g",
                          "kt_b", "e_r", "e_g", "e_b", "n", "ir");

void SetNumbers(Material& material, const std::vector<double>& a) {
  material.ka = {a[0], a[1], a[2]};
  material.kd = {a[3], a[4], a[5]};
  material.ks = material.kr = {a[6], a[7], a[8]};
  material.kt = {a[9], a[10], a[11]};
  material.emission = {a[12], a[13], a[14]};
  material.n = a[15];
  material.ir = a[16] > 0 ? a[16] : 1;  // files of 2008 write 0 and mean no refraction
}

void ReadMaterial(ScnReader& reader, Statement& statement) {
  // Reserved first, so that a material with mistakes also has its id, and no further error is reported where the id is
  // used.
  Material& material = reader.NewMaterial();
  SetNumbers(material, statement.Numbers(material_arguments).values);
  const FileWord texture = statement.FileName("texture");
  if (texture.word.text == "0") return;
  reader.WithFile(statement, texture.word, [&] {
    material.texture = reader.Library().Image(texture.name, reader.CurrentFile(), Assets::Use::color);
  });
}

constexpr auto channels_of_color = R3::ArgumentsFromZero("r", "g", "b");

/// Reads a command that gives a material one more color.
template <auto member>
void ReadColorOfMaterial(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  const auto a = statement.Numbers(channels_of_color).values;
  if (material && statement.IsGood()) material->*member = R2::Color{a[0], a[1], a[2]};
}

constexpr auto priority_argument = R3::ArgumentsNamed("priority");

/// Reads an extension: the priority of a material where solids overlap.
void ReadPriority(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  const Arguments priority = statement.Numbers(priority_argument);
  if (!material || !statement.IsGood()) return;
  const double value = priority.values[0];
  if (!(std::abs(value) <= Material::most_priority && value == std::floor(value)))
    return statement.Error(priority.words[0],
                           "priority must be a whole number from -" + std::to_string(Material::most_priority) + " to " +
                               std::to_string(Material::most_priority) + ", got " + Escaped(priority.words[0].text));
  if (material->priority != 0 && material->priority != value)
    reader.Warn(statement, "the material already has the priority " + std::to_string(material->priority) +
                               "; the last one counts");
  material->priority = static_cast<int>(value);
}

constexpr auto coat_index = R3::ArgumentsNamed("ir");

/// Reads an extension: a clear coat over the diffuse layer.
void ReadCoat(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  const Arguments index = statement.Numbers(coat_index);
  if (!material || !statement.IsGood()) return;
  if (!(index.values[0] > 0))
    return statement.Error(index.words[0], "ir must be positive, got " + Escaped(index.words[0].text));
  material->coat = index.values[0];
}

/// Reads an extension that sets a property of a material by its name alone, such as one_sided.
template <auto member>
void ReadSwitchOfMaterial(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  if (material && statement.IsGood()) material->*member = true;
}

constexpr auto repetitions = R3::ArgumentsNamed("su", "sv");

/// Reads an extension: the number of repetitions of images over texture coordinates from 0 to 1.
void ReadTextureScale(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  const Arguments scale = statement.Coordinates(repetitions);
  for (std::size_t i = 0; i < scale.values.size(); ++i)
    if (!(scale.values[i] > 0))
      statement.Error(scale.words[i],
                      std::string(repetitions[i].name) + " must be positive, got " + Escaped(scale.words[i].text));
  if (material && statement.IsGood()) material->texture_scale = {scale.values[0], scale.values[1]};
}

constexpr auto height = R3::ArgumentsNamed("height");

/// Reads an extension: the luminance of an image, times a height, is the apparent elevation of the surface.
void ReadBump(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  const FileWord file = statement.FileName();
  const double most = statement.Numbers(height).values[0];
  if (!material) return;
  reader.WithFile(statement, file.word,
                  [&] { material->bump = reader.Library().Image(file.name, reader.CurrentFile(), Assets::Use::data); });
  material->bump_height = most;
  if (most == 0) material->bump = nullptr;  // flat
}

/// Reads an extension that gives a material one more image.
template <auto member, Assets::Use use>
void ReadMapOfMaterial(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  const FileWord file = statement.FileName();
  if (!material) return;
  reader.WithFile(statement, file.word,
                  [&] { material->*member = reader.Library().Image(file.name, reader.CurrentFile(), use); });
}

constexpr auto gloss_arguments = R3::ArgumentsNamed("exponent", "samples");

/// Reads an extension: reflections that are blurred regardless of the settings.
void ReadGloss(ScnReader& reader, Statement& statement) {
  Material* material = reader.ReadOwnMaterial(statement);
  const Arguments gloss = statement.Numbers(gloss_arguments);
  const double exponent = gloss.values[0], samples = gloss.values[1];
  if (!material || !statement.IsGood()) return;
  if (!(exponent > 0))
    return statement.Error(gloss.words[0], "exponent must be positive, got " + Escaped(gloss.words[0].text));
  if (!(samples >= 1 && samples <= Material::most_gloss_samples && samples == std::floor(samples)))
    return statement.Error(gloss.words[1], "samples must be a whole number from 1 to " +
                                               std::to_string(Material::most_gloss_samples) + ", got " +
                                               Escaped(gloss.words[1].text));
  material->gloss = exponent;
  material->gloss_samples = static_cast<int>(samples);
}

}  // namespace

extern const Command normal_map_command{
    "normal_map", "normal_map mat_id file",
    "normal map in tangent space: red along u, green along v, blue outward, each 2 c - 1",
    ReadMapOfMaterial<&Material::normal_map, Assets::Use::data>};
extern const Command specular_map_command{"specular_map", "specular_map mat_id file",
                                          "an image multiplies ks and the weight of the mirrored ray",
                                          ReadMapOfMaterial<&Material::specular_map, Assets::Use::color>};
extern const Command gloss_command{
    "gloss", "gloss mat_id exponent samples",
    "blurs reflections over a Phong lobe of that exponent; samples are the rays per reflection in mode whitted",
    ReadGloss};
extern const Command bump_command{"bump", "bump mat_id file height", "bump map: the luminance of an image times height",
                                  ReadBump};
extern const Command mirror_command{"mirror", "mirror mat_id r g b", "weight of the mirrored ray, if it is not ks",
                                    ReadColorOfMaterial<&Material::kr>};
extern const Command absorb_command{"absorb", "absorb mat_id r g b",
                                    "absorption in closed solids: light is scaled by exp(-r d), exp(-g d), exp(-b d) "
                                    "over a distance d inside",
                                    ReadColorOfMaterial<&Material::absorb>};
extern const Command priority_command{"priority", "priority mat_id n",
                                      "where clear solids overlap, the material with the highest priority fills the "
                                      "place, by default 0; among equals the "
                                      "first solid of the file refracts and all of them absorb",
                                      ReadPriority};
extern const Command coat_command{
    "coat", "coat mat_id ir",
    "a clear coat with that index of refraction over the diffuse layer; it reflects more towards grazing angles",
    ReadCoat};
extern const Command flat_color_command{
    "flat_color", "flat_color mat_id r g b",
    "color in mode flat, times the texture; by default kd (times the texture), the mirror's weight and kt together",
    ReadColorOfMaterial<&Material::color>};
extern const Command texture_ambient_command{"texture_ambient", "texture_ambient mat_id",
                                             "the material's texture multiplies ka as well as kd",
                                             ReadSwitchOfMaterial<&Material::texture_multiplies_ka>};
extern const Command texture_scale_command{
    "texture_scale", "texture_scale mat_id su sv",
    "repetitions of all images of the material where u and v run from 0 to 1 (default 1 1)", ReadTextureScale};
extern const Command texture_project_command{
    "texture_project", "texture_project mat_id",
    "images are projected onto polygons and meshes without texture coordinates, from the side each triangle faces "
    "most, once per unit of length",
    ReadSwitchOfMaterial<&Material::projects_textures>};
extern const Command vertex_colors_command{
    "vertex_colors", "vertex_colors mat_id",
    "the colors that a mesh gives to its vertices multiply kd, and ka with 'texture_ambient'",
    ReadSwitchOfMaterial<&Material::has_vertex_colors>};
extern const Command one_sided_command{"one_sided", "one_sided mat_id",
                                       "surfaces exist only for rays that arrive at their front; others pass through",
                                       ReadSwitchOfMaterial<&Material::one_sided>};
extern const Command material_command{
    "material", "material" + ArgumentNames(material_arguments) + " texture",
    "ambient, diffuse, specular, transmission, emission, Phong exponent, index of refraction, image file or 0; ids "
    "count from 0 in each file",
    ReadMaterial};

}  // namespace ray
