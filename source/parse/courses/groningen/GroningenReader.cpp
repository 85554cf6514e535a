#include "source/parse/courses/groningen/GroningenReader.h"

#include <algorithm>

#include "source/parse/Format.h"

namespace ray {
namespace {

Scene ReadGroningen(const ParseOptions& options, const Document& document, Assets& assets, Report& report) {
  return GroningenReader(options, document, assets, report).Read();
}

}  // namespace

extern const SceneFormat groningen_scene_format{
    .name = "groningen",
    .extensions = {".yaml", ".yml", ".json"},
    .about = "Introduction to Computer Graphics, Groningen (2009 to 2018)",
    .read_document = ReadGroningen,
    .keys = {"Objects", "Lights", "Eye", "Camera"},
};

Scene GroningenReader::Read() {
  auto scene = Field(report_, report_.Source().Root()).AsMapping("a scene");
  if (!scene) return {};
  Made().files.push_back(report_.Source().Source().name);
  ReadView(*scene);
  ReadImageSettings(*scene);
  ReadLights(*scene);
  ReadObjects(*scene);
  Made().background = scene->Color({"Background", "background"}, {});
  scene->Ignore({"comment", "name", "Comment", "Name"});
  scene->Finish();
  objects_.Builder().has_camera = objects_.Builder().has_light = true;
  return objects_.Finish();
}

void GroningenReader::Set(const std::string& option, const std::string& value, const Value* said) {
  auto& settings = Made().settings;
  std::erase_if(settings, [&](const SceneSetting& setting) { return setting.option == option; });
  settings.push_back({option, value, said ? report_.PlaceOf(said->extent) : "Groningen"});
}

}  // namespace ray
