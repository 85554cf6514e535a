#include <hwy/targets.h>

#include <limits>

#include "R2/image_files/formats.h"
#include "page/Warnings.h"
#include "source/app/Answers.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/app/report/Resources.h"
#include "source/film/denoise/OpenImageDenoise.h"
#include "source/render/Threads.h"

// What the engine asks of a machine and its libraries, answered for a page.

namespace hwy {

// One instruction set is compiled, so nothing is chosen at run time.
int64_t SupportedTargets() { return HWY_STATIC_TARGET; }
void SetSupportedTargetsForTest(int64_t) {}
ChosenTarget& GetChosenTarget() {
  static ChosenTarget target;
  return target;
}

}  // namespace hwy

namespace ray {

int ThreadsAvailable(int) { return 1; }
int ThreadsFor(int) { return 1; }
void ForEachOnThreads(int, int count, const std::function<void(int)>& task) {
  for (int i = 0; i < count; ++i) task(i);
}

double CpuSeconds() { return 0; }
std::int64_t PeakMemory() { return std::int64_t{65536} * static_cast<std::int64_t>(__builtin_wasm_memory_size(0)); }
std::int64_t MachineMemory() { return std::int64_t{1} << 32; }

void PrintError(const std::string& line) { Warnings() += line + "\n"; }
void PrintWarnings(const std::string& file, std::span<const std::string> warnings) {
  for (const std::string& warning : warnings) PrintError(file + ": warning: " + warning);
}

// A page names the image that it renders to, so no file beside the scene is looked at.
std::vector<unsigned char> ReadBytes(const std::string&) { return {}; }

// Requests are refused before they would be answered.
namespace answer {
std::string Check(const Options&) { return {}; }
std::string Files(const Options&) { return {}; }
std::string Advise(const Options&) { return {}; }
std::string Convert(const Options&) { return {}; }
std::string RaysOfPixel(const Options&) { return {}; }
std::string Info(const Options&) { return {}; }
std::string Help(const Options&) { return {}; }
std::string Version(const Options&) { return {}; }
std::string List(const Options&) { return {}; }
std::string Complete(const Options&) { return {}; }
std::string Manual(const Options&) { return {}; }
}  // namespace answer

struct OpenImageDenoise::Functions {};
OpenImageDenoise::OpenImageDenoise(int) : OpenImageDenoise(FindFunction(), 0) {}
OpenImageDenoise::OpenImageDenoise(const FindFunction&, int) : device_(nullptr, nullptr) {
  throw DenoiserError("Open Image Denoise is not available in a browser");
}
OpenImageDenoise::~OpenImageDenoise() = default;
bool OpenImageDenoise::IsPresent() { return false; }
std::string OpenImageDenoise::Version() const { return {}; }
Pixels<Rgb> OpenImageDenoise::Filtered(const Pixels<Rgb>& colors, const Pixels<PixelGuide>&) const { return colors; }

}  // namespace ray

namespace R2 {
namespace {

bool IsJpeg(std::span<const unsigned char> b) { return b.size() > 2 && b[0] == 0xff && b[1] == 0xd8 && b[2] == 0xff; }
bool IsPng(std::span<const unsigned char> b) { return b.size() > 3 && b[0] == 0x89 && b[1] == 'P' && b[2] == 'N'; }

// The page turns these into PPM before a scene is opened; one that is still here could not be read.
[[noreturn]] void Refuse() { throw ImageError("the browser cannot read this image"); }
ImageSize SizeOf(std::span<const unsigned char>) { Refuse(); }
DecodedImage Decode(std::span<const unsigned char>) { Refuse(); }
std::vector<unsigned char> Encode(const Image&, const ImageEncoding&, const ImageSettings&) { Refuse(); }

}  // namespace

extern const ImageFormat jpeg_format{"jpeg", {"jpg", "jpeg"}, IsJpeg, SizeOf, Decode, Encode, false};
extern const ImageFormat png_format{"png", {"png"}, IsPng, SizeOf, Decode, Encode, false};

}  // namespace R2
