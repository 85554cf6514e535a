#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

constexpr auto channels = R3::ArgumentsFromZero("r", "g", "b");

void ReadColor(ScnReader& reader, Statement& statement, R2::Color Scene::*place) {
  const Arguments read = statement.Numbers(channels);
  reader.Builder().scene.*place = {read.values[0], read.values[1], read.values[2]};
}

void ReadBackground(ScnReader& reader, Statement& statement) { ReadColor(reader, statement, &Scene::background); }
void ReadAmbient(ScnReader& reader, Statement& statement) { ReadColor(reader, statement, &Scene::ambient); }

constexpr auto distance = R3::ArgumentsFromZero("distance");

/// Reads an extension: some courses' images were made with a bias.
void ReadShadowBias(ScnReader& reader, Statement& statement) {
  reader.Builder().scene.shadow_bias = statement.Numbers(distance).values[0];
}

/// Reads an extension: the course names environments on the command line only.
void ReadEnvironment(ScnReader& reader, Statement& statement) {
  const FileWord file = statement.FileName();
  reader.WithFile(statement, file.word, [&] {
    reader.Builder().scene.environment = reader.Library().EnvironmentNamed(file.name, reader.CurrentFile());
  });
}

}  // namespace

extern const Command background_command{"background", "background r g b",
                                        "color of rays that hit nothing (default black)", ReadBackground};
extern const Command ambient_command{"ambient", "ambient r g b", "ambient light, multiplied by ka (default black)",
                                     ReadAmbient};
extern const Command shadow_bias_command{
    "shadow_bias", "shadow_bias distance",
    "minimum distance of hits of shadow rays and reflections (default 0: rays start off their surface anyway)",
    ReadShadowBias};
extern const Command environment_command{
    "environment", "environment file",
    "environment map: an image infinitely far away on all sides that is seen and lights the scene", ReadEnvironment};

}  // namespace ray
