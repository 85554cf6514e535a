#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

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

}  // namespace

extern const Command define_command{
    "define", "define name value",
    "what $name stands for in all that follows, a number or a word, unless -define name=value or an earlier line says "
    "otherwise",
    ReadDefine};

}  // namespace ray
