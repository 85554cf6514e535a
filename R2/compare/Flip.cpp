#include "R2/compare/Flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "R1/Elementary.h"
#include "R2/Color.h"

namespace R2 {
namespace {

// --- color spaces ---

struct Triple {
  double x = 0, y = 0, z = 0;
};

/// The white point of the standard illuminant D65.
constexpr Triple white{0.950428545, 1.0, 1.088900371};

/// Converts to XYZ relative to white, so that white is (1, 1, 1).
Triple RelativeXyz(const Color& linear) {
  return {
      (0.41238656325299233 * linear.r + 0.35759149092062537 * linear.g + 0.18045049120356373 * linear.b) / white.x,
      0.21263682167732417 * linear.r + 0.71518298184125073 * linear.g + 0.072180196481425496 * linear.b,
      (0.019330620152483987 * linear.r + 0.11919716364020845 * linear.g + 0.95037258700543535 * linear.b) / white.z};
}

Color LinearRgb(const Triple& relative) {
  const double x = relative.x * white.x, y = relative.y, z = relative.z * white.z;
  return {3.2410032329763587 * x - 1.5373989694887855 * y - 0.49861588199636292 * z,
          -0.96922425220251638 * x + 1.8759299836951759 * y + 0.041554226340084724 * z,
          0.055639419851975444 * x - 0.20401120612391218 * y + 1.0571489771875335 * z};
}

/// Converts to YCxCz, the linear counterpart of L*a*b*: lightness, red versus green, yellow versus blue.
Triple YCxCz(const Triple& relative) {
  return {116 * relative.y - 16, 500 * (relative.x - relative.y), 200 * (relative.y - relative.z)};
}

Triple FromYCxCz(const Triple& opponent) {
  const double y = (opponent.x + 16) / 116;
  return {y + opponent.y / 500, y, y - opponent.z / 200};
}

double LabCurve(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? R1::Cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

/// Converts to L*a*b* with the Hunt effect: colors look less colorful when dark (section 4.1.3).
Triple HuntLab(const Color& linear) {
  const Triple t = RelativeXyz(linear);
  const double fx = LabCurve(t.x), fy = LabCurve(t.y), fz = LabCurve(t.z);
  const double lightness = 116 * fy - 16;
  return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

/// Returns the distance for large color differences: city block in lightness, Euclidean in the others (section 4.1.4).
double HyAB(const Triple& a, const Triple& b) { return std::abs(a.x - b.x) + R1::Hypot(a.y - b.y, a.z - b.z); }

// --- filters ---

/// The filter weights of -radius..radius.
using Kernel = std::vector<float>;

/// Evaluates `shape` at every pixel of the kernel, without scaling.
template <typename Shape>
std::vector<double> Sampled(int radius, const Shape& shape) {
  std::vector<double> weights;
  for (int i = -radius; i <= radius; ++i) weights.push_back(shape(static_cast<double>(i)));
  return weights;
}

/// Scales the weights so that positive ones sum to `sum` and negative ones to -`sum`.
Kernel Scaled(const std::vector<double>& weights, double sum = 1) {
  double positive = 0, negative = 0;
  for (const double w : weights) (w > 0 ? positive : negative) += std::abs(w);
  Kernel kernel;
  for (const double w : weights)
    kernel.push_back(w == 0 ? 0 : static_cast<float>(w * sum / (w > 0 ? positive : negative)));
  return kernel;
}

/// Filters along rows. Pixels beyond the border repeat the border.
Plane AlongRows(const Plane& in, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  Plane out(in.width, in.height);
  std::vector<float> padded(static_cast<std::size_t>(in.width + 2 * radius));
  for (int y = 0; y < in.height; ++y) {
    const float* row = in.Row(y);
    for (int i = 0; i < in.width + 2 * radius; ++i)
      padded[static_cast<std::size_t>(i)] = row[std::clamp(i - radius, 0, in.width - 1)];
    float* to = out.Row(y);
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (int x = 0; x < in.width; ++x) to[x] += kernel[k] * padded[static_cast<std::size_t>(x) + k];
  }
  return out;
}

Plane AlongColumns(const Plane& in, const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  Plane out(in.width, in.height);
  for (int y = 0; y < in.height; ++y) {
    float* to = out.Row(y);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const float* row = in.Row(std::clamp(y - radius + static_cast<int>(k), 0, in.height - 1));
      for (int x = 0; x < in.width; ++x) to[x] += kernel[k] * row[x];
    }
  }
  return out;
}

Plane Filtered(const Plane& in, const Kernel& along_rows, const Kernel& along_columns) {
  return AlongColumns(AlongRows(in, along_rows), along_columns);
}

// --- the resolution of the eye (section 4.1.1) ---

/// A contrast sensitivity function as a sum of two Gaussians, in the frequency domain a1 exp(-b1 f^2) + ... (table 1).
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1, 0.0047, 0, 1e-5};
constexpr Sensitivity red_green{1, 0.0053, 0, 1e-5};
constexpr Sensitivity blue_yellow{34.1, 0.04, 13.5, 0.025};

/// Returns the radius of the widest filter, which all of them share.
int SensitivityRadius(double pixels_per_degree) {
  constexpr double widest = blue_yellow.b1;
  return static_cast<int>(std::ceil(3 * std::sqrt(widest / 2) / std::numbers::pi * pixels_per_degree));
}

/// Evaluates one of the Gaussians at a distance in pixels; its square over the plane is the product of two of these.
auto SpatialGaussian(double b, double pixels_per_degree) {
  return [=](double pixels) {
    const double degrees = pixels / pixels_per_degree;
    return R1::Exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / b);
  };
}

/// Filters by the contrast sensitivity function. Each Gaussian is separable but their sum is not, so each is filtered
/// separately with its share of the whole. The shares follow the authors' program, which weights a two-dimensional
/// Gaussian by a sqrt(pi / b), like a one-dimensional one.
Plane FilterByCsf(const Plane& channel, const Sensitivity& s, double pixels_per_degree) {
  const int radius = SensitivityRadius(pixels_per_degree);
  const auto part = [&](double a, double b) {
    const auto weights = Sampled(radius, SpatialGaussian(b, pixels_per_degree));
    double sum = 0;
    for (const double w : weights) sum += w;
    return std::pair(weights, a * std::sqrt(std::numbers::pi / b) * sum * sum);
  };
  const auto [first, first_sum] = part(s.a1, s.b1);
  const auto [second, second_sum] = part(s.a2, s.b2);
  const double total = first_sum + second_sum;
  Plane seen = Filtered(channel, Scaled(first, first_sum / total), Scaled(first));
  if (s.a2 == 0) return seen;
  const Plane more = Filtered(channel, Scaled(second, second_sum / total), Scaled(second));
  for (std::size_t i = 0; i < seen.values.size(); ++i) seen.values[i] += more.values[i];
  return seen;
}

// --- one image ---

using Planes = std::array<Plane, 3>;

void SetTriple(Planes& planes, std::size_t i, const Triple& t) {
  planes[0].values[i] = static_cast<float>(t.x);
  planes[1].values[i] = static_cast<float>(t.y);
  planes[2].values[i] = static_cast<float>(t.z);
}

Triple TripleAt(const Planes& planes, std::size_t i) {
  return {planes[0].values[i], planes[1].values[i], planes[2].values[i]};
}

Planes Opponents(const Image& image) {
  const Plane empty(image.Width(), image.Height());
  Planes opponents{empty, empty, empty};
  const Image::Floats& channels = image.Channels();
  for (std::size_t i = 0; i < empty.values.size(); ++i) {
    const Color shown{Clamped(channels[3 * i]), Clamped(channels[3 * i + 1]), Clamped(channels[3 * i + 2])};
    SetTriple(opponents, i, YCxCz(RelativeXyz(DecodeSrgb(shown))));
  }
  return opponents;
}

/// Returns the colors that remain after the eye has blurred the image, in Hunt-adjusted L*a*b*.
Planes SeenColors(const Planes& opponents, double pixels_per_degree) {
  Planes seen{FilterByCsf(opponents[0], achromatic, pixels_per_degree),
              FilterByCsf(opponents[1], red_green, pixels_per_degree),
              FilterByCsf(opponents[2], blue_yellow, pixels_per_degree)};
  for (std::size_t i = 0; i < seen[0].values.size(); ++i) {
    const Color c = LinearRgb(FromYCxCz(TripleAt(seen, i)));
    SetTriple(seen, i, HuntLab({Clamped(c.r), Clamped(c.g), Clamped(c.b)}));
  }
  return seen;
}

/// The strengths of edges and points: lengths of first and second derivatives (section 4.2).
struct Features {
  Plane edges, points;
};

Plane Lengths(const Plane& x, const Plane& y) {
  Plane lengths(x.width, x.height);
  for (std::size_t i = 0; i < lengths.values.size(); ++i)
    lengths.values[i] = static_cast<float>(R1::Hypot(x.values[i], y.values[i]));
  return lengths;
}

Features FindFeatures(const Plane& lightness, double pixels_per_degree) {
  constexpr double width = 0.082;  // w: width of an edge that the eye detects, in degrees
  const double sigma = 0.5 * width * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const auto gaussian = [=](double x) { return R1::Exp(-x * x / (2 * sigma * sigma)); };
  const Kernel blur = Scaled(Sampled(radius, gaussian));
  const Kernel edge = Scaled(Sampled(radius, [=](double x) { return -x * gaussian(x); }));
  const Kernel point = Scaled(Sampled(radius, [=](double x) { return (x * x / (sigma * sigma) - 1) * gaussian(x); }));

  Plane normalized = lightness;
  for (float& y : normalized.values) y = (y + 16) / 116;
  return {Lengths(Filtered(normalized, edge, blur), Filtered(normalized, blur, edge)),
          Lengths(Filtered(normalized, point, blur), Filtered(normalized, blur, point))};
}

// --- two images ---

constexpr double color_exponent = 0.7;  // q_c

/// Compresses large color differences: those up to 0.4 of the largest possible are mapped to [0, 0.95], the rest to the
/// remaining range (section 4.1.5).
double Remapped(double difference) {
  constexpr double knee = 0.4, value_at_knee = 0.95;  // p_c, p_t
  static const double largest = R1::Pow(HyAB(HuntLab({0, 1, 0}), HuntLab({0, 0, 1})), color_exponent);
  if (difference < knee * largest) return value_at_knee / (knee * largest) * difference;
  return value_at_knee + (difference - knee * largest) / (largest - knee * largest) * (1 - value_at_knee);
}

double ColorDifference(const Triple& a, const Triple& b) { return Remapped(R1::Pow(HyAB(a, b), color_exponent)); }

double FeatureDifference(const Features& a, const Features& b, std::size_t i) {
  constexpr double feature_exponent = 0.5;  // q_f
  const double edges = std::abs(a.edges.values[i] - b.edges.values[i]);
  const double points = std::abs(a.points.values[i] - b.points.values[i]);
  return R1::Pow(std::max(edges, points) / std::numbers::sqrt2, feature_exponent);
}

/// The filtered features by which two images are compared.
struct FilteredImage {
  Planes colors;
  Features features;
};

FilteredImage Filter(const Image& image, double pixels_per_degree) {
  const Planes opponents = Opponents(image);
  return {SeenColors(opponents, pixels_per_degree), FindFeatures(opponents[0], pixels_per_degree)};
}

}  // namespace

Plane Flip(const Image& a, const Image& b, double pixels_per_degree) {
  assert(a.Width() == b.Width() && a.Height() == b.Height());
  assert(pixels_per_degree >= 1 && pixels_per_degree <= 1000);
  const FilteredImage filtered_a = Filter(a, pixels_per_degree), filtered_b = Filter(b, pixels_per_degree);
  Plane flip(a.Width(), a.Height());
  for (std::size_t i = 0; i < flip.values.size(); ++i) {
    const double color = ColorDifference(TripleAt(filtered_a.colors, i), TripleAt(filtered_b.colors, i));
    const double feature = FeatureDifference(filtered_a.features, filtered_b.features, i);
    flip.values[i] = static_cast<float>(R1::Pow(color, 1 - feature));  // section 4.3
  }
  return flip;
}

}  // namespace R2
