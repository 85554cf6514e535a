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

/// An extension: what $name stands for where the command line, or an including file, has not said so before.
void ReadDefine(ScnReader& reader, Statement& statement) {
  const Token name = statement.Word("name");
  const Token value = statement.Word("value");
  if (!Variables::IsName(name.text))
    return statement.Error(name, "a name is of letters, digits and _, got " + Quoted(name.text),
                           "'define t 0.5', then '$t'");
  reader.Definitions().Define(name.text, value.text);
  reader.Definitions().Find(name.text);  // a value that the command line takes over is of use
}

void ReadInclude(ScnReader& reader, Statement& statement) { reader.Include(statement, statement.FileName()); }

}  // namespace

extern const Command set_command{
    "set", "set option [value]",
    "a setting of this scene, by the name of the option that overrides it; the value ends with the line; "
    "that of a switch is on, the default, or off",
    ReadSet};

extern const Command define_command{
    "define", "define name value",
    "what $name stands for in all that follows, a number or a word, unless -define name=value or an earlier line says "
    "otherwise",
    ReadDefine};

extern const Command include_command{"include", "include file",
                                     "the contents of another file, which has material ids of its own", ReadInclude};

}  // namespace ray
