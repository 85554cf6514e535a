#include "source/parse/scn/Command.h"
#include "R3/ShapeKind.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace ray {

#define COMMAND(name) extern const Command name##_command;
#include "source/parse/scn/commands.def"
#undef COMMAND

namespace {

std::vector<Command> AllCommands() {
  std::vector<Command> all{
#define COMMAND(name) name##_command,
#include "source/parse/scn/commands.def"
#undef COMMAND
  };
  for (const R3::ShapeKind* kind : R3::ShapeKinds()) all.push_back(ShapeCommand(*kind));
  for (const LightKind* kind : LightKinds()) all.push_back(LightCommand(*kind));
  return all;
}

std::map<std::string_view, const Command*> ByName() {
  std::map<std::string_view, const Command*> by_name;
  for (const Command& command : Commands()) by_name.emplace(command.name, &command);
  return by_name;
}

struct Foreign {
  std::string_view name, hint;
};

constexpr std::array foreign{
    Foreign{"obb", "use a box inside 'begin ... end' with a rotation"},
    Foreign{"group", "use 'begin mat_id', 16 matrix entries, ..., 'end'"},
    Foreign{"rect_light", "use an area_light, or two emissive triangles"},
    Foreign{"particle", "particles are not supported"},
    Foreign{"particle_source", "particles are not supported"},
    Foreign{"particle_sink", "particles are not supported"},
    Foreign{"particle_gravity", "particles are not supported"},
    Foreign{"particle_spring", "particles are not supported"},
};

constexpr std::string_view shapes_of_triangles = "use a tri for each triangle, or a mesh with a file";
constexpr std::string_view kinds_of_lights =
    "lights are area_light, dir_light, point_light, sphere_light and spot_light";
constexpr std::string_view with_matrix = "use 'begin mat_id', a 4x4 matrix in rows, shapes, 'end'";
constexpr std::string_view behind_begin =
    "translate, rotate, scale and look_at stand behind begin: 'begin mat_id rotate 45 0 1 0', shapes, 'end'";
constexpr std::string_view behind_camera = "use 'camera look_at ex ey ez tx ty tz ux uy uz fov', in degrees";
constexpr std::string_view with_material = "use 'material', and its number behind the word of a shape";
constexpr std::string_view size_setting = "use 'set width n' and 'set height n', or the options";
constexpr std::string_view of_pbrt = "this looks like a scene of pbrt; raypro -list scenes lists what can be read";

/// Words of other programs' scenes, with our command or a phrase.
constexpr std::array elsewhere{
    Foreign{"triangle", "tri"},
    Foreign{"rectangle", shapes_of_triangles},
    Foreign{"square", shapes_of_triangles},
    Foreign{"ball", "sphere"},
    Foreign{"cube", "box"},
    Foreign{"disk", "use a flat cylinder"},
    Foreign{"ellipsoid", "use a sphere inside 'begin ... end' with a scale"},
    Foreign{"floor", "plane"},
    Foreign{"ground", "plane"},
    Foreign{"model", "mesh"},
    Foreign{"obj", "mesh"},
    Foreign{"object", "mesh"},
    Foreign{"trimesh", "mesh"},
    Foreign{"emitter", kinds_of_lights},
    Foreign{"lamp", kinds_of_lights},
    Foreign{"light", kinds_of_lights},
    Foreign{"light_source", kinds_of_lights},
    Foreign{"lightsource", kinds_of_lights},
    Foreign{"ambient_light", "ambient"},
    Foreign{"directional_light", "dir_light"},
    Foreign{"distant_light", "dir_light"},
    Foreign{"sun", "dir_light"},
    Foreign{"matrix", with_matrix},
    Foreign{"rotate", behind_begin},
    Foreign{"transform", with_matrix},
    Foreign{"scale", behind_begin},
    Foreign{"translate", behind_begin},
    Foreign{"color", with_material},
    Foreign{"colour", with_material},
    Foreign{"diffuse", with_material},
    Foreign{"mtl", with_material},
    Foreign{"pigment", with_material},
    Foreign{"shininess", with_material},
    Foreign{"specular", with_material},
    Foreign{"texture", "a texture is the last word of 'material'"},
    Foreign{"eye", "camera"},
    Foreign{"fov", "the field of view is the half angle of 'camera', in radians"},
    Foreign{"lookat", behind_camera},
    Foreign{"look_at", behind_camera},
    Foreign{"perspective", "camera"},
    Foreign{"film", size_setting},
    Foreign{"image", size_setting},
    Foreign{"resolution", size_setting},
    Foreign{"size", size_setting},
    Foreign{"depth", "use 'set max_depth n', or the option"},
    Foreign{"max_depth", "use 'set max_depth n', or the option"},
    Foreign{"maxdepth", "use 'set max_depth n', or the option"},
    Foreign{"samples", "use 'set samples n', or the option"},
    Foreign{"spp", "use 'set samples n', or the option"},
    Foreign{"output", "the image is named on the command line"},
    Foreign{"envmap", "environment"},
    Foreign{"sky", "environment"},
    Foreign{"skybox", "environment"},
    Foreign{"import", "include"},
    Foreign{"AttributeBegin", of_pbrt},
    Foreign{"Film", of_pbrt},
    Foreign{"Integrator", of_pbrt},
    Foreign{"LookAt", of_pbrt},
    Foreign{"Sampler", of_pbrt},
    Foreign{"Shape", of_pbrt},
    Foreign{"WorldBegin", of_pbrt},
};

constexpr std::array comments_elsewhere{"//", "/*", ";", "%", "--"};

}  // namespace

std::span<const Command> Commands() {
  static const std::vector<Command> all = AllCommands();
  return all;
}

const Command* FindCommand(std::string_view name) {
  static const std::map<std::string_view, const Command*> by_name = ByName();
  const auto found = by_name.find(name);
  return found == by_name.end() ? nullptr : found->second;
}

std::span<const std::string_view> CommandNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> sorted;
    for (const Command& command : Commands()) sorted.push_back(command.name);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }();
  return names;
}

std::string_view ForeignHint(std::string_view name) {
  const auto found = std::find_if(foreign.begin(), foreign.end(), [&](const Foreign& f) { return f.name == name; });
  return found == foreign.end() ? std::string_view{} : found->hint;
}

std::string HintForOtherPrograms(std::string_view word) {
  if (std::ranges::any_of(comments_elsewhere, [&](std::string_view begin) { return word.starts_with(begin); }))
    return "a comment begins with #";
  const auto found = std::ranges::find(elsewhere, word, &Foreign::name);
  if (found == elsewhere.end()) return {};
  const Command* const ours = FindCommand(found->hint);
  return ours ? "did you mean '" + ours->name + "'? usage: " + ours->usage : std::string(found->hint);
}

std::string SurplusHint(const Command& command) {
  // The form with an axis is a student's; see the manual's list of dialects.
  const char* const axis = command.name == "cylinder" ? "; the axis is y, rotate with 'begin ... end'" : "";
  return "usage: " + command.usage + axis;
}

std::string ArgumentNames(std::span<const R3::Argument> arguments) {
  constexpr std::size_t most_named = 24, ends = 3;  // of more, as the corners of a patch, the first and the last
  std::string names;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_middle = arguments.size() > most_named && i >= ends && i + ends < arguments.size();
    if (!is_middle)
      names += std::string(" ") + arguments[i].name;
    else if (i == ends)
      names += " ...";
  }
  return names;
}

std::string ArgumentNames(const R3::ShapeKind& kind) {
  return ArgumentNames(kind.arguments) + (kind.repeated > 0 ? " ..." : "");
}

}  // namespace ray
