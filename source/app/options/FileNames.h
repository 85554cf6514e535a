#pragma once

#include <functional>
#include <span>
#include <string>

#include "R2/ImageFile.h"
#include "source/app/options/RenderOptions.h"

/// The names of files on the command line: scenes and images.
namespace ray {

/// The name of standard input as a scene, and of standard output as an image.
inline constexpr const char* standard_stream = "-";

/// Returns the format for the extension of an image; PNG for standard output. Null if there is none.
inline const R2::ImageFormat* FormatOfImage(const std::string& name) {
  return R2::FormatForName(name == standard_stream ? "-.png" : name);
}

/// Returns a function that encodes images in the format of that file and discards the bytes, to measure the time.
inline std::function<void(const R2::Image&)> EncoderOf(const std::string& name, const R2::ImageEncoding& encoding) {
  return [name, encoding](const R2::Image& image) { FormatOfImage(name)->encode(image, encoding, {}); };
}

/// Returns " (usage: raypro scene image [options])".
std::string UsageOf(const Program& program, const CommandKind* command = nullptr);

/// Throws a UsageError about an unexpected word; `why` ends its message.
[[noreturn]] void RefuseName(const std::string& word, const std::string& why);

/// Assigns the typed names: with -out_folder all are scenes, otherwise a scene and its image. Throws UsageError if
/// there is a third or one is missing, with the command that was probably meant, or if names contradict each other.
///   words   as typed
void ShareNames(RenderOptions& options, std::span<const std::string> words);

/// Returns "images/room.png": the file for a scene's image in the folder of -out_folder.
std::string ImageInFolder(const std::string& folder, const std::string& scene, const std::string& extension);

}  // namespace ray
