#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

void ReadLight(const LightKind& kind, ScnReader& reader, Statement& statement) {
  reader.Builder().has_light = true;
  const Arguments read = statement.Numbers(kind.arguments);
  if (!statement.IsGood()) return;
  try {
    reader.Builder().scene.lights.push_back(kind.make(read.values));
  } catch (const R3::ArgumentError& error) {
    statement.Error(read.words[error.index], error.what());
  }
}

}  // namespace

Command LightCommand(const LightKind& kind) {
  return {kind.name, kind.name + ArgumentNames(kind.arguments), kind.about,
          [&kind](ScnReader& reader, Statement& statement) { ReadLight(kind, reader, statement); }};
}

}  // namespace ray
