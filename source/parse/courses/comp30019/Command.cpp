#include "source/parse/courses/comp30019/Command.h"

#include <algorithm>
#include <array>

namespace ray::comp30019 {

void ReadMaterial(Reader& reader, Line& line);
void ReadPointLight(Reader& reader, Line& line);
void ReadPlane(Reader& reader, Line& line);
void ReadSphere(Reader& reader, Line& line);
void ReadTriangle(Reader& reader, Line& line);
void ReadObjModel(Reader& reader, Line& line);

namespace {

constexpr std::array commands{
    Command{"Material", "Material \"name\" kind (r, g, b) index", ReadMaterial},
    Command{"PointLight", "PointLight \"name\" (x, y, z) (r, g, b)", ReadPointLight},
    Command{"Plane", "Plane \"name\" (x, y, z) (x, y, z) \"material\"", ReadPlane},
    Command{"Sphere", "Sphere \"name\" (x, y, z) radius \"material\"", ReadSphere},
    Command{"Triangle", "Triangle \"name\" (x, y, z) (x, y, z) (x, y, z) \"material\"", ReadTriangle},
    Command{"ObjModel", "ObjModel \"name\" \"file\" (x, y, z) scale \"material\"", ReadObjModel},
};

constexpr auto command_names = [] {
  std::array<std::string_view, commands.size()> all;
  std::ranges::transform(commands, all.begin(), &Command::name);
  return all;
}();

}  // namespace

const Command* FindCommand(std::string_view name) {
  const auto found = std::ranges::find(commands, name, &Command::name);
  return found == commands.end() ? nullptr : &*found;
}

std::span<const std::string_view> CommandNames() { return command_names; }

}  // namespace ray::comp30019
