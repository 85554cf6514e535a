#include "source/app/files/Outputs.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "source/app/Status.h"
#include "source/app/files/LayerImages.h"
#include "source/app/options/FileNames.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/app/report/ReportJson.h"
#include "source/render/Layer.h"
#include "source/text/EnumNames.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

[[noreturn]] void RefuseExtension(const std::string& name) {
  std::string known;
  for (const R2::ImageFormat& format : R2::ImageFormats())
    for (const char* extension : format.extensions) known += " ." + std::string(extension);
  const std::string extension = std::filesystem::path(name).extension().string();
  throw UsageError((extension.empty() ? Quoted(name) + " has no extension" : "cannot write " + Quoted(extension)) +
                   "; use" + known);
}

std::span<const unsigned char> BytesOf(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

/// Throws if standard output is closed, before the work begins.
void RefuseClosedOutput() {
  const int flags = fcntl(STDOUT_FILENO, F_GETFL);
  if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
    throw OutputError("cannot write 'standard output': " + std::generic_category().message(EBADF));
}

ImageOutput StandardOutput() {
  RefuseClosedOutput();
  if (isatty(STDOUT_FILENO)) throw UsageError("the image would go to a terminal; redirect it, or name a file");
  return {FormatOfImage(standard_stream), {.name = "<stdout>", .target = {}, .is_standard_output = true}};
}

/// Throws if the report has the name of a file that a render writes in addition to the image.
void RefuseOwnFile(const OutputFile& report, const FileOptions& files) {
  const std::string partial = PartialName(files.image);
  std::vector<std::string> names{partial, files.image + ".checkpoint", partial + ".checkpoint"};
  for (const Layer layer : files.layers) names.push_back(NameBeside(files.image, NameOf(layer)));
  for (const std::string& name : names)
    if (report.target.lexically_normal() == std::filesystem::path(name).lexically_normal())
      throw UsageError("the report cannot be " + Quoted(report.name) + ": the render writes a file of that name");
}

}  // namespace

std::string PartialName(const std::string& image_name) { return NameBeside(image_name, "partial"); }

bool IsFinishedImage(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return false;
  try {
    const R2::ImageSettings settings = R2::ReadImageHeader(ReadBytes(file.string())).settings;
    const auto pixels = settings.find("pixels");
    return pixels == settings.end() || pixels->second == "complete";
  } catch (const std::exception&) {
    return true;  // not an image, or unreadable: not ours
  }
}

/// Throws for sizes that the format cannot store; some are limited to 65,535 pixels per side. Encoding an image of one
/// row or one column shows that before an hour of rendering.
void RefuseSize(const R2::ImageFormat& format, int width, int height) {
  constexpr int every_format_holds = 32'767;
  try {
    if (width > every_format_holds) format.encode(R2::Image(width, 1), {}, {});
    if (height > every_format_holds) format.encode(R2::Image(1, height), {}, {});
  } catch (const R2::ImageError& error) {
    throw UsageError("an image of " + std::to_string(width) + "x" + std::to_string(height) + " cannot be saved as " +
                     format.name + ": " + error.what());
  }
}

ImageOutput CheckImageOutput(const std::string& name, std::span<const std::string> inputs) {
  const R2::ImageFormat* const format = R2::FormatForName(name);
  // An existing folder or device is rejected as such.
  std::error_code ignored;
  if (!format && !std::filesystem::exists(name, ignored)) RefuseExtension(name);
  const OutputFile file = CheckOutput(name, inputs);
  if (!format) RefuseExtension(name);
  return {format, file};
}

void WarnOfLink(const Program& program, const OutputFile& image) {
  if (image.is_link)
    PrintError(NameOf(program) + ": " + Quoted(image.name) + " is a link; the image goes to " +
               QuotedPath(image.target.string()));
}

std::vector<std::string> InputsOf(const FileOptions& files) {
  std::vector<std::string> inputs = files.reference;
  inputs.push_back(files.scene);
  if (!files.replay.empty()) inputs.push_back(files.replay);
  return inputs;
}

Outputs CheckOutputs(const FileOptions& files, const PixelRectangle& part) {
  const std::vector<std::string> inputs = InputsOf(files);
  const bool is_standard_output = files.image == standard_stream;
  const ImageOutput image = is_standard_output ? StandardOutput() : CheckImageOutput(files.image, inputs);
  Outputs outputs;
  outputs.format = image.format;
  outputs.image = image.file;
  if (!is_standard_output) outputs.partial = CheckOutput(PartialName(files.image), inputs);

  RefuseSize(*outputs.format, part.Width(), part.Height());

  if (!outputs.format->encode_layers)
    for (const Layer layer : files.layers)
      outputs.layers.push_back(CheckOutput(NameBeside(files.image, NameOf(layer)), inputs));

  if (files.report.empty()) return outputs;
  outputs.report = CheckOutput(files.report, inputs);
  if (outputs.report->target == outputs.image.target)
    throw UsageError("the image and the report are the same file, " + Quoted(files.report));
  if (!is_standard_output) RefuseOwnFile(*outputs.report, files);
  return outputs;
}

void RefuseInputs(const Outputs& outputs, std::span<const std::string> inputs) {
  RefuseInputs(outputs.image, inputs);
  RefuseInputs(outputs.partial, inputs);
  for (const OutputFile& layer : outputs.layers) RefuseInputs(layer, inputs);
  if (outputs.report) RefuseInputs(*outputs.report, inputs);
}

OutputFile WriteImage(const Outputs& outputs, const RenderResult& result, const std::vector<R2::Image>& layers,
                      const RunStats& stats) {
  const bool must_stay = !result.IsComplete() && IsFinishedImage(outputs.image.target);
  const OutputFile& file = must_stay ? outputs.partial : outputs.image;
  if (result.pixels_done == 0) return file;
  WarnOfLink(*stats.options.program, file);
  const R2::ImageFormat& format = *outputs.format;
  const R2::ImageSettings settings = SettingsInImage(stats);
  const std::vector<Layer>& kinds = stats.options.files.layers;
  const auto encode = [&](std::optional<RenderMode> mode, const R2::Image& image) {
    const R2::ImageEncoding& encoding = stats.options.encoding;
    const bool is_shown_as_it_is = format.is_linear || !mode || IsShownAsItIs(*mode);
    if (is_shown_as_it_is) return format.encode(image, encoding, settings);  // without a copy
    return format.encode(LayerAsShown(*mode, image), encoding, settings);
  };
  if (format.encode_layers && !kinds.empty()) {
    std::vector<R2::ImageLayer> channels;
    for (std::size_t i = 0; i < layers.size(); ++i) channels.push_back(ChannelsOf(kinds[i], layers[i]));
    WriteWhole(file, format.encode_layers(result.image, channels, settings));
    return file;
  }
  WriteWhole(file, encode(stats.options.render.mode, result.image));
  for (std::size_t i = 0; i < layers.size(); ++i) WriteWhole(outputs.layers[i], encode(ModeOf(kinds[i]), layers[i]));
  return file;
}

void WriteReport(const Outputs& outputs, const RunStats& stats) {
  if (outputs.report) WriteWhole(*outputs.report, BytesOf(ReportJson(stats)));
}

}  // namespace ray
