#include "source/film/denoise/OpenImageDenoise.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace ray {
namespace {

// Constants of the library's C interface, which versions 1 and 2 share.
constexpr int processor = 1;  // OIDN_DEVICE_TYPE_CPU
constexpr int float3 = 3;     // OIDN_FORMAT_FLOAT3

/// Returns the paths that the library may have in the Python package pyoidn: of the virtual environment, the user, or
/// the system. Debian 12 has no other package of it.
std::vector<std::string> PathsInPython() {
  namespace fs = std::filesystem;
  const char* const environment = std::getenv("VIRTUAL_ENV");
  const char* const home = std::getenv("HOME");
  std::vector<fs::path> prefixes;
  if (environment && *environment) prefixes.push_back(fs::path(environment) / "lib");
  if (home && *home) prefixes.push_back(fs::path(home) / ".local/lib");
  prefixes.emplace_back("/usr/local/lib");
  std::vector<std::string> paths;
  for (const fs::path& prefix : prefixes) {
    const std::ptrdiff_t first = std::ssize(paths);
    std::error_code error;  // a folder that is missing or unreadable has no packages
    for (fs::directory_iterator folder(prefix, error), end; !error && folder != end; folder.increment(error))
      if (folder->path().filename().string().starts_with("python3"))
        for (const char* packages : {"site-packages", "dist-packages"})
          paths.push_back(folder->path() / packages / "pyoidn/oidn/lib/libOpenImageDenoise.so.2");
    std::sort(paths.begin() + first, paths.end());  // a folder's order is any
  }
  return paths;
}

/// Loads the library once. It is never unloaded, since its threads may still run in it.
void* Library() {
  static void* const library = [] {
    void* found = nullptr;
    for (const char* name : {"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1", "libOpenImageDenoise.so"})
      if (!found) found = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (found) return found;
    for (const std::string& path : PathsInPython())
      if (!found) found = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    return found;
  }();
  return library;
}

void* FindInLibrary(const char* name) {
  if (!Library())
    throw DenoiserError(
        "Open Image Denoise is not installed: libOpenImageDenoise.so.2 (or .so.1) was not found (pip install pyoidn, "
        "or set LD_LIBRARY_PATH)");
  return dlsym(Library(), name);
}

/// Returns a function by its name, or by its name before version 2.
template <typename Function>
void Find(Function*& function, const OpenImageDenoise::FindFunction& find, const char* name,
          const char* former_name = nullptr) {
  void* found = find(name);
  if (!found && former_name) found = find(former_name);
  if (!found) throw DenoiserError(std::string("the installed Open Image Denoise has no function ") + name);
  function = reinterpret_cast<Function*>(found);
}

}  // namespace

struct OpenImageDenoise::Functions {
  explicit Functions(const FindFunction& find) {
    Find(new_device, find, "oidnNewDevice");
    Find(release_device, find, "oidnReleaseDevice");
    Find(set_device_bool, find, "oidnSetDeviceBool", "oidnSetDevice1b");
    Find(set_device_int, find, "oidnSetDeviceInt", "oidnSetDevice1i");
    Find(get_device_int, find, "oidnGetDeviceInt", "oidnGetDevice1i");
    Find(get_device_error, find, "oidnGetDeviceError");
    Find(commit_device, find, "oidnCommitDevice");
    Find(new_filter, find, "oidnNewFilter");
    Find(release_filter, find, "oidnReleaseFilter");
    Find(set_shared_filter_image, find, "oidnSetSharedFilterImage");
    Find(set_filter_bool, find, "oidnSetFilterBool", "oidnSetFilter1b");
    Find(commit_filter, find, "oidnCommitFilter");
    Find(execute_filter, find, "oidnExecuteFilter");
  }

  void* (*new_device)(int type);
  void (*release_device)(void* device);
  void (*set_device_bool)(void* device, const char* name, bool value);
  void (*set_device_int)(void* device, const char* name, int value);
  int (*get_device_int)(void* device, const char* name);
  int (*get_device_error)(void* device, const char** message);
  void (*commit_device)(void* device);
  void* (*new_filter)(void* device, const char* type);
  void (*release_filter)(void* filter);
  void (*set_shared_filter_image)(void* filter, const char* name, void* pixels, int format, std::size_t width,
                                  std::size_t height, std::size_t byte_offset, std::size_t pixel_stride,
                                  std::size_t row_stride);
  void (*set_filter_bool)(void* filter, const char* name, bool value);
  void (*commit_filter)(void* filter);
  void (*execute_filter)(void* filter);
};

/// A filter of the library, for one call.
class OpenImageDenoise::Filter {
 public:
  Filter(const Functions& functions, void* device)
      : functions_(functions), filter_(functions.new_filter(device, "RT")) {}
  ~Filter() { functions_.release_filter(filter_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// Sets an image of three floats per pixel; pixels are `pixel_stride` bytes apart.
  void Use(const char* name, const float* pixels, int width, int height, std::size_t pixel_stride) {
    functions_.set_shared_filter_image(filter_, name, const_cast<float*>(pixels), float3,
                                       static_cast<std::size_t>(width), static_cast<std::size_t>(height), 0,
                                       pixel_stride, 0);
  }
  void Set(const char* name) { functions_.set_filter_bool(filter_, name, true); }
  void Run() {
    functions_.commit_filter(filter_);
    functions_.execute_filter(filter_);
  }

 private:
  const Functions& functions_;
  void* const filter_;
};

OpenImageDenoise::OpenImageDenoise(int threads) : OpenImageDenoise(FindInLibrary, threads) {}

OpenImageDenoise::OpenImageDenoise(const FindFunction& find, int threads)
    : functions_(std::make_unique<Functions>(find)),
      device_(functions_->new_device(processor), functions_->release_device) {
  ThrowIfFailed();
  if (threads > 0) functions_->set_device_int(device_.get(), "numThreads", threads);
  // the threads are ours, and continue with other work
  functions_->set_device_bool(device_.get(), "setAffinity", false);
  functions_->commit_device(device_.get());
  ThrowIfFailed();
}

OpenImageDenoise::~OpenImageDenoise() = default;

void OpenImageDenoise::ThrowIfFailed() const {
  const char* message = nullptr;
  if (functions_->get_device_error(device_.get(), &message) != 0 || !device_)
    throw DenoiserError(std::string("Open Image Denoise: ") + (message && *message ? message : "no device"));
}

bool OpenImageDenoise::IsPresent() {
  static const bool is_present = [] {
    try {
      const OpenImageDenoise library(0);
      return true;
    } catch (const DenoiserError&) {
      return false;
    }
  }();
  return is_present;
}

std::string OpenImageDenoise::Version() const {
  std::string text;
  for (const char* part : {"versionMajor", "versionMinor", "versionPatch"})
    text += (text.empty() ? "" : ".") + std::to_string(functions_->get_device_int(device_.get(), part));
  return text;
}

Pixels<Rgb> OpenImageDenoise::Filtered(const Pixels<Rgb>& colors, const Pixels<PixelGuide>& guides) const {
  const int width = colors.Width(), height = colors.Height();
  Pixels<Rgb> filtered(width, height);
  Filter filter(*functions_, device_.get());
  filter.Use("color", colors.At(0, 0).data(), width, height, sizeof(Rgb));
  filter.Use("albedo", &guides.At(0, 0)[3], width, height, sizeof(PixelGuide));
  filter.Use("normal", &guides.At(0, 0)[6], width, height, sizeof(PixelGuide));
  filter.Use("output", filtered.At(0, 0).data(), width, height, sizeof(Rgb));
  filter.Set("hdr");
  filter.Set("cleanAux");
  filter.Run();
  ThrowIfFailed();
  return filtered;
}

}  // namespace ray
