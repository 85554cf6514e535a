#include "rayimg/PairResult.h"

#include "R2/Ramp.h"
#include "grader/Html.h"
#include "rayimg/Images.h"
#include "source/app/report/Messages.h"
#include "source/film/Resize.h"
#include "source/parse/SceneError.h"
#include "source/text/NumberText.h"

namespace ray::rayimg {
namespace {

std::string SizeText(const R2::Image& image) {
  return std::to_string(image.Width()) + "x" + std::to_string(image.Height());
}

/// Scales an image down for a page.
R2::Image ForPage(const R2::Image& image) {
  constexpr int widest = 640;
  if (image.Width() <= widest) return image;
  const auto height = std::max<std::int64_t>(1, std::int64_t{image.Height()} * widest / image.Width());
  return Resized(image, widest, static_cast<int>(height), FilterKind::box);
}

std::string Figure(const std::string& content, const std::string& caption) {
  return "<figure>" + content + "<figcaption>" + grade::HtmlOf(caption) + "</figcaption></figure>\n";
}

/// Returns figures of both images, one over the other, and of their difference.
std::string Figures(const R2::Image& image, const R2::Image& reference, const R2::Plane& flip,
                    const ImageOptions& options) {
  const R2::Image x = Displayed(image, DisplayOf(options)), r = Displayed(reference, DisplayOf(options));
  return Figure(grade::Slider(ForPage(x), "image", ForPage(r), "reference"),
                "the image over the reference; drag its lower right corner") +
         Figure(grade::ImageTag(ForPage(RampImage(flip)), "FLIP"), "FLIP: black 0, white 1") +
         Figure(grade::ImageTag(ForPage(SignedDifference(x, r)), "difference"),
                "difference times 4: red too bright, blue too dark");
}

std::string TwoFigures(const R2::Image& image, const R2::Image& reference, const ImageOptions& options) {
  return Figure(grade::ImageTag(ForPage(Displayed(image, DisplayOf(options))), "image"), "image") +
         Figure(grade::ImageTag(ForPage(Displayed(reference, DisplayOf(options))), "reference"), "reference");
}

std::string Formats(const R2::DecodedImage& decoded, const R2::DecodedImage& reference) {
  if (decoded.format == reference.format) return {};
  return std::string("a ") + decoded.format->name + " against a " + reference.format->name;
}

PairResult OfOtherSize(const Pair& pair, const R2::DecodedImage& decoded, const R2::DecodedImage& reference,
                       const ImageOptions& options) {
  return {.pair = pair,
          .outcome = Outcome::other_size,
          .remark = "has " + SizeText(decoded.image) + " pixels, the reference " + SizeText(reference.image),
          .found = {},
          .cause = grade::LikelyCause(decoded, reference),
          .figures = options.html.empty() ? "" : TwoFigures(decoded.image, reference.image, options)};
}

}  // namespace

PairResult ResultOf(const Pair& pair, const R2::DecodedImage& decoded, const R2::DecodedImage& reference,
                    const Measurement& measured, const ImageOptions& options) {
  const bool is_equal = decoded.image == reference.image;
  return {.pair = pair,
          .outcome = !measured.found.failures.empty() ? Outcome::fails
                     : is_equal                       ? Outcome::equal
                                                      : Outcome::differs,
          .remark = Formats(decoded, reference),
          .found = measured.found,
          .cause = grade::LikelyCause(decoded, reference),
          .figures = options.html.empty() ? "" : Figures(decoded.image, reference.image, measured.flip_map, options)};
}

PairResult Compared(const Pair& pair, const ImageOptions& options) {
  try {
    const R2::DecodedImage decoded = ReadLight(pair.image, options.srgb);
    const R2::DecodedImage reference = ReadLight(pair.reference, options.srgb);
    const R2::Image &x = decoded.image, &r = reference.image;
    if (x.Width() != r.Width() || x.Height() != r.Height()) return OfOtherSize(pair, decoded, reference, options);
    return ResultOf(pair, decoded, reference, Measure(x, r, options), options);
  } catch (const SceneErrors& errors) {
    PrintError(errors.what());
    const SceneError& first = errors.All().front();
    return {.pair = pair,
            .outcome = Outcome::unreadable,
            .remark = (first.file == pair.image ? "" : "the reference: ") + first.message,
            .found = {},
            .cause = {},
            .figures = {}};
  }
}

std::string Summary(const PairResult& result) {
  std::string text = result.remark;
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (result.outcome == Outcome::equal) add("equal");
  if (result.cause)
    add(result.cause->title +
        (result.cause->share < 1 ? " (" + ray::Rounded(100 * result.cause->share, 3) + "% of the difference)" : ""));
  if (result.found)
    for (const std::string& failure : result.found->failures) add("fails: " + failure);
  return text;
}

}  // namespace ray::rayimg
