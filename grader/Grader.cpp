#include "grader/Grader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "R2/ImageFile.h"
#include "source/parse/Files.h"

namespace ray::grade {

/// A student's image, or the reason why there is none. Links are never followed.
struct FetchedImage {
  R2::Image image;
  bool is_jpeg = false;
  std::string problem;
};
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_image_bytes = std::int64_t{1} << 27;

/// If the grader is the superuser, programs run as another user, who needs write access here.
void LetOthersWrite(const fs::path& folder) {
  if (geteuid() != 0) return;
  fs::permissions(folder, fs::perms::all);
}

std::string ReplacedAll(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

FetchedImage NoImage(const std::string& problem) { return {{}, false, problem}; }

FetchedImage Fetch(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0)
    return NoImage(errno == ELOOP    ? "left a symbolic link instead of an image; links are not followed"
                   : errno == ENOENT ? "left no image"
                                     : "left an image that cannot be read");
  struct stat status {};
  fstat(descriptor, &status);
  std::vector<unsigned char> bytes;
  const bool is_file = S_ISREG(status.st_mode), fits = status.st_size <= most_image_bytes;
  if (is_file && fits) {
    bytes.resize(static_cast<std::size_t>(status.st_size));
    const ssize_t count = read(descriptor, bytes.data(), bytes.size());
    bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  }
  close(descriptor);
  if (!is_file) return NoImage("left something other than a file instead of an image");
  if (!fits) return NoImage("left a file of more than 128 MiB instead of an image");
  if (bytes.empty()) return NoImage("left an empty file");
  try {
    const R2::ImageSize size = R2::ReadImageSize(bytes);
    if (std::max(size.width, size.height) > 8192) return NoImage("left an image of more than 8192 pixels on a side");
    R2::DecodedImage decoded = R2::DecodeImage(bytes);
    return {std::move(decoded.image), std::string(decoded.format->name) == "jpeg", {}};
  } catch (const R2::ImageError& error) {
    return NoImage(std::string("left a file that is not an image: ") + error.what());
  }
}

/// Returns the requested file, or else the only image in the folder: some programs choose its name themselves.
fs::path ImageIn(const fs::path& folder, const fs::path& wanted) {
  std::error_code ignored;
  if (fs::symlink_status(wanted, ignored).type() != fs::file_type::not_found) return wanted;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (R2::FormatForName(entry.path().string())) return entry.path();
  return wanted;
}

/// Quotes text for a shell.
std::string ShellWord(const std::string& text) { return "'" + ReplacedAll(text, "'", "'\\''") + "'"; }

/// Copies folders, files and links; built programs need no devices or pipes. Throws fs::filesystem_error.
void CopyFolder(const fs::path& from, const fs::path& to) {
  fs::create_directory(to);
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    const fs::path place = to / entry.path().lexically_relative(from);
    if (entry.is_symlink())
      fs::copy_symlink(entry.path(), place);
    else if (entry.is_directory())
      fs::create_directory(place);
    else if (entry.is_regular_file())
      fs::copy_file(entry.path(), place);
  }
}

/// Changes the owner to the user that programs run as, if the grader is the superuser.
void GiveToSandbox(const fs::path& folder) {
  if (geteuid() != 0) return;
  const auto give = [](const fs::path& path) {
    if (lchown(path.c_str(), sandbox_user, sandbox_user) != 0)
      throw fs::filesystem_error("", path, {errno, std::generic_category()});
  };
  give(folder);
  for (const auto& entry : fs::recursive_directory_iterator(folder)) give(entry.path());
}

std::string SizeOf(const R2::Image& image) {
  return std::to_string(image.Width()) + " x " + std::to_string(image.Height());
}

std::string WhyOfWrongSize(const R2::Image& image, const SuiteScene& scene) {
  std::string why = "left an image of " + SizeOf(image) + " pixels instead of " + std::to_string(scene.width) + " x " +
                    std::to_string(scene.height);
  if (image.Width() == scene.height && image.Height() == scene.width) why += ": width and height are swapped";
  return why;
}

std::string Contents(const std::string& file) {
  const Files files(file, {});
  return files.Read(files.Top());
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string pattern = (fs::temp_directory_path() / "raygrade.XXXXXX").string();
  if (!mkdtemp(pattern.data()))
    throw std::runtime_error("cannot make a folder in " + fs::temp_directory_path().string());
  path_ = pattern;
  fs::permissions(path_, fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec | fs::perms::group_read |
                             fs::perms::others_read);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Grader::Grader(const Suite& suite, const GraderSettings& settings, const Loader& load)
    : suite_(suite), settings_(settings), load_(load), sandbox_(settings.sandbox), inputs_{suite.file} {
  for (const SuiteScene& scene : suite_.scenes) {
    Stage(scene);
    scenes_.push_back(std::make_unique<SceneImages>(scene, files_.back(), load_));
  }
}

void Grader::Stage(const SuiteScene& scene) {
  const fs::path from = fs::path(scene.file).parent_path(), to = folder_.Path() / "scenes" / scene.name;
  const SceneToRender loaded = load_(scene, scene.file);
  for (const std::string& file : loaded.scene.files) {
    inputs_.push_back(file);
    const fs::path place = fs::path(file).lexically_relative(from.empty() ? fs::path(".") : from);
    if (place.empty() || place.begin()->string() == "..") continue;  // read in place
    fs::create_directories((to / place).parent_path());
    fs::copy_file(file, to / place, fs::copy_options::overwrite_existing);
  }
  const fs::path copy = to / fs::path(scene.file).filename();
  files_.push_back(copy.string());
  if (settings_.seed == 0 || scene.vary.empty()) return;
  std::ofstream(copy, std::ios::binary) << Varied(Contents(scene.file), scene, settings_.seed);
}

std::string Grader::MissingProgram(const std::string& student) const {
  const std::string placeholder = "{student}/";
  for (const std::string& word : settings_.command) {
    std::error_code none;
    if (word.starts_with(placeholder) && !fs::exists(ReplacedAll(word, "{student}", student), none))
      return word.substr(placeholder.size());
  }
  return {};
}

void Grader::BuildCopy(const std::string& student, const fs::path& copy, StudentResult& result) {
  try {
    fs::remove_all(copy);
    CopyFolder(student, copy);
    GiveToSandbox(copy);
  } catch (const fs::filesystem_error& error) {
    result.problem = "was not built: " + error.path1().filename().string() + ": " + error.code().message();
    return;
  }
  const Limits limits{.seconds = suite_.build_seconds, .memory = suite_.build_memory, .processes = 256};
  const std::vector<fs::path> readable(suite_.readable.begin(), suite_.readable.end());
  const RunResult ran =
      sandbox_.Run({"/bin/sh", "-c", ReplacedAll(settings_.build, "{student}", ShellWord(copy.string()))}, copy,
                   readable, limits, settings_.stop);
  result.build_log = ReplacedAll(ran.output, copy.string() + "/", "");
  const std::string missing = MissingProgram(copy.string());
  if (!ran.IsGood())
    result.problem = "was not built: the command " + settings_.build + " " + ran.Problem();
  else if (!missing.empty())
    result.problem = "was not built: the command " + settings_.build + " did not make " + missing;
}

StudentResult Grader::Grade(const std::string& name, const std::string& student,
                            const std::function<void(const StudentResult&)>& done) {
  StudentResult result{.name = name, .scenes = {}};
  std::string folder = student;
  if (!settings_.build.empty()) {
    folder = (folder_.Path() / "student").string();
    BuildCopy(student, folder, result);
  } else if (const std::string missing = MissingProgram(student); !missing.empty()) {
    result.problem = "was not run: there is no " + missing + " in the folder";
  }
  double used = 0;
  std::vector<HandedIn> handed_in;
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const double left = suite_.budget > 0 ? suite_.budget - used : suite_.scenes[i].seconds;
    SceneResult scene = Begun(suite_.scenes[i]);
    if (result.problem.empty())
      handed_in.push_back(GradeScene(*scenes_[i], files_[i], folder, left, scene));
    else
      scene.headline = "The program " + result.problem + ".", scene.note = "no program";
    if (settings_.stop && *settings_.stop) return result;
    if (!handed_in.empty() && handed_in.back().runs.empty()) handed_in.pop_back();
    if (!handed_in.empty()) handed_in.back().scene = i;
    result.scenes.push_back(std::move(scene));
    used += result.scenes.back().seconds;
    result.is_complete = i + 1 == scenes_.size();
    if (result.is_complete) JudgeTogether(handed_in, suite_, result);
    done(result);
  }
  return result;
}

FetchedImage Grader::RunProgram(const SuiteScene& scene, const std::string& file, const std::string& student,
                                double seconds_left, SceneResult& result) {
  const fs::path folder = folder_.Path() / "run";
  fs::remove_all(folder);
  fs::create_directory(folder);
  LetOthersWrite(folder);
  const fs::path image = folder / ("image." + settings_.image_extension);
  std::vector<fs::path> readable(suite_.readable.begin(), suite_.readable.end());
  readable.push_back(fs::path(file).parent_path());
  if (!student.empty()) readable.emplace_back(student);
  const Limits limits{.seconds = std::min(scene.seconds, seconds_left), .memory = suite_.memory};
  const RunResult ran =
      sandbox_.Run(FilledCommand(scene, file, student, image), folder, readable, limits, settings_.stop);
  result.seconds += ran.seconds;
  result.program_output = ran.output;
  result.note = ran.Note();
  if (!ran.IsGood()) return NoImage(ran.Problem());
  result.note = "no image";
  FetchedImage fetched = Fetch(ImageIn(folder, image));
  if (!fetched.problem.empty()) return fetched;
  if (fetched.image.Width() != scene.width || fetched.image.Height() != scene.height) {
    result.note = "wrong size";
    return NoImage(WhyOfWrongSize(fetched.image, scene));
  }
  result.note.clear();
  return fetched;
}

std::vector<std::string> Grader::FilledCommand(const SuiteScene& scene, const std::string& file,
                                               const std::string& student, const fs::path& image) const {
  std::vector<std::string> words;
  for (const std::string& word : settings_.command) {
    std::string filled = ReplacedAll(word, "{student}", student);
    filled = ReplacedAll(filled, "{scene}", file);
    filled = ReplacedAll(filled, "{image}", image.string());
    filled = ReplacedAll(filled, "{width}", std::to_string(scene.width));
    words.push_back(ReplacedAll(filled, "{height}", std::to_string(scene.height)));
  }
  return words;
}

SceneResult Grader::Begun(const SuiteScene& scene) {
  SceneResult result;
  result.scene = scene.name;
  result.title = scene.title.empty() ? scene.name : scene.title;
  result.teaches = scene.teaches;
  result.points = scene.points;
  return result;
}

HandedIn Grader::GradeScene(SceneImages& images, const std::string& file, const std::string& student,
                            double seconds_left, SceneResult& result) {
  const SuiteScene& scene = images.scene();
  HandedIn handed_in{&images, {}};
  const auto fail = [&](const std::string& problem) {
    result.headline = "The program " + problem + ".";
    return HandedIn{&images, {}};
  };
  if (!(seconds_left > 0)) return fail("was not run: the time limit for all scenes together was reached");
  for (int run = 0; run < scene.runs; ++run) {
    FetchedImage fetched = RunProgram(scene, file, student, seconds_left, result);
    if (!fetched.problem.empty()) return fail(fetched.problem);
    handed_in.is_jpeg |= fetched.is_jpeg;
    handed_in.runs.push_back(std::move(fetched.image));
  }
  result.program_output.clear();
  JudgeAlone(ExhibitsOf({&handed_in, 1}, Encoding::linear)[0], suite_, result);
  return handed_in;
}

}  // namespace ray::grade
