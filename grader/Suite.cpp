#include "grader/Suite.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "source/parse/Files.h"
#include "source/parse/Format.h"
#include "source/parse/document/Mapping.h"
#include "source/text/Words.h"

namespace ray::grade {
namespace {

namespace fs = std::filesystem;

constexpr int most_pixels_a_side = 4096;
constexpr double most_seconds = 3600, most_points = 1e6, most_memory = 1 << 20;
constexpr int most_runs = 16;

/// Reads a number from 1 on.
int Whole(Mapping& mapping, std::string_view name, int most, int otherwise) {
  const auto field = mapping.Find({name});
  return field ? static_cast<int>(field->Whole(1, most).value_or(otherwise)) : otherwise;
}

/// Reads the settings that a suite makes for all of its scenes, and each scene for itself.
void ReadShared(Mapping& mapping, SuiteScene& scene) {
  scene.points = mapping.Number({"points"}, {0, most_points}, scene.points);
  scene.width = Whole(mapping, "width", most_pixels_a_side, scene.width);
  scene.height = Whole(mapping, "height", most_pixels_a_side, scene.height);
  scene.seconds = mapping.Number({"seconds"}, {0, most_seconds, true}, scene.seconds);
  scene.tolerance = mapping.Number({"tolerance"}, {0, 1}, scene.tolerance);
  scene.allowed = mapping.Number({"allowed"}, {0, 100}, scene.allowed);
  scene.runs = Whole(mapping, "runs", most_runs, scene.runs);
  if (const auto field = mapping.Find({"options"})) {
    const auto words = field->Word();
    scene.options = words.value_or("");
    const Document& document = mapping.Reporter().Source();
    scene.options_at = ErrorAt(document.Source(), document.At(field->What().extent), "");
  }
}

void ReadVary(Mapping& mapping, SuiteScene& scene) {
  const auto field = mapping.Find({"vary"});
  if (!field) return;
  if (!field->IsMapping()) return field->Error("must be a mapping from texts of the scene file to what they become");
  for (const Entry& entry : field->What().Entries()) {
    const auto text = Field(mapping.Reporter(), entry.value).Word();
    const Document& document = mapping.Reporter().Source();
    if (text) scene.vary.push_back({entry.key, *text, ErrorAt(document.Source(), document.At(entry.key_extent), "")});
  }
}

/// Reads an entry of "scenes".
class SceneReader {
 public:
  explicit SceneReader(const std::string& folder) : folder_(folder) {}

  void Read(const Field& field, SuiteScene scene, std::vector<SuiteScene>& scenes) {
    auto mapping = field.AsMapping("a scene of a suite");
    if (!mapping) return;
    const auto file = mapping->Need({"scene"});
    const auto word = file ? file->Word() : std::nullopt;
    scene.title = mapping->Word({"title"}).value_or("");
    scene.teaches = mapping->Word({"teaches"}).value_or("");
    ReadShared(*mapping, scene);
    ReadVary(*mapping, scene);
    if (word) Place(*file, *word, scene);
    if (mapping->FinishedWell()) scenes.push_back(std::move(scene));
  }

 private:
  void Place(const Field& field, const std::string& word, SuiteScene& scene) {
    const fs::path path = fs::path(folder_) / word;
    scene.file = path.string();
    scene.name = path.stem().string();
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return field.Error(": there is no file " + Quoted(scene.file));
    if (!names_.insert(scene.name).second)
      field.Error(": another scene of the suite is called " + Quoted(scene.name) + " too");
  }

  std::string folder_;
  std::set<std::string> names_;
};

std::vector<std::string> ReadCommand(Mapping& mapping) {
  std::vector<std::string> words;
  const auto field = mapping.Find({"command"});
  const auto list = field ? field->List() : std::nullopt;
  if (!list) return words;
  for (const Field& each : *list)
    if (const auto word = each.Word()) words.push_back(*word);
  return words;
}

/// Returns absolute paths, since programs run elsewhere.
std::vector<std::string> ReadReadable(Mapping& mapping, const std::string& folder) {
  std::vector<std::string> files;
  const auto field = mapping.Find({"readable"});
  const auto list = field ? field->List() : std::nullopt;
  if (!list) return files;
  for (const Field& each : *list) {
    const auto word = each.Word();
    if (!word) continue;
    std::error_code failed;
    const fs::path path = fs::canonical(fs::path(folder) / *word, failed);
    if (failed) each.Error(": there is no file or folder " + Quoted(*word));
    files.push_back(path.string());
  }
  return files;
}

void ReadScenes(Mapping& mapping, const SuiteScene& usual, Suite& suite) {
  const auto field = mapping.Need({"scenes"});
  const auto list = field ? field->List() : std::nullopt;
  if (!list) return;
  if (list->empty()) field->Error("must name at least one scene");
  SceneReader reader(fs::path(suite.file).parent_path().string());
  for (const Field& each : *list) reader.Read(each, usual, suite.scenes);
}

Suite ReadFrom(const Document& document, Report& report) {
  DocumentReport places(document, report);
  Suite suite;
  suite.file = document.Source().name;
  auto mapping = Field(places, document.Root()).AsMapping("a suite");
  if (!mapping) return suite;
  suite.name = mapping->Word({"name"}).value_or(fs::path(suite.file).stem().string());
  suite.command = ReadCommand(*mapping);
  suite.build = mapping->Word({"build"}).value_or("");
  suite.build_seconds = mapping->Number({"build_seconds"}, {0, most_seconds, true}, suite.build_seconds);
  suite.build_memory = mapping->Number({"build_memory"}, {1, most_memory}, suite.build_memory);
  suite.readable = ReadReadable(*mapping, fs::path(suite.file).parent_path().string());
  suite.memory = mapping->Number({"memory"}, {1, most_memory}, suite.memory);
  suite.budget = mapping->Number({"budget"}, {0, most_seconds}, suite.budget);
  suite.explained = mapping->Number({"explained"}, {0, 1}, suite.explained);
  SuiteScene usual;
  ReadShared(*mapping, usual);
  ReadScenes(*mapping, usual, suite);
  mapping->Finish();
  return suite;
}

/// Returns a scalar of YAML with any content.
std::string InQuotationMarks(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

double Suite::Points() const {
  double points = 0;
  for (const SuiteScene& scene : scenes) points += scene.points;
  return points;
}

Suite ReadSuite(const std::string& file) {
  Text text{file, {}};
  try {
    const Files files(file, {});
    text.bytes = files.Read(files.Top());
  } catch (const FileError& error) {
    throw SceneErrors({ErrorIn(file, error.message, error.hint)});
  }
  Report report;
  const TextPlaces places(text);
  try {
    const Document document = ReadYaml(text, places, report);
    report.ThrowErrors();
    Suite suite = ReadFrom(document, report);
    report.ThrowErrors();
    suite.warnings = report.Warnings();
    return suite;
  } catch (const SceneError& error) {
    throw SceneErrors({error});
  }
}

std::string NewSuite(const std::string& folder) {
  std::error_code failed;
  std::vector<fs::path> scenes;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (entry->is_regular_file() && IsSceneName(entry->path().string())) scenes.push_back(entry->path());
  std::erase_if(scenes, [](const fs::path& path) { return path.stem() == "suite"; });
  if (failed || scenes.empty()) throw SceneErrors({ErrorIn(folder, "there are no scenes in this folder")});
  std::ranges::sort(scenes);
  std::string text =
      "# A suite for raygrade. Scenes are relative to this file; settings before them apply to all.\n"
      "name: " +
      InQuotationMarks(fs::canonical(folder, failed).filename().string()) +
      "\n"
      "width: 160\nheight: 120\nseconds: 10       # time limit of the program for a scene\n"
      "tolerance: 0.02   # of a channel, 0 to 1\nallowed: 0.5      # percent of the steady pixels that may differ\n"
      "points: 1\nscenes:\n";
  for (const fs::path& scene : scenes) text += "  - scene: " + InQuotationMarks(scene.filename().string()) + "\n";
  return text;
}

}  // namespace ray::grade
