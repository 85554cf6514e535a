#include "source/app/Status.h"
#include "source/rayimg/Commands.h"
#include "source/rayimg/Pictures.h"

namespace ray::rayimg {

int Convert(const ImageOptions& options, const std::string& command_line) {
  const std::string& in = options.names[0];
  const std::string inputs[] = {in};
  const PictureOutput output = CheckPictureOutput(options.names[1], inputs);
  const R2::ImageEncoding encoding = EncodingOf(options, output);

  R2::DecodedImage picture = ReadLight(in, options.srgb);
  Expose(picture.image, options);
  AddCommand(picture.settings, command_line);
  Write(output, picture.image, encoding, picture.settings);
  return status::done;
}

}  // namespace ray::rayimg
