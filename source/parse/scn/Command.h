#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "R3/ShapeKind.h"
#include "source/scene/Light.h"

namespace ray {

class ScnReader;
class Statement;

/// A word of the .scn language that starts a statement.
struct Command {
  std::string name;
  std::string usage;  // "sphere mat_id cx cy cz radius"
  std::string about;  // one line for the manual
  std::function<void(ScnReader&, Statement&)> read;
};

/// Returns one command per line of commands.def, of shapes.def and of lights.def.
std::span<const Command> Commands();
/// Returns the command with the given name, case-sensitive, or null.
const Command* FindCommand(std::string_view name);
/// Returns the sorted names.
std::span<const std::string_view> CommandNames();
/// Returns a hint about extra numbers after the last one that the command takes.
std::string SurplusHint(const Command& command);
/// Returns the replacement for a command of another dialect or a later assignment; empty for any other word.
std::string_view ForeignHint(std::string_view name);

Command ShapeCommand(const R3::ShapeKind& kind);
Command LightCommand(const LightKind& kind);

/// Returns " cx cy cz radius".
std::string ArgumentNames(std::span<const R3::Argument> arguments);
/// Returns the names of a shape's arguments, with " ..." after those that may be repeated.
std::string ArgumentNames(const R3::ShapeKind& kind);

}  // namespace ray
