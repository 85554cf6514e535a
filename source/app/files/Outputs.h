#pragma once

#include <filesystem>
#include <optional>

#include "source/app/files/OutputFile.h"
#include "source/app/options/RenderOptions.h"
#include "source/app/report/RunStats.h"

namespace ray {

/// An output file for an image, and the format of its extension.
struct ImageOutput {
  const R2::ImageFormat* format = nullptr;
  OutputFile file;
};

/// Checks the file and its format. Throws UsageError if no format has the extension, and OutputError.
ImageOutput CheckImageOutput(const std::string& name, std::span<const std::string> inputs);

/// Throws UsageError if the format cannot store images of this size.
void RefuseSize(const R2::ImageFormat& format, int width, int height);

/// Prints a message if the name is a link, since the image is then written elsewhere.
void WarnOfLink(const Program& program, const OutputFile& image);

/// Returns the name for the image of an interrupted render if another image has its name: "out.partial.png" for
/// "out.png".
std::string PartialName(const std::string& image_name);

/// Returns true if the file must not be replaced by an interrupted render: any file except one that states that it is
/// the image of an interrupted render.
bool IsFinishedImage(const std::filesystem::path& file);

/// The destinations of the results of a run.
struct Outputs {
  const R2::ImageFormat* format = nullptr;
  OutputFile image;
  OutputFile partial;  // for the image of an interrupted render if a finished one stays, see IsFinishedImage
  std::optional<OutputFile> report;
  std::vector<OutputFile> layers;  // one per layer of the options, unless the image contains them itself
};

/// Returns the files that the command line makes the render read. Those named by the scene are known once it is read.
std::vector<std::string> InputsOf(const FileOptions& files);

/// Checks the outputs before anything is read: the image's format is known and supports its size, and all files can be
/// written.
///   part   the rendered part of the image
/// Throws UsageError and OutputError.
Outputs CheckOutputs(const FileOptions& files, const PixelRectangle& part);

/// Throws OutputError if one of them is a file from which the scene was read.
void RefuseInputs(const Outputs& outputs, std::span<const std::string> inputs);

/// Writes the image. An image without rendered pixels is not written, and that of an interrupted render never replaces
/// another.
///   layers    one image for each of the options' layers
///   returns   the file that was written
OutputFile WriteImage(const Outputs& outputs, const RenderResult& result, const std::vector<R2::Image>& layers,
                      const RunStats& stats);
void WriteReport(const Outputs& outputs, const RunStats& stats);

}  // namespace ray
