#include "source/app/options/FileNames.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <vector>

#include "source/app/Status.h"
#include "source/app/manual/Help.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/PictureName.h"
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

/// What was probably meant: the words as typed, with a name for the picture behind the scene's.
std::string LikelyCommand(const RenderOptions& options, std::span<const std::string> words) {
  const std::string& scene_name = options.files.scene;
  if (scene_name.empty()) return "raypro scenes/hello.scn hello.png -width 512";
  std::vector<std::string> likely(words.begin(), words.end());
  const auto scene = std::ranges::find(likely, scene_name);
  const std::string picture = scene_name == standard_stream
                                  ? "out.png"
                                  : std::filesystem::path(scene_name).filename().replace_extension(".png").string();
  likely.insert(scene == likely.end() ? scene : scene + 1, picture);
  if (options.given.empty()) likely.insert(likely.end(), {"-width", "512"});
  return "raypro " + ShellLine(likely);
}

constexpr const char* several_scenes = "; several scenes need -out_folder: raypro a.scn b.scn -out_folder images";

std::string ExtensionOf(const std::string& name) { return LowerCase(std::filesystem::path(name).extension().string()); }

bool IsScene(const std::string& name) { return !R2::FormatForName(name) && IsSceneName(name); }

/// The first of the options that were given of which the fact is true; null where there is none.
const OptionKind* FirstGiven(const Options& options, Fact fact) {
  for (const OptionKind& option : OptionTable(*options.program))
    if (option.facts.Has(fact) && options.IsGiven(option.name)) return &option;
  return nullptr;
}

/// Each scene makes an image of its own name, and standard input has no name.
void CheckScenes(const RenderOptions& options) {
  if (const OptionKind* option = FirstGiven(options, Fact::one_image))
    throw UsageError("-" + std::string(option->name) +
                     " works with one scene only; it cannot be combined with -out_folder");
  std::map<std::string, std::string> pictures;
  for (const std::string& scene : options.scenes) {
    if (scene == standard_stream) throw UsageError("standard input has no name for an image; -out_folder takes files");
    const auto [other, is_new] =
        pictures.emplace(PictureInFolder(options.out_folder, scene, options.out_format), scene);
    if (!is_new)
      throw UsageError(Quoted(other->second) + " and " + Quoted(scene) + " would both be written to " +
                       Quoted(other->first));
  }
}

/// Standard output holds one image, and nothing can be resumed from it.
void CheckStandardOutput(const RenderOptions& options) {
  if (options.files.picture != standard_stream) return;
  if (const OptionKind* option = FirstGiven(options, Fact::named_image))
    throw UsageError("-" + std::string(option->name) + " needs an image file, not standard output");
}

bool IsPicture(const std::string& name) { return R2::FormatForName(name) != nullptr; }

void CheckSecondName(const FileOptions& files) {
  if (!files.picture.empty() && IsPicture(files.scene) && !IsPicture(files.picture))
    throw UsageError("the scene is named first: raypro " + ShellLine(std::vector{files.picture, files.scene}));
  if (IsScene(files.picture) && files.picture != files.scene)
    throw UsageError(Quoted(files.picture) + " is a scene" + several_scenes);
}

void CheckPicture(const RenderOptions& options, std::span<const std::string> words) {
  const FileOptions& files = options.files;
  if (files.report == standard_stream) throw UsageError("-report needs the name of a file, not standard output");
  if (files.picture == options.files.report && !files.picture.empty())
    throw UsageError("the image and the report are the same file, " + Quoted(files.report));
  if (!files.picture.empty()) return;
  if (FindOption(*options.program, files.scene)) throw UsageError("options begin with a dash: raypro -" + files.scene);
  if (IsPicture(files.scene))
    throw UsageError("no scene is named; for example: raypro scenes/hello.scn " + files.scene);
  throw UsageError("missing output file name; for example: " + LikelyCommand(options, words));
}

/// `raypro scene.scn > out.png` asks for an image on standard output, which would get a line of text instead. Only
/// Linux knows what the shell has opened.
bool IsOutputSentToAnImage() {
  std::error_code unknown;
  return IsPicture(std::filesystem::read_symlink("/proc/self/fd/1", unknown).string());
}

/// Returns true if the file is an image that raypro has written.
bool IsOfRaypro(const std::string& picture) {
  try {
    return R2::ReadImageHeader(ReadBytes(picture)).settings.contains("scene_hash");
  } catch (const std::exception&) {
    return false;
  }
}

/// A scene or a mesh may be named alone, as in Groningen's course; its image then lies beside it. A name that ends in
/// .txt says too little about what a file holds. Beside a mesh there may be its texture, which is left as it is.
void NamePictureOfLoneScene(RenderOptions& options) {
  const std::string& scene = options.files.scene;
  const bool is_alone = Renders(options) && options.files.picture.empty() && !IsOutputSentToAnImage();
  const bool is_mesh = MeshFormatForName(scene) != nullptr;
  if (!is_alone || !(is_mesh || IsScene(scene)) || ExtensionOf(scene) == ".txt") return;
  options.files.picture = std::filesystem::path(scene).replace_extension(".png").string();
  std::error_code ignored;
  if (is_mesh && std::filesystem::exists(options.files.picture, ignored) && !IsOfRaypro(options.files.picture))
    throw UsageError(Quoted(options.files.picture) +
                     " exists and may be a texture of the mesh; name the image: raypro " +
                     ShellLine(std::vector<std::string>{scene, "out.png"}));
}

/// Returns "-" for names by which systems call the given standard stream, and any other name as it is.
std::string StreamNamed(const std::string& name, int descriptor, const char* word) {
  const std::string number = std::to_string(descriptor);
  const bool is_stream =
      name == std::string("/dev/") + word || name == "/dev/fd/" + number || name == "/proc/self/fd/" + number;
  return is_stream ? standard_stream : name;
}

/// Returns the name of a scene to read. A pipe that a shell makes, as for `<(...)`, can be read only once: it becomes
/// standard input.
std::string SceneNamed(const std::string& name) {
  std::error_code ignored;
  const bool is_descriptor = name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/");
  if (is_descriptor && std::filesystem::is_fifo(name, ignored)) {
    const int pipe = open(name.c_str(), O_RDONLY | O_CLOEXEC);
    if (pipe >= 0 && dup2(pipe, STDIN_FILENO) == STDIN_FILENO) return standard_stream;
  }
  return StreamNamed(name, STDIN_FILENO, "stdin");
}

/// Gives each name its role.
void Share(RenderOptions& options) {
  const std::vector<std::string>& names = options.names;
  const bool is_rayview = *options.program == Program::rayview;
  if (!options.out_folder.empty()) options.scenes = names;
  if (!options.out_folder.empty() || names.empty()) return;
  if (is_rayview && names.size() > 1) RefuseName(names[1], UsageOf(*options.program));
  if (names.size() > 2) RefuseName(names[2], IsScene(names[2]) ? several_scenes : UsageOf(*options.program));
  options.files.scene = names[0];
  if (names.size() == 2) options.files.picture = StreamNamed(names[1], STDOUT_FILENO, "stdout");
  if (!is_rayview) options.files.report = StreamNamed(options.files.report, STDOUT_FILENO, "stdout");
  NamePictureOfLoneScene(options);
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
  if (Renders(options)) CheckPicture(options, words);
}

std::string PictureInFolder(const std::string& folder, const std::string& scene, const std::string& extension) {
  const std::filesystem::path name = std::filesystem::path(scene).stem().string() + "." + extension;
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace ray
