#include "source/parse/scn/Command.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "R1/Kinds.h"
#include "R3/ShapeKind.h"

namespace ray {
namespace {

std::map<std::string_view, const Command*> ByName() {
  std::map<std::string_view, const Command*> by_name;
  for (const Command& command : Commands()) by_name.emplace(command.name, &command);
  return by_name;
}

struct Foreign {
  std::string_view name, hint;
};

constexpr std::array foreign{
    Foreign{"triangle", "did you mean 'tri'? usage: tri mat_id x1 y1 z1 x2 y2 z2 x3 y3 z3"},
    Foreign{"obb", "use a box inside 'begin ... end' with a rotation"},
    Foreign{"group", "use 'begin mat_id', 16 matrix entries, ..., 'end'"},
    Foreign{"rect_light", "use an area_light, or two emissive triangles"},
    Foreign{"particle", "particles are not supported"},
    Foreign{"particle_source", "particles are not supported"},
    Foreign{"particle_sink", "particles are not supported"},
    Foreign{"particle_gravity", "particles are not supported"},
    Foreign{"particle_spring", "particles are not supported"},
};

}  // namespace

std::span<const Command> Commands() {
#define COMMAND(name) *KIND(Command, name##_command),
  static const std::vector<Command> all = [] {
    std::vector<Command> commands{
#include "source/parse/scn/commands.def"
    };
    for (const R3::ShapeKind* kind : R3::ShapeKinds()) commands.push_back(ShapeCommand(*kind));
    for (const LightKind* kind : LightKinds()) commands.push_back(LightCommand(*kind));
    return commands;
  }();
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

std::string SurplusHint(const Command& command) {
  // The form with an axis is used by a student's program; see the manual's list of dialects.
  const char* const axis = command.name == "cylinder" ? "; the axis is y, rotate with 'begin ... end'" : "";
  return "usage: " + command.usage + axis;
}

std::string ArgumentNames(std::span<const R3::Argument> arguments) {
  constexpr std::size_t most_named = 24, ends = 3;  // of more, as for the corners of a patch, the first and the last
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
