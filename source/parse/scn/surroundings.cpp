#include <array>

#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

const std::array<R3::Argument, 3> channels{{{"r", false}, {"g", false}, {"b", false}}};

void ReadColor(ScnReader& reader, Statement& statement, R2::Color Scene::*place) {
  const Arguments read = statement.Numbers(channels);
  reader.Builder().scene.*place = {read.values[0], read.values[1], read.values[2]};
}

void ReadBackground(ScnReader& reader, Statement& statement) { ReadColor(reader, statement, &Scene::background); }
void ReadAmbient(ScnReader& reader, Statement& statement) { ReadColor(reader, statement, &Scene::ambient); }

/// An extension: the course names environments on the command line only.
void ReadEnvironment(ScnReader& reader, Statement& statement) {
  const Token name = statement.Word("file");
  reader.WithFile(statement, name, [&] {
    reader.Builder().scene.environment =
        reader.Library().EnvironmentNamed(std::string(name.text), reader.CurrentFile());
  });
}

}  // namespace

extern const Command background_command{"background", "background r g b",
                                        "what rays see that hit nothing; black unless stated", ReadBackground};
extern const Command ambient_command{"ambient", "ambient r g b",
                                     "light that is everywhere, for ka; black unless stated", ReadAmbient};
extern const Command environment_command{"environment", "environment file",
                                         "a picture of what is infinitely far on all sides, seen and shining",
                                         ReadEnvironment};

}  // namespace ray
