#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

/// An extension: a setting for this scene, which command lines override.
void ReadSet(ScnReader& reader, Statement& statement) {
  const Token option = statement.Word("option");
  std::string value;
  for (const Token& word : statement.RestOfLine()) value += (value.empty() ? "" : " ") + std::string(word.text);
  SceneSetting setting{std::string(option.text), value, reader.PlaceOf(option)};
  if (auto problem = reader.ProblemOf(setting)) return statement.Error(option, problem->message, problem->hint);
  if (value.empty()) return statement.Error(option, "set: value is missing", statement.What().usage);
  reader.Builder().scene.settings.push_back(std::move(setting));
}

}  // namespace

extern const Command set_command{
    "set", "set option value",
    "a setting of this scene, by the name of the option that overrides it; the value ends with the line; "
    "that of a switch is on or off",
    ReadSet};

}  // namespace ray
