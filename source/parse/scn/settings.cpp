#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

/// Images are decoded as they are read, so this setting must come before them.
void DecodeSrgb(ScnReader& reader, Statement& statement) {
  if (!reader.Library().DecodeSrgb())
    statement.Error(statement.CommandWord(), "'set srgb' must come before the first image or mesh of the scene");
}

/// Reads an extension: a setting for this scene, which command lines override.
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

/// Reads an extension: the value of $name, unless the command line or an including file has defined it before.
void ReadDefine(ScnReader& reader, Statement& statement) {
  const Token name = statement.Word("name");
  const Token value = statement.Word("value");
  if (!Variables::IsName(name.text))
    return statement.Error(name, "a name consists of letters, digits and _, got " + Quoted(name.text),
                           "'define t 0.5', then '$t'");
  reader.Definitions().Define(name.text, value.text);
  reader.Definitions().Find(name.text);  // marks a value of the command line as used
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
    "the value of $name from here on, a number or a word, unless -define name=value or an earlier line says "
    "otherwise",
    ReadDefine};

extern const Command include_command{"include", "include file",
                                     "the contents of another file, which has its own material ids", ReadInclude};

}  // namespace ray
