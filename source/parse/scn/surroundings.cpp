#include <array>

#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

const std::array<R3::Argument, 3> channels{{{"r", false}, {"g", false}, {"b", false}}};

void ReadColor(ScnReader& reader, Statement& statement, R2::Color Scene::* place) {
  const Arguments read = statement.Numbers(channels);
  reader.Builder().scene.*place = {read.values[0], read.values[1], read.values[2]};
}

void ReadBackground(ScnReader& reader, Statement& statement) { ReadColor(reader, statement, &Scene::background); }
void ReadAmbient(ScnReader& reader, Statement& statement) { ReadColor(reader, statement, &Scene::ambient); }

}  // namespace

extern const Command background_command{"background", "background r g b", ReadBackground};
extern const Command ambient_command{"ambient", "ambient r g b", ReadAmbient};

}  // namespace ray
