#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "R2/ToneCurve.h"
#include "rayimg/Options.h"
#include "source/app/Status.h"
#include "source/app/options/AboutOptions.h"
#include "source/app/options/OptionEntry.h"
#include "source/text/Number.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

std::vector<std::string> ToneCurveNames() {
  std::vector<std::string> names;
  for (const R2::ToneCurve& curve : R2::ToneCurves()) names.emplace_back(curve.name);
  return names;
}

/// Parses "1,2,0.5": numbers above 0.
std::optional<std::vector<double>> ReadWeights(const std::string& word) {
  std::vector<double> weights;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find(',', at), word.size());
    const auto number = ParseNumber(std::string_view(word).substr(at, end - at));
    if (number.problem || !(number.value > 0)) return {};
    weights.push_back(number.value);
    at = end + 1;
  }
  return weights;
}

/// Makes the argument of an optional limit. `most`: 0 for no maximum.
template <int most>
std::optional<double> ReadThreshold(const std::string& word) {
  const auto number = ParseNumber(word);
  if (number.problem || !(number.value >= 0) || (most > 0 && number.value > most)) return {};
  return number.value;
}

/// Makes the argument of an optional integer.
template <int least, int most>
std::optional<std::optional<int>> ReadWhole(const std::string& word) {
  const auto number = ParseNumber(word);
  if (number.problem || !(number.value >= least && number.value <= most) || number.value != std::floor(number.value))
    return {};
  return static_cast<int>(number.value);
}

/// Splits "one,two" at its commas.
std::optional<std::vector<std::string>> ReadTexts(const std::string& word) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at <= word.size();) {
    const std::size_t end = std::min(word.find(',', at), word.size());
    texts.push_back(word.substr(at, end - at));
    at = end + 1;
  }
  return texts;
}

/// Returns an empty text, since none of these has a default to show.
template <class T>
std::string ShowNothing(const T&) {
  return {};
}

template <int least, int most, class Lambda>
Word Whole(Lambda member, const char* range) {
  return WordOf<ReadWhole<least, most>, ShowNothing<std::optional<int>>>(member, range);
}

template <int most, class Lambda>
Word Threshold(Lambda member, const char* range) {
  return WordOf<ReadThreshold<most>, ShowNothing<std::optional<double>>>(member, range);
}

#define AT(member) AT_OF(ImageOptions, member)

constexpr OptionNeed a_map{[](const Options& o) { return !As<ImageOptions>(o).map.empty(); }, "without -map"};
constexpr OptionNeed a_limit{[](const Options& o) { return As<ImageOptions>(o).fail.has_value(); }, "without -fail"};

// clang-format would split entries over many lines.
// clang-format off
constexpr std::array commands{
    CommandKind{"diff", "image reference", 2, 2, "measure the difference of an image, or a folder, from a reference", R"(
Means are over all channels of all pixels that are finite in both images; x is the image, r the reference.
  linear RMSE      sqrt(mean (x-r)^2)
  relMSE           mean (x-r)^2 / (r^2 + 0.01)
  display RMSE     RMSE of the displayed values, in 255ths. Those are clamped to 0..1 and, with -srgb, encoded;
                   without it they are used unchanged
  PSNR             -10 log10(mean square) of the same values, in dB
  FLIP             mean perceived difference when the images alternate (Andersson et al. 2020), of the same values
  largest          the largest |x-r|, its pixel (x from the left, y from the bottom) and channel
  bias             mean x-r, channel by channel
With -reference2 c, the same image as r from another random seed, also mean (x-r)(x-c) and its root: the error
without the noise of the reference, which the linear RMSE counts as error of x (how misleading that can be: Whittle et
al. 2017).
With thresholds the exit status is 1 if one is exceeded. Pixels that are NaN or infinite fail every threshold.
With two folders, images with the same name are compared, in any formats; those without a partner are listed, and
subfolders are not searched. Each pair gets a line with its difference, the largest first, and a likely cause if one
explains more than 80% of the squared difference of the displayed values: gamma, upside down, mirrored, transposed,
turned, channels swapped, a constant factor, half a pixel, bytes that wrapped around, another size or format. The exit
status is also 1 for another size and for images without a partner, and 3 if an image cannot be read; the others are
compared nevertheless.
-html writes a self-contained page with the images, FLIP maps and signed differences; it needs no scripts.
)"},
    CommandKind{"info", "image...", 1, any_number, "print the contents of images and how they were made", R"(
Size, format and metadata; the minimum, mean and maximum of the finite stored values of each channel and the mean
luminance (0.30 r + 0.59 g + 0.11 b); the numbers of negative values and of NaN or infinite ones. For an EXR also its
windows and layers, with the channels of each and their types.
)"},
    CommandKind{"extract", "in.exr layer out", 3, 3, "write one layer of an EXR as a separate image", R"(
The layer N is the channels N.X, N.Y and N.Z, or N alone; R, G and B are the layer color. A channel can be named in
full, and becomes a gray image. The values stay floats: the output is an EXR, PFM or HDR.
)"},
    CommandKind{"convert", "in out", 2, 2, "write an image in another format, brighter, tone-mapped or encoded", R"(
Values are multiplied by 2^exposure, mapped by the tone curve, channel by channel, and encoded. Float images (pfm,
hdr, exr) are never encoded. The metadata is kept, and the conversion added to it.
)"},
    CommandKind{"resize", "in out", 2, 2, "write an image in another size", R"(
With -width or -height alone the aspect ratio is kept. Pixels are weighted means of the values, which are linear light
if raypro wrote them; with -srgb they are decoded first. The filters are those of raypro, measured in pixels of the
smaller image: box weights by area and keeps the mean; mitchell and lanczos are sharper, and may overshoot at edges.
Float images (pfm, hdr, exr) stay floats. Alpha and further layers of an EXR are skipped, with a warning.
)"},
    CommandKind{"crop", "in out", 2, 2, "write a part of an image", R"(
The part is given as for raypro -crop: columns x0..x1-1 from the left, rows y0..y1-1 from the bottom. From EXR to EXR
all layers and alpha are cropped too. Float images stay floats.
)"},
    CommandKind{"side-by-side", "image...", 1, any_number, "arrange images in a row, or in rows", R"(
Writes the unchanged images to the file that -out names. Images in a row must have the same height; the rest of a
shorter row is white. Float images stay floats.
)"},
    CommandKind{"contact-sheet", "image|folder...", 1, any_number, "small images with their names on a sheet", R"(
Shows all images of a folder, but not those of its subfolders. Each is shrunk to fit into a square of -width pixels,
by area. An image that cannot be read is shown as a cross, and the exit status is then 3. Floats are shown as rayimg
convert would write them.
)"},
    CommandKind{"merge", "image...", 2, any_number, "average float images of different seeds", R"(
Writes the weighted mean of float images (pfm, hdr, exr) of the same size to the file that -out names. Rejects images
that are not independent (the same scene or command, and a common seed), those of different scenes or settings and those
of interrupted renders.
)"},
    CommandKind{"movie", "out.avi frame.jpg...", 2, any_number, "make a movie from JPEG images", R"(
Writes an AVI file of motion JPEG: the unchanged frames in the given order, and an index. Nothing is encoded again, so
the quality is that of the images. They must be JPEGs of the same size; the same image may be listed more than once.
)"},
};

// clang-format on

// clang-format off
std::vector<OptionKind> OptionsOfCommands() {
  constexpr double most_stops = 64;
  constexpr int most_side = 1'000'000, most_columns = 10'000, most_gap = 1000;
  constexpr double slowest_movie = 0.1, fastest_movie = 1000;
  constexpr KnownTo rayimg = KnownTo::one;
  return {
      {"srgb", rayimg, {}, {}, {}, Flag{AT(srgb)}, "", "",
       "linear workflow: decode 8 and 16 bit images from sRGB, encode displayed and written images",
       {"diff", "convert", "resize", "side-by-side", "contact-sheet"}},
      {"reference2", rayimg, {}, {}, {"image"}, FileName{AT(reference2), FileKind::image}, "", "",
       "a second reference from another random seed, for the error without their noise", {"diff"}},
      {"map", rayimg, {}, {}, {"image"}, FileName{AT(map), FileKind::image}, "", "",
       "write a heat map of the difference, black 0 to white 1", {"diff"}},
      {"map_of", rayimg, Needs{a_map}, {}, {"name"}, OneOfEnum<MapOf>(AT(map_of)), "", "",
       "what the map shows: FLIP, or the largest difference of a displayed channel", {"diff"}},
      {"pixels_per_degree", rayimg, {}, {}, {"x"}, Number<double>{AT(pixels_per_degree), 1, 1000}, "", "",
       "FLIP: pixels per degree of view; by default those of 3840 pixels seen from their own width",
       {"diff"}},
      {"fail", rayimg, {}, {}, {"x"}, Threshold<0>(AT(fail), "a number, at least 0"), "", "",
       "a pixel fails when a channel differs by more than this", {"diff"}},
      {"fail_percent", rayimg, Needs{a_limit}, {}, {"p"}, Threshold<100>(AT(fail_percent), "a number, 0 to 100"), "", "",
       "percentage of the pixels that may fail; 0 by default", {"diff"}},
      {"fail_rmse", rayimg, {}, {}, {"x"}, Threshold<0>(AT(fail_rmse), "a number, at least 0"), "", "",
       "the largest linear RMSE allowed", {"diff"}},
      {"fail_flip", rayimg, {}, {}, {"x"}, Threshold<1>(AT(fail_flip), "a number, 0 to 1"), "", "",
       "the largest mean FLIP allowed", {"diff"}},
      {"json", rayimg, {}, {}, {}, Flag{AT(json)}, "", "",
       "print a JSON object; infinite and unknown values are null", {"diff"}},

      {"html", rayimg, {}, {}, {"page.html"}, FileName{AT(html)}, "", "",
       "write a page that shows each pair", {"diff"}},
      {"csv", rayimg, {}, {}, {"table.csv"}, FileName{AT(csv)}, "", "",
       "write a table with a line for each pair", {"diff"}},

      {"width", rayimg, {}, {}, {"n"},
       Whole<1, most_side>(AT(width), "a whole number, 1 to 1000000"), "pixels", "",
       "width of the new image, or of each on a sheet (160 there by default)", {"resize", "contact-sheet"}},
      {"height", rayimg, {}, {}, {"n"},
       Whole<1, most_side>(AT(height), "a whole number, 1 to 1000000"), "pixels", "",
       "height of the new image", {"resize"}},
      {"filter", rayimg, {}, {}, {"name"}, OneOfEnum<FilterKind>(AT(filter)), "", "",
       "reconstruction filter", {"resize"}},
      {"crop", rayimg, {}, {}, {"x0", "y0", "x1", "y1"}, ray::Rectangle{AT(crop)}, "pixels", "",
       "only columns x0..x1-1 from the left, rows y0..y1-1 from the bottom", {"crop"}},
      {"columns", rayimg, {}, {}, {"n"},
       Whole<1, most_columns>(AT(columns), "a whole number, 1 to 10000"), "", "",
       "images in a row; by default all side by side, and a sheet about as wide as high",
       {"side-by-side", "contact-sheet"}},
      {"gap", rayimg, {}, {}, {"n"}, Whole<0, most_gap>(AT(gap), "a whole number, 0 to 1000"), "pixels", "",
       "white between images; by default 0 side by side and 8 on a sheet", {"side-by-side", "contact-sheet"}},
      {"captions", rayimg, Excludes{"names"}, {}, {"a,b,..."},
       WordOf<ReadTexts, ShowNothing<std::vector<std::string>>>(AT(captions),
        "texts separated by commas"), "", "", "words below each image, one text per image", {"side-by-side"}},
      {"names", rayimg, {}, {}, {},
       Flag{AT(captions_are_names)}, "", "", "write the file's name below each image",
       {"side-by-side"}},

      {"exposure", rayimg, {}, {}, {"stops"}, Number<double>{AT(exposure), -most_stops, most_stops}, "", "",
       "multiply by two to this power", {"convert", "contact-sheet"}},
      {"tonemap", rayimg, {}, {}, {"name"}, OneOfNames(AT(tonemap), ToneCurveNames), "", "",
       "reinhard: x/(1+x), Reinhard 2002; aces: Narkowicz 2015; filmic: Hable 2010", {"convert", "contact-sheet"}},
      {"bits", rayimg, {}, {}, {"n"}, OneNumberOf{AT(bits), {8, 16}}, "bits per channel", "",
       "bit depth of a PNG", {"convert", "resize", "crop", "side-by-side"}},
      {"jpeg_quality", rayimg, {}, {}, {"n"}, Number<int>{AT(jpeg_quality), 1, 100}, "", "", "JPEG quality",
       {"convert", "resize", "crop", "side-by-side", "contact-sheet"}},

      {"out", rayimg, {}, {}, {"image"}, FileName{AT(out), FileKind::image}, "", "", "the image to write",
       {"side-by-side", "contact-sheet", "merge"}},
      {"weights", rayimg, {}, {}, {"w1,w2,..."},
       WordOf<ReadWeights, ShowNothing<std::vector<double>>>(AT(weights),
        "numbers above 0, separated by commas"), "", "",
       "one per image; by default the samples in the metadata, if all have them, else equal", {"merge"}},
      {"force", rayimg, {}, {}, {}, Flag{AT(force)}, "", "",
       "merge images even if they are dependent, unlike or were interrupted", {"merge"}},

      {"fps", rayimg, {}, {}, {"n"}, Number<double>{AT(fps), slowest_movie, fastest_movie}, "", "",
       "frames per second", {"movie"}},
  };
}
// clang-format on

#undef AT

/// Throws UsageError if options of the command contradict each other, or one is missing.
void CheckTogether(const ImageOptions& options) {
  const std::string name = options.command->name;
  const auto count = [&](std::size_t given, const std::string& option, const std::string& noun) {
    if (given > 0 && given != options.names.size())
      throw UsageError(option + " has " + Counted(given, noun) + " for " + Counted(options.names.size(), "image"));
  };
  for (const std::string& given : options.given)
    if (const std::string why = options.WhyWithoutEffect(*FindOption(Program::rayimg, given)); !why.empty())
      throw UsageError("-" + given + " has no effect " + why);
  const bool writes_one = name == "merge" || name == "side-by-side" || name == "contact-sheet";
  if (writes_one && options.out.empty()) throw UsageError(name + " needs -out image, the image to write");
  if (name == "resize" && !options.width && !options.height)
    throw UsageError("resize needs -width n or -height n, in pixels, or both");
  if (name == "crop" && !options.crop) throw UsageError("crop needs -crop x0 y0 x1 y1, in pixels from the lower left");
  count(options.captions.size(), "-captions", "text");
  count(options.weights.size(), "-weights", "number");
}

const std::vector<OptionKind>& Table() {
  static const std::vector<OptionKind> table = WithAboutOptions<Program::rayimg>(OptionsOfCommands());
  return table;
}

}  // namespace
}  // namespace ray::rayimg

namespace ray {

const Program Program::rayimg{
    .name = "rayimg",
    .file_names = "command images",
    .summary = "compare, describe, convert and merge images, and make movies of them",
    .description =
        "Compares, describes, converts and merges images, and makes movies of them. Extensions choose the formats\n"
        "of written images, contents those of read ones. rayimg -help command lists the options of a command.\n",
    .examples =
        "  rayimg diff noisy.exr clean.exr -map where.png -fail_flip 0.05\n"
        "  rayimg convert out.exr out.jpg -exposure 1 -tonemap filmic -srgb\n"
        "  rayimg merge seed1.exr seed2.exr seed3.exr -out mean.exr\n"
        "  rayimg movie turn.avi -fps 25 turn01.jpg turn02.jpg turn03.jpg\n",
    .statuses = {{"0", "Success."},
                 {"1", "diff: beyond a threshold."},
                 {"2", "Wrong arguments."},
                 {"3", "An image is missing, damaged or too large."},
                 {"4", "A file cannot be written."}},
    .failed = status::bad_scene,  // status 1 means only that images differ: scripts rely on it
    .options = rayimg::Table,
    .commands = [] { return std::span<const CommandKind>(rayimg::commands); },
    .defaults = []() -> std::unique_ptr<Options> { return std::make_unique<rayimg::ImageOptions>(); },
    .complete =
        [](Options& options, std::span<const std::string>) {
          if (!options.request) rayimg::CheckTogether(As<rayimg::ImageOptions>(options));
        }};

}  // namespace ray
