#include "source/app/options/FileNames.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <vector>

#include "source/app/Status.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/Info.h"
#include "source/parse/Format.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/text/LowerCase.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray {
namespace {

bool NeedsScene(const Options& options) { return !options.request || IsOfScene(*options.request); }

bool Renders(const Options& options) { return !options.request && *options.program == Program::raypro; }

/// Returns the command that was probably meant: the words as typed, with an image name after that of the scene.
std::string LikelyCommand(const RenderOptions& options, std::span<const std::string> words) {
  const std::string& scene_name = options.files.scene;
  if (scene_name.empty()) return "raypro scenes/hello.scn hello.png -width 512";
  std::vector<std::string> likely(words.begin(), words.end());
  const auto scene = std::ranges::find(likely, scene_name);
  const std::string image = scene_name == standard_stream
                                ? "out.png"
                                : std::filesystem::path(scene_name).filename().replace_extension(".png").string();
  likely.insert(scene == likely.end() ? scene : scene + 1, image);
  if (options.given.empty()) likely.insert(likely.end(), {"-width", "512"});
  return "raypro " + ShellLine(likely);
}

constexpr const char* several_scenes = "; several scenes need -out_folder: raypro a.scn b.scn -out_folder images";

std::string ExtensionOf(const std::string& name) { return LowerCase(std::filesystem::path(name).extension().string()); }

bool IsScene(const std::string& name) { return !R2::FormatForName(name) && IsSceneName(name); }

/// Returns the first given option with the fact, or null.
const OptionKind* FirstGiven(const Options& options, Fact fact) {
  for (const OptionKind& option : OptionTable(*options.program))
    if (option.facts.Has(fact) && options.IsGiven(option.name)) return &option;
  return nullptr;
}

/// Checks that each scene makes an image of a different name. Standard input has no name.
void CheckScenes(const RenderOptions& options) {
  if (const OptionKind* option = FirstGiven(options, Fact::one_image))
    throw UsageError("-" + std::string(option->name) +
                     " works with one scene only; it cannot be combined with -out_folder");
  std::map<std::string, std::string> images;
  for (const std::string& scene : options.scenes) {
    if (scene == standard_stream) throw UsageError("standard input has no name for an image; -out_folder takes files");
    const auto [other, is_new] = images.emplace(ImageInFolder(options.out_folder, scene, options.out_format), scene);
    if (!is_new)
      throw UsageError(Quoted(other->second) + " and " + Quoted(scene) + " would both be written to " +
                       Quoted(other->first));
  }
}

/// Checks options with standard output, which can take only one image, and from which nothing can be resumed.
void CheckStandardOutput(const RenderOptions& options) {
  if (options.files.image != standard_stream) return;
  if (const OptionKind* option = FirstGiven(options, Fact::named_image))
    throw UsageError("-" + std::string(option->name) + " needs an image file, not standard output");
}

bool IsImage(const std::string& name) { return R2::FormatForName(name) != nullptr; }

void CheckSecondName(const FileOptions& files) {
  if (!files.image.empty() && IsImage(files.scene) && !IsImage(files.image))
    throw UsageError("the scene is named first: raypro " + ShellLine(std::vector{files.image, files.scene}));
  if (IsScene(files.image) && files.image != files.scene)
    throw UsageError(Quoted(files.image) + " is a scene" + several_scenes);
}

void CheckImage(const RenderOptions& options, std::span<const std::string> words) {
  const FileOptions& files = options.files;
  if (files.report == standard_stream) throw UsageError("-report needs the name of a file, not standard output");
  if (files.image == options.files.report && !files.image.empty())
    throw UsageError("the image and the report are the same file, " + Quoted(files.report));
  if (!files.image.empty()) return;
  if (FindOption(*options.program, files.scene)) throw UsageError("options begin with a dash: raypro -" + files.scene);
  if (IsImage(files.scene)) throw UsageError("no scene is named; for example: raypro scenes/hello.scn " + files.scene);
  throw UsageError("missing output file name; for example: " + LikelyCommand(options, words));
}

/// Returns true if standard output is redirected to an image, as by `raypro scene.scn > out.png`; it would get a line
/// of text instead. Only Linux shows what the shell has opened.
bool IsOutputSentToAnImage() {
  std::error_code unknown;
  return IsImage(std::filesystem::read_symlink("/proc/self/fd/1", unknown).string());
}

/// Returns true if the file is an image written by raypro.
bool IsOfRaypro(const std::string& image) {
  try {
    return R2::ReadImageHeader(ReadBytes(image)).settings.contains("scene_hash");
  } catch (const std::exception&) {
    return false;
  }
}

/// Names the image of a scene or mesh that is named alone, as in Groningen's course: it is written next to the scene. A
/// .txt name is too ambiguous for that. An existing image next to a mesh may be its texture, which must not be
/// replaced.
void NameImageOfLoneScene(RenderOptions& options) {
  const std::string& scene = options.files.scene;
  const bool is_alone = Renders(options) && options.files.image.empty() && !IsOutputSentToAnImage();
  const bool is_mesh = MeshFormatForName(scene) != nullptr;
  if (!is_alone || !(is_mesh || IsScene(scene)) || ExtensionOf(scene) == ".txt") return;
  options.files.image = std::filesystem::path(scene).replace_extension(".png").string();
  std::error_code ignored;
  if (is_mesh && std::filesystem::exists(options.files.image, ignored) && !IsOfRaypro(options.files.image))
    throw UsageError(Quoted(options.files.image) + " exists and may be a texture of the mesh; name the image: raypro " +
                     ShellLine(std::vector<std::string>{scene, "out.png"}));
}

/// Returns "-" for the system's names of the given standard stream, and any other name unchanged.
std::string StreamNamed(const std::string& name, int descriptor, const char* word) {
  const std::string number = std::to_string(descriptor);
  const bool is_stream =
      name == std::string("/dev/") + word || name == "/dev/fd/" + number || name == "/proc/self/fd/" + number;
  return is_stream ? standard_stream : name;
}

/// Returns the name of a scene to read. A shell's pipe, as for `<(...)`, can be read only once: it becomes standard
/// input.
std::string SceneNamed(const std::string& name) {
  std::error_code ignored;
  const bool is_descriptor = name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/");
  if (is_descriptor && std::filesystem::is_fifo(name, ignored)) {
    const int pipe = open(name.c_str(), O_RDONLY | O_CLOEXEC);
    if (pipe >= 0 && dup2(pipe, STDIN_FILENO) == STDIN_FILENO) return standard_stream;
  }
  return StreamNamed(name, STDIN_FILENO, "stdin");
}

/// Assigns the names to their roles.
void Share(RenderOptions& options) {
  const std::vector<std::string>& names = options.names;
  const bool is_rayview = *options.program == Program::rayview;
  if (!options.out_folder.empty()) options.scenes = names;
  if (!options.out_folder.empty() || names.empty()) return;
  if (is_rayview && names.size() > 1) RefuseName(names[1], UsageOf(*options.program));
  if (names.size() > 2) RefuseName(names[2], IsScene(names[2]) ? several_scenes : UsageOf(*options.program));
  options.files.scene = names[0];
  if (names.size() == 2) options.files.image = StreamNamed(names[1], STDOUT_FILENO, "stdout");
  if (!is_rayview) options.files.report = StreamNamed(options.files.report, STDOUT_FILENO, "stdout");
  NameImageOfLoneScene(options);
}

}  // namespace

std::string UsageOf(const Program& program, const CommandKind* command) {
  return " (usage: " + Usage(program, command) + ")";
}

void RefuseName(const std::string& word, const std::string& why) {
  throw UsageError("unexpected extra argument " + Quoted(word) + why);
}

void ShareNames(RenderOptions& options, std::span<const std::string> words) {
  Share(options);
  options.files.scene = SceneNamed(options.files.scene);
  for (std::string& scene : options.scenes) scene = SceneNamed(scene);
  if (!NeedsScene(options)) {
    if (!options.files.scene.empty()) RefuseName(options.files.scene, "");
    if (!options.scenes.empty()) RefuseName(options.scenes[0], "");
    return;
  }
  if (!options.scenes.empty()) return CheckScenes(options);
  CheckStandardOutput(options);
  if (options.files.scene.empty())
    throw UsageError("no scene is named" + (Renders(options) ? "; for example: " + LikelyCommand(options, words)
                                                             : UsageOf(*options.program)));
  CheckSecondName(options.files);
  if (Renders(options)) CheckImage(options, words);
}

std::string ImageInFolder(const std::string& folder, const std::string& scene, const std::string& extension) {
  const std::filesystem::path name = std::filesystem::path(scene).stem().string() + "." + extension;
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace ray
