#pragma once

#include <filesystem>
#include <optional>

#include "source/app/files/OutputFile.h"
#include "source/app/options/RenderOptions.h"
#include "source/app/report/RunStats.h"

namespace ray {

/// A place for a picture, and the kind that its name asks for.
struct PictureOutput {
  const R2::ImageFormat* format = nullptr;
  OutputFile file;
};

/// Throws UsageError when no kind has the extension, and OutputError.
PictureOutput CheckPictureOutput(const std::string& name, std::span<const std::string> inputs);

/// Throws UsageError when the format cannot hold so many pixels a side.
void RefuseSize(const R2::ImageFormat& format, int width, int height);

/// Says so when the name is a link, for the picture goes elsewhere then.
void TellOfLink(const Program& program, const OutputFile& picture);

/// Where an interrupted render leaves its picture when another has the name: "out.partial.png" for "out.png".
std::string PartialName(const std::string& picture);

/// Whether something is there that an interrupted render must not replace: any file but one that says of itself that it
/// is the picture of an interrupted render.
bool IsFinishedPicture(const std::filesystem::path& file);

/// Where the results of a run go.
struct Outputs {
  const R2::ImageFormat* format = nullptr;
  OutputFile picture;
  OutputFile partial;  // gets the picture of an interrupted render where another stays, see IsFinishedPicture
  std::optional<OutputFile> report;
  std::vector<OutputFile> layers;  // one for each of the options' layers, unless the picture holds them itself
};

/// The files that the command line has the render read. What the scene names besides is known once it is read.
std::vector<std::string> InputsOf(const FileOptions& files);

/// Before anything is read: the picture has a known kind, which can hold its size, and all files can be written.
///   part   of the picture, that is rendered
/// Throws UsageError and OutputError.
Outputs CheckOutputs(const FileOptions& files, const PixelRectangle& part);

/// Throws OutputError when one of them is a file the scene was read from.
void RefuseInputs(const Outputs& outputs, std::span<const std::string> inputs);

/// A picture with nothing rendered is not written, and one of an interrupted render never in the place of another.
///   layers    one image for each of the options' layers
///   returns   where the picture went
OutputFile WritePicture(const Outputs& outputs, const RenderResult& result, const std::vector<R2::Image>& layers,
                        const RunStats& stats);
void WriteReport(const Outputs& outputs, const RunStats& stats);

}  // namespace ray
