#include "source/app/rayview/ViewOutputs.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <vector>

#include "source/app/Status.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

/// An output and the option that names it.
struct NamedOutput {
  const char* option;
  const OutputFile* file;
};

std::vector<NamedOutput> Named(const ViewOutputs& outputs) {
  std::vector<NamedOutput> named;
  if (outputs.image) named.push_back({"-image", &outputs.image->file});
  if (outputs.output_image) named.push_back({"-output_image", &outputs.output_image->file});
  if (outputs.screenshot) named.push_back({"-screenshot", &outputs.screenshot->file});
  if (outputs.record) named.push_back({"-record", &*outputs.record});
  return named;
}

// Rejects equal outputs, where the last one would overwrite the others.
void RefuseEqualOutputs(const ViewOutputs& outputs) {
  const auto named = Named(outputs);
  for (std::size_t i = 0; i < named.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code ignored;
      const auto& [one, other] = std::tie(named[j].file->target, named[i].file->target);
      if (one == other || std::filesystem::equivalent(one, other, ignored))
        throw UsageError(named[j].option + std::string(" and ") + named[i].option + " are the same file, " +
                         Quoted(named[i].file->name));
    }
}

bool IsNew(const std::string& name) {
  const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor >= 0) {
    close(descriptor);
    return true;
  }
  if (errno == EEXIST) return false;
  throw OutputError("cannot write " + Quoted(name) + ": " + std::generic_category().message(errno));
}

}  // namespace

ViewOutputs CheckViewOutputs(const FileOptions& files, const ViewOptions& view, int width, int height) {
  std::vector<std::string> inputs{files.scene};
  if (!view.events.empty() && view.events != "-") inputs.push_back(view.events);
  if (!view.reference.empty()) inputs.push_back(view.reference);
  const auto image_output = [&](const std::string& name) {
    return name.empty() ? std::nullopt : std::optional(CheckImageOutput(name, inputs));
  };
  ViewOutputs outputs{image_output(files.image), image_output(view.output_image), image_output(view.screenshot), {}};
  if (!view.record.empty()) outputs.record = CheckOutput(view.record, inputs);
  for (const auto* output : {&outputs.image, &outputs.output_image, &outputs.screenshot})
    if (*output) RefuseSize(*(*output)->format, width, height);
  RefuseEqualOutputs(outputs);
  return outputs;
}

void RefuseInputs(const ViewOutputs& outputs, std::span<const std::string> inputs) {
  for (const NamedOutput& output : Named(outputs)) RefuseInputs(*output.file, inputs);
}

ImageOutput ClaimImageName(const std::string& extension) {
  for (int number = 1;; ++number) {
    const std::string name = "image" + std::to_string(number) + "." + extension;
    if (IsNew(name)) return {R2::FormatForName(name), {.name = name, .target = name}};
  }
}

}  // namespace ray
