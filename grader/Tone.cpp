#include "grader/Tone.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"
#include "grader/Changes.h"
#include "source/text/NumberText.h"

namespace ray::grade {
namespace {

using Channels = std::array<double, 3>;

Channels Of(const R2::Color& c) { return {c.r, c.g, c.b}; }

/// Sums over pixels for fitting a line to pairs of values, by least squares.
struct Line {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;

  void Add(double in, double out) { ++n, x += in, y += out, xx += in * in, xy += in * out; }
  Line operator+(const Line& b) const { return {n + b.n, x + b.x, y + b.y, xx + b.xx, xy + b.xy}; }

  double Factor() const { return xx > 0 ? xy / xx : 1; }
  double Offset() const { return n > 0 ? (y - x) / n : 0; }
  double Slope() const {
    const double determinant = n * xx - x * x;
    return determinant > 0 ? (n * xy - x * y) / determinant : 1;
  }
  double Intercept() const { return n > 0 ? (y - Slope() * x) / n : 0; }
};

/// Returns true if clamping changed neither value.
bool IsWithin(double in, double out) {
  constexpr double low = 2.0 / 255, high = 1 - low;
  return in > low && in < high && out > low && out < high;
}

std::array<Line, 3> LinesOf(std::span<const TonePair> pairs) {
  std::array<Line, 3> lines;
  for (const auto& [image, light, counts] : pairs)
    for (int y = 0; y < image.Height(); ++y)
      for (int x = 0; x < image.Width(); ++x) {
        if (!counts[static_cast<std::size_t>(y * image.Width() + x)]) continue;
        const Channels in = Of(light.At(x, y)), out = Of(image.At(x, y));
        for (std::size_t i = 0; i < 3; ++i)
          if (IsWithin(in[i], out[i])) lines[i].Add(in[i], out[i]);
      }
  return lines;
}

std::string Times(double factor) { return Plain(factor, 2) + " times as large"; }

/// Returns changes by one factor for all channels, by one for each, by an offset, or by both.
std::vector<Tone> LinearTones(const std::array<Line, 3>& lines) {
  const Line all = lines[0] + lines[1] + lines[2];
  std::vector<Tone> tones;
  for (const bool before : {false, true}) {
    const double k = all.Factor();
    tones.push_back({.name = "scaled",
                     .title = "all values are " + Times(k) + " as they should be",
                     .hint = "Is there a constant factor, such as pi or a number of lights or samples?",
                     .factor = {k, k, k},
                     .before_clamping = before});
  }
  const double d = all.Offset();
  tones.push_back({.name = "offset",
                   .title = Plain(std::abs(d), 2) +
                            (d < 0 ? " is subtracted from all values" : " is added to all values"),
                   .hint = "Is a constant added to each pixel, the background's included?",
                   .offset = {d, d, d}});
  const double a = all.Slope(), b = all.Intercept();
  tones.push_back({.name = "contrast",
                   .title = "contrast and brightness are changed: values are " + Plain(b, 2) + " plus " +
                            Plain(a, 2) + " times what they should be",
                   .hint = "What is done to each value before it is written?",
                   .factor = {a, a, a},
                   .offset = {b, b, b},
                   .free_numbers = 2});
  const Channels each{lines[0].Factor(), lines[1].Factor(), lines[2].Factor()};
  tones.push_back({.name = "channels_scaled",
                   .title = "red, green and blue are " + Plain(each[0], 2) + ", " + Plain(each[1], 2) + " and " +
                            Plain(each[2], 2) + " times as large as they should be",
                   .hint = "Are the three channels computed in the same way?",
                   .factor = each,
                   .before_clamping = true,
                   .free_numbers = 3});
  return tones;
}

std::vector<Tone> OrderTones() {
  // Red and blue swapped is a mistake of the table.
  constexpr std::array<std::array<int, 3>, 4> orders{{{1, 0, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}}};
  std::vector<Tone> tones;
  for (const auto& order : orders) {
    std::string words;
    for (const int channel : order)
      words += std::string(words.empty() ? "" : ", ") +
               std::array{"red", "green", "blue"}[static_cast<std::size_t>(channel)];
    tones.push_back({.name = "channels_permuted",
                     .title = "channels are swapped: stored in the order " + words,
                     .hint = "In which order does the file want its channels?",
                     .order = order,
                     .free_numbers = 0});
  }
  return tones;
}

R2::Color PowerOf(const R2::Color& c, double exponent) {
  const auto power = [&](double channel) { return R1::Pow(std::max(0.0, channel), exponent); };
  return {power(c.r), power(c.g), power(c.b)};
}

}  // namespace

R2::Image Toned(const R2::Image& light, const Tone& tone) {
  return EachColor(light, [&](const R2::Color& color) {
    const auto clamped = [](double channel) { return channel > 0 ? std::min(1.0, channel) : 0.0; };
    Channels in = Of(tone.exponent == 1 ? color : PowerOf(color, tone.exponent)), out{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = in[static_cast<std::size_t>(tone.order[i])];
      out[i] = clamped(tone.offset[i] + tone.factor[i] * (tone.before_clamping ? value : clamped(value)));
    }
    return R2::Color{out[0], out[1], out[2]};
  });
}

std::vector<Tone> FittedTones(std::span<const TonePair> pairs) {
  std::vector<Tone> tones = LinearTones(LinesOf(pairs));
  for (Tone& tone : OrderTones()) tones.push_back(std::move(tone));
  constexpr double usual_gamma = 2.2;
  tones.push_back({.name = "gamma_decoded",
                   .title = "values are raised to the power 2.2",
                   .hint = "Is a gamma correction undone that was never applied?",
                   .exponent = usual_gamma,
                   .free_numbers = 0});
  return tones;
}

R2::Image Encoded(const R2::Image& image, Encoding encoding) {
  if (encoding == Encoding::linear) return image;
  if (encoding == Encoding::srgb) return EachChannel(image, [](double channel) { return R2::EncodeSrgb(channel); });
  return EachChannel(image, [](double channel) { return R1::Pow(std::max(0.0, channel), 1 / 2.2); });
}

R2::Image Decoded(const R2::Image& image, Encoding encoding) {
  if (encoding == Encoding::linear) return image;
  if (encoding == Encoding::srgb) return EachChannel(image, [](double channel) { return R2::DecodeSrgb(channel); });
  return EachChannel(image, [](double channel) { return R1::Pow(std::max(0.0, channel), 2.2); });
}

}  // namespace ray::grade
