#include "source/parse/Parse.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <utility>

#include "R1/Kinds.h"
#include "source/parse/Assets.h"
#include "source/parse/Format.h"
#include "source/parse/MeshScene.h"
#include "source/parse/Text.h"
#include "source/parse/document/Document.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/text/LowerCase.h"
#include "source/text/NumberText.h"
#include "source/text/Suggestion.h"
#include "source/text/Words.h"

namespace ray {

std::span<const SceneFormat* const> SceneFormats() {
#define SCENE_FORMAT(name) KIND(SceneFormat, name##_scene_format),
  static const std::array formats{
#include "source/parse/formats.def"
  };
  return formats;
}

bool IsSceneName(const std::string& file) {
  const std::string extension = LowerCase(std::filesystem::path(file).extension().string());
  return std::ranges::any_of(SceneFormats(), [&](const SceneFormat* format) {
    return std::ranges::find(format->extensions, extension) != format->extensions.end();
  });
}

namespace {

std::string SceneExtensions() {
  std::string all;
  for (const SceneFormat* format : SceneFormats())
    for (const char* extension : format->extensions)
      if (all.find(extension) == std::string::npos) all += (all.empty() ? "" : ", ") + std::string(extension);
  return all;
}

const SceneFormat& FormatNamed(const std::string& name, const std::string& file) {
  std::vector<std::string_view> names;
  for (const SceneFormat* format : SceneFormats()) {
    if (name == format->name) return *format;
    names.emplace_back(format->name);
  }
  throw SceneErrors({ErrorIn(file, "unknown scene format " + Quoted(name), Suggestion(name, names, "formats"))});
}

/// Returns "'Objects' or 'Eye' (groningen)".
std::string KeysOf(const SceneFormat& format) {
  std::vector<std::string> keys;
  for (const char* key : format.keys) keys.push_back(Quoted(key));
  return OneOf(keys) + " (" + format.name + ")";
}

bool HasKeyOf(const Value& root, const SceneFormat& format) {
  return std::any_of(root.Entries().begin(), root.Entries().end(), [&](const Entry& entry) {
    return std::find(format.keys.begin(), format.keys.end(), entry.key) != format.keys.end();
  });
}

/// Chooses among formats with a common extension the one whose keys the document has.
const SceneFormat& FormatByKeys(const std::vector<const SceneFormat*>& candidates, const Document& document) {
  if (candidates.size() == 1) return *candidates.front();
  std::vector<const SceneFormat*> fitting;
  std::string known;
  for (const SceneFormat* format : candidates) {
    if (HasKeyOf(document.Root(), *format)) fitting.push_back(format);
    known += (known.empty() ? "" : "; ") + KeysOf(*format);
  }
  if (fitting.size() == 1) return *fitting.front();
  throw ErrorIn(document.Source().name,
                fitting.empty() ? "unknown scene format: it has none of the known top-level keys"
                                : "ambiguous scene format: it has top-level keys of several",
                known + "; -format name chooses one");
}

/// Returns the extension of the scene. Standard input is in this program's own language, unless -format says otherwise.
std::string ExtensionOf(const Files& files) {
  if (files.IsStandardInput()) return ".scn";
  return LowerCase(std::filesystem::path(files.TopName()).extension().string());
}

/// Returns true if a document is JSON rather than YAML: by its name, or because its language is always JSON.
bool IsJson(const Files& files, const SceneFormat& format) {
  return ExtensionOf(files) == ".json" ||
         std::ranges::all_of(format.extensions, [](std::string_view extension) { return extension == ".json"; });
}

Scene ReadDocumentScene(const std::vector<const SceneFormat*>& candidates, const Files& files,
                        const ParseOptions& options, Assets& assets, Report& report) {
  const Text text{files.TopName(), files.Read(files.Top())};
  const TextPlaces places(text);
  const Document document =
      IsJson(files, *candidates.front()) ? ReadJson(text, places, report) : ReadYaml(text, places, report);
  Scene scene = FormatByKeys(candidates, document).read_document(options, document, assets, report);
  report.ThrowErrors();
  return scene;
}

/// Returns the requested format, or those that match the file's extension.
std::vector<const SceneFormat*> FormatsFor(const Files& files, const ParseOptions& options) {
  if (!options.format.empty()) return {&FormatNamed(options.format, files.TopName())};
  std::vector<const SceneFormat*> candidates;
  for (const SceneFormat* format : SceneFormats())
    if (std::ranges::find(format->extensions, ExtensionOf(files)) != format->extensions.end())
      candidates.push_back(format);
  return candidates;
}

Scene ReadScene(const Files& files, const ParseOptions& options, Assets& assets, Report& report) {
  const auto candidates = FormatsFor(files, options);
  if (!options.definitions.empty() && (candidates.empty() || !candidates.front()->has_variables))
    report.Warn(Escaped(files.TopName()), "'-define' has no effect: only .scn scenes have variables");
  if (!candidates.empty()) {
    if (candidates.front()->read_document) return ReadDocumentScene(candidates, files, options, assets, report);
    return candidates.front()->read(files, options, assets, report);
  }
  if (MeshFormatForName(files.TopName())) return ReadMeshScene(files, options, assets, report);
  const std::string extension = ExtensionOf(files);
  if (extension.empty()) files.Top();  // "no such file" is more informative
  throw ErrorIn(files.TopName(), extension.empty() ? "no file extension" : "cannot read " + Quoted(extension),
                "supported: scenes " + SceneExtensions() + "; meshes " + MeshExtensions());
}

/// Sets the environment that the user named, wherever it is.
void SetEnvironment(const std::string& file, Assets& assets, Report& report, Scene& scene) {
  const Files files(file, {});
  try {
    scene.environment = assets.EnvironmentAtTop(files);
    scene.files.push_back(files.TopName());
  } catch (const FileError& error) {
    report.Error(ErrorIn(file, error.message, error.hint));
  }
}

/// Throws FileError if the kind of camera does not support the angle.
void SetAngle(Camera& camera, double fov) {
  const CameraKind& kind = *camera.kind;
  if (kind.extent != CameraExtent::angle || !IsExtent(kind, fov))
    throw FileError{
        "projection " + std::string(kind.name) + " has " +
            (kind.extent == CameraExtent::angle ? RangeOfExtent(kind) : "no angle") + ", and -fov is " + ToText(fov),
        kind.extent == CameraExtent::width ? "in a scene, 'projection orthographic width' says how much it shows" : ""};
  if (camera.IsPinhole())
    camera.SetFov(fov);
  else
    camera.extent = fov;
}

/// Converts a change to our world; the user states it in the world of the file.
CameraChange Mirrored(CameraChange change) {
  for (auto* place : {&change.eye, &change.target})
    if (*place) (*place)->z = 0 - (*place)->z;
  if (change.up) change.up->z = 0 - change.up->z;
  return change;
}

/// Changes the camera; throws FileError if the eye is at its target.
void Change(Camera& camera, const CameraChange& change, Report& report, const std::string& file) {
  const R3::Point eye = change.eye.value_or(camera.eye);
  if (change.target && *change.target == eye)
    throw FileError{"the camera is at the point given by -target", "-eye moves it"};
  if (change.eye || change.target || change.up) {
    AimedCamera aimed = Aim(eye, change.target ? *change.target - eye : camera.towards, change.up.value_or(camera.up));
    if (aimed.up_was_replaced)
      report.Warn(Escaped(file), "the up vector is parallel to the view direction; another one is used");
    aimed.camera.xfov = camera.xfov, aimed.camera.near = camera.near, aimed.camera.far = camera.far;
    aimed.camera.TakeViewOf(camera);
    camera = aimed.camera;
  }
  if (!change.projection.empty() && change.projection != camera.kind->name) {
    camera.kind = FindCameraKind(change.projection);
    camera.extent = 0;
  }
  if (change.fov) SetAngle(camera, *change.fov);
}

/// Sets the width of an orthographic camera that has none: the width that a pinhole sees at the middle of the scene, or
/// the whole scene if the eye is inside or beyond it.
void SetWidth(Camera& camera, const R3::Box& bounds) {
  if (camera.kind->extent != CameraExtent::width || camera.extent > 0) return;
  const double radius = bounds.IsEmpty() ? 0 : bounds.Radius();
  const double depth = radius > 0 ? Dot(bounds.Center() - camera.eye, camera.towards) : 1;
  camera.extent = depth > radius ? camera.Extent(depth) : 2 * radius;
}

}  // namespace

ParsedScene Parse(const std::string& file, const ParseOptions& options) {
  Report report;
  try {
    const Files files(file, options.allowed_folders);
    Assets assets(files, report, options);
    ParsedScene parsed{ReadScene(files, options, assets, report), {}};
    if (!options.environment.empty()) SetEnvironment(options.environment, assets, report, parsed.scene);
    if (options.one_sided)
      for (Material& m : parsed.scene.materials) m.one_sided |= IsBlack(m.kt) && IsBlack(m.absorb);
    Change(parsed.scene.camera, parsed.scene.is_mirrored ? Mirrored(options.camera) : options.camera, report,
           files.TopName());
    SetWidth(parsed.scene.camera, parsed.scene.root.bounds);
    report.ThrowErrors();
    for (const std::string& remark : files.Remarks()) report.Warn(Escaped(files.TopName()), remark);
    parsed.warnings = report.Warnings();
    return parsed;
  } catch (const FileError& error) {
    throw SceneErrors({ErrorIn(file == "-" ? standard_input_name : file, error.message, error.hint)});
  } catch (SceneError& error) {
    report.Error(std::move(error));
    report.ThrowErrors();
    throw;
  } catch (const std::bad_alloc&) {
    throw SceneErrors({ErrorIn(file, "not enough memory for this scene")});
  }
}

}  // namespace ray
