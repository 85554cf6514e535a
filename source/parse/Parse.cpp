#include "source/parse/Parse.h"

#include <array>
#include <filesystem>
#include <new>

#include "source/parse/Assets.h"
#include "source/parse/Format.h"
#include "source/parse/MeshScene.h"
#include "source/parse/Text.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/text/LowerCase.h"

namespace ray {
namespace {

const std::array formats{
#define SCENE_FORMAT(name) &name##_scene_format,
#include "source/parse/formats.def"
#undef SCENE_FORMAT
};

using ReadScene = Scene (*)(const Files& files, const ParseOptions& options, Report& report);

ReadScene ReaderOf(const std::string& file) {
  const std::string extension = LowerCase(std::filesystem::path(file).extension().string());
  std::string known;
  for (const SceneFormat* format : formats) {
    if (extension == format->extension) return format->read;
    known += (known.empty() ? "" : ", ") + std::string(format->extension);
  }
  if (MeshFormatForName(file)) return ReadMeshScene;
  throw SceneErrors({ErrorIn(file, extension.empty() ? "no file extension" : "cannot read " + Quoted(extension),
                             "supported: scenes " + known + "; meshes " + MeshExtensions())});
}

/// The environment that the user names, wherever it lies.
void SetEnvironment(const ParseOptions& options, Report& report, Scene& scene) {
  const Files files(options.environment, {});
  Assets assets(files, report, options.decode_srgb);
  try {
    scene.environment = assets.EnvironmentOf(files.Top());
    scene.files.push_back(files.TopName());
  } catch (const FileError& error) {
    report.Error(ErrorIn(options.environment, error.message));
  }
}

}  // namespace

ParsedScene Parse(const std::string& file, const ParseOptions& options) {
  const ReadScene read = ReaderOf(file);
  Report report;
  try {
    const Files files(file, options.allowed_folders);
    ParsedScene parsed{read(files, options, report), {}};
    if (!options.environment.empty()) SetEnvironment(options, report, parsed.scene);
    report.ThrowErrors();
    parsed.warnings = report.Warnings();
    return parsed;
  } catch (const std::bad_alloc&) {
    throw SceneErrors({ErrorIn(file, "not enough memory for this scene")});
  }
}

}  // namespace ray
