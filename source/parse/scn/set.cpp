#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

/// How images are decoded decides itself as they are read, so a scene must say so before.
void DecodeSrgb(ScnReader& reader, Statement& statement) {
  if (!reader.Library().DecodeSrgb())
    statement.Error(statement.CommandWord(), "'set srgb' must come before the first image or mesh of the scene");
}

/// An extension: a setting for this scene, which command lines override.
void ReadSet(ScnReader& reader, Statement& statement) {
  const Token option = statement.Word("option");
  std::string value;
  for (const Token& word : statement.RestOfLine()) value += (value.empty() ? "" : " ") + std::string(word.text);
  SceneSetting setting{std::string(option.text), value, reader.PlaceOf(option)};
  if (auto problem = reader.ProblemOf(setting)) return statement.Error(option, problem->message, problem->hint);
  if (setting.value.empty()) setting.value = "on";  // only a switch may be set without a value
  if (setting.option == "srgb" && setting.value == "on") DecodeSrgb(reader, statement);
  reader.Builder().scene.settings.push_back(std::move(setting));
}

}  // namespace

extern const Command set_command{
    "set", "set option [value]",
    "a setting of this scene, by the name of the option that overrides it; the value ends with the line; "
    "that of a switch is on, the default, or off",
    ReadSet};

}  // namespace ray
