#include "source/parse/groningen/GroningenReader.h"

#include <algorithm>
#include <filesystem>

#include "source/parse/Format.h"
#include "source/text/LowerCase.h"

namespace ray {
namespace {

Scene ReadGroningen(const Files& files, const ParseOptions& options, Report& report) {
  const Text text{files.TopName(), files.Read(files.Top())};
  const TextPlaces places(text);
  const bool is_json = LowerCase(std::filesystem::path(text.name).extension().string()) == ".json";
  const Document document = is_json ? ReadJson(text, places, report) : ReadYaml(text, places, report);
  Scene scene = GroningenReader(files, options, document, report).Read();
  report.ThrowErrors();
  return scene;
}

}  // namespace

extern const SceneFormat groningen_scene_format{"groningen",
                                                {".yaml", ".yml", ".json"},
                                                "Introduction to Computer Graphics, Groningen (2009 to 2018)",
                                                ReadGroningen,
                                                {"Objects", "Lights", "Eye", "Camera"}};

Scene GroningenReader::Read() {
  auto scene = Field(report_, report_.Source().Root()).AsMapping("a scene");
  if (!scene) return {};
  Made().files.push_back(report_.Source().Source().name);
  ReadView(*scene);
  ReadPicture(*scene);
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
