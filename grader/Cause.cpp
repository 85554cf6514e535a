#include "grader/Cause.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "R2/compare/Difference.h"
#include "grader/Changes.h"
#include "grader/Mistake.h"
#include "grader/JpegTolerance.h"
#include "grader/PixelShift.h"
#include "source/text/NumberText.h"

namespace ray::grade {
namespace {

using R2::Color;
using R2::Image;

bool AreOfOneSize(const Image& a, const Image& b) { return a.Width() == b.Width() && a.Height() == b.Height(); }

/// Returns the sum of the squared differences of displayed channels, beyond those of rounding to bytes.
double SquaresBeyondRounding(const Image& a, const Image& b) {
  constexpr float rounding = 1.5F / 255;
  const auto &p = a.Channels(), &q = b.Channels();
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double beyond = std::max(0.0F, std::abs(p[i] - q[i]) - rounding);
    sum += beyond * beyond;
  }
  return sum;
}

Image Shown(const Image& image) { return R2::Displayed(image, R2::Display::straight); }

/// A search for the cause that explains most.
class Search {
 public:
  Search(const Image& image, const Image& reference)
      : shown_image_(Shown(image)),
        shown_reference_(Shown(reference)),
        of_reference_(AreOfOneSize(image, reference) ? SquaresBeyondRounding(shown_image_, shown_reference_) : 1) {}

  bool IsRounding() const { return !(of_reference_ > 0); }
  const Image& image() const { return shown_image_; }
  const Image& reference() const { return shown_reference_; }

  /// Tries a cause. `made`: the reference with the cause applied.
  void Try(const Image& made, const std::string& name, const std::string& title, const std::string& hint = {}) {
    if (AreOfOneSize(made, shown_image_))
      Keep({name, title, hint, 1 - SquaresBeyondRounding(Shown(made), shown_image_) / of_reference_});
  }
  /// Tries a cause in the reference. `made`: the image with the cause applied.
  void TryInReference(const Image& made, const std::string& name, const std::string& title, const std::string& hint) {
    if (AreOfOneSize(made, shown_reference_))
      Keep({name + "_in_reference", "in the reference " + title, hint,
            1 - SquaresBeyondRounding(Shown(made), shown_reference_) / of_reference_});
  }
  void Keep(const Cause& cause) {
    constexpr double clearly = 0.005;  // remainder of equal images after rounding to bytes
    if (cause.share > (best_ ? best_->share + clearly : named_above)) best_ = cause;
  }

  const std::optional<Cause>& Best() const { return best_; }

 private:
  Image shown_image_, shown_reference_;
  double of_reference_;  // 1 if the sizes differ
  std::optional<Cause> best_;
};

/// Tries rotations that may swap width and height; those that never do are mistakes of the table.
void TryTurns(Search& search, const Image& r) {
  const int width = r.Height(), height = r.Width();
  const auto turned = [&](const auto& from) { return Moved(r, width, height, from); };
  search.Try(turned([&](int x, int y) {
               return PixelPlace{r.Width() - 1 - y, r.Height() - 1 - x};
             }),
             "transposed", "rows and columns are swapped", "Which of two loops is the outer one?");
  search.Try(turned([&](int x, int y) {
               return PixelPlace{y, r.Height() - 1 - x};
             }),
             "turned_left", "the image is turned by a quarter to the left");
  search.Try(turned([&](int x, int y) {
               return PixelPlace{r.Width() - 1 - y, x};
             }),
             "turned_right", "the image is turned by a quarter to the right");
  search.Try(turned([&](int x, int y) {
               return PixelPlace{y, x};
             }),
             "transposed_and_turned", "rows and columns are swapped, and the image turned by half a turn");
}

void TryMistakes(Search& search, const Image& image, const Image& reference) {
  for (const Mistake* mistake : Mistakes())
    if (mistake->of_image) search.Try(mistake->of_image(reference), mistake->name, mistake->title, mistake->hint);
  for (const Mistake* mistake : Mistakes())
    if (mistake->of_image)
      search.TryInReference(mistake->of_image(image), mistake->name, mistake->title, mistake->hint);
}

void TryOrders(Search& search, const Image& r) {
  // Red and blue swapped is a mistake of the table.
  struct Order {
    const char* name;
    Color (*of)(const Color&);
  };
  static constexpr std::array<Order, 4> orders{{{"g r b",
                                                 [](const Color& c) {
                                                   return Color{c.g, c.r, c.b};
                                                 }},
                                                {"r b g",
                                                 [](const Color& c) {
                                                   return Color{c.r, c.b, c.g};
                                                 }},
                                                {"g b r",
                                                 [](const Color& c) {
                                                   return Color{c.g, c.b, c.r};
                                                 }},
                                                {"b r g", [](const Color& c) {
                                                   return Color{c.b, c.r, c.g};
                                                 }}}};
  for (const Order& order : orders)
    search.Try(EachColor(r, order.of), "channels_permuted",
               std::string("channels are swapped: stored in the order ") + order.name,
               "In which order does the file want its channels?");
}

/// Tries one factor for all channels, by least squares where neither value is clamped.
void TryFactor(Search& search, const Image& image, const Image& reference) {
  const auto &x = search.image().Channels(), &r = search.reference().Channels();
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] < 1 && r[i] < 1)) continue;
    products += double{x[i]} * r[i];
    squares += double{r[i]} * r[i];
  }
  if (!(squares > 0)) return;
  const double factor = products / squares;
  search.Try(EachColor(reference, [&](const Color& c) { return factor * c; }), "scaled",
             "every value is " + Plain(factor, 3) + " times that of the reference",
             "Is there a constant factor, such as pi or a number of samples?");
  if (!(factor > 0)) return;
  search.TryInReference(EachColor(image, [&](const Color& c) { return c / factor; }), "scaled",
                        "every value is " + Plain(1 / factor, 3) + " times that of the image",
                        "Does the image lack a factor, such as pi?");
}

/// Tries values that wrap around. A reference of bytes does not contain values above 1, but the places where it is 1:
/// there, and nowhere else, the image differs.
void TryWrapped(Search& search) {
  constexpr float saturated = 254.5F / 255, much = 0.25F;
  const auto &x = search.image().Channels(), &r = search.reference().Channels();
  double all = 0, explained = 0;
  bool is_far = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = double{x[i]} - r[i];
    all += d * d;
    if (r[i] < saturated) continue;
    explained += d * d;
    is_far = is_far || r[i] - x[i] > 1 - much;
  }
  const auto wrapped =
      std::ranges::find_if(Mistakes(), [](const Mistake* one) { return std::string_view(one->name) == "wrapped"; });
  if (is_far && wrapped != Mistakes().end())
    search.Keep({(*wrapped)->name, (*wrapped)->title, (*wrapped)->hint, explained / all});
}

void TryShift(Search& search) {
  const auto shift = BestShift(search.image(), search.reference());
  if (!shift) return;
  const auto words = [](int halves, const char* positive, const char* negative) {
    return std::string(std::abs(halves) == 1 ? "half a pixel" : "a pixel") + (halves > 0 ? positive : negative);
  };
  std::string way;
  if (shift->halves_right != 0) way = words(shift->halves_right, " to the right", " to the left");
  if (shift->halves_up != 0) way += (way.empty() ? "" : " and ") + words(shift->halves_up, " up", " down");
  const bool is_half = std::abs(shift->halves_right) == 1 || std::abs(shift->halves_up) == 1;
  search.Keep({is_half ? "half_a_pixel" : "one_pixel", "the image is shifted by " + way,
               is_half ? "Does a ray go through the middle of its pixel, (x + 0.5) / width?"
                       : "Does the first pixel have number 0?",
               shift->share});
}

/// Returns the loss of the files' formats, if that explains the whole difference.
std::optional<Cause> OfFormat(const Search& search, const R2::DecodedImage& image, const R2::DecodedImage& reference) {
  const auto name = [](const R2::DecodedImage& one) { return std::string(one.format->name); };
  if (search.IsRounding()) {
    if (image.format->is_linear != reference.format->is_linear)
      return Cause{"format",
                   "a " + (image.format->is_linear ? name(reference) : name(image)) +
                       " stores only quantized values from 0 to 1; otherwise the images are equal",
                   "", 1};
    return Cause{"rounding", "displayed values differ by at most 1/255", "", 1};
  }
  if (name(image) != "jpeg" && name(reference) != "jpeg") return {};
  if (!DiffersLikeJpeg(search.image(), search.reference())) return {};
  return Cause{"format", "the difference is that of compressing the reference as JPEG", "", 1};
}

}  // namespace

std::optional<Cause> LikelyCause(const R2::DecodedImage& image, const R2::DecodedImage& reference) {
  if (image.image == reference.image) return {};
  Search search(image.image, reference.image);
  const bool have_one_size = AreOfOneSize(image.image, reference.image);
  if (have_one_size)
    if (const auto cause = OfFormat(search, image, reference)) return cause;
  TryTurns(search, reference.image);
  if (!have_one_size) return search.Best();
  TryMistakes(search, image.image, reference.image);
  TryOrders(search, reference.image);
  TryFactor(search, image.image, reference.image);
  TryWrapped(search);
  constexpr double as_good_as_all = 0.98;
  if (!search.Best() || search.Best()->share < as_good_as_all) TryShift(search);
  return search.Best();
}

}  // namespace ray::grade
