#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "source/app/Status.h"

namespace ray::rayimg {

int Convert(const ImageOptions& options, const std::string& command_line) {
  const std::string& in = options.names[0];
  const std::string inputs[] = {in};
  const ImageOutput output = CheckImageOutput(options.names[1], inputs);
  const R2::ImageEncoding encoding = EncodingOf(options, output);

  R2::DecodedImage decoded = ReadLight(in, options.srgb);
  Expose(decoded.image, options);
  AddCommand(decoded.settings, command_line);
  Write(output, decoded.image, encoding, decoded.settings);
  return status::done;
}

}  // namespace ray::rayimg
