#include <array>

#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

constexpr bool not_negative = false;

const std::array<R3::Argument, 17> arguments{{
    {"ka_r", not_negative}, {"ka_g", not_negative}, {"ka_b", not_negative},  //
    {"kd_r", not_negative}, {"kd_g", not_negative}, {"kd_b", not_negative},  //
    {"ks_r", not_negative}, {"ks_g", not_negative}, {"ks_b", not_negative},  //
    {"kt_r", not_negative}, {"kt_g", not_negative}, {"kt_b", not_negative},  //
    {"e_r", not_negative},  {"e_g", not_negative},  {"e_b", not_negative},   //
    {"n", not_negative},    {"ir", not_negative},
}};

void SetNumbers(Material& material, const std::vector<double>& a) {
  material.ka = {a[0], a[1], a[2]};
  material.kd = {a[3], a[4], a[5]};
  material.ks = {a[6], a[7], a[8]};
  material.kt = {a[9], a[10], a[11]};
  material.emission = {a[12], a[13], a[14]};
  material.n = a[15];
  material.ir = a[16] > 0 ? a[16] : 1;  // files of 2008 write 0 and mean no refraction
}

void ReadMaterial(ScnReader& reader, Statement& statement) {
  // First of all, so that one with mistakes has its id too, and no error is reported again wherever the id is used.
  Material& material = reader.NewMaterial();
  SetNumbers(material, statement.Numbers(arguments).values);
  const Token texture = statement.Word("texture");
  if (texture.text == "0") return;
  reader.WithFile(statement, texture, [&] {
    material.texture = reader.Library().Image(std::string(texture.text), reader.CurrentFile());
  });
}

}  // namespace

extern const Command material_command{"material", "material" + ArgumentNames(arguments) + " texture", ReadMaterial};

}  // namespace ray
