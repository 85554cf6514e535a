#include "source/scene/Environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "R1/Elementary.h"
#include "source/scene/lights/Words.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int fewest_rows = 128, most_rows = 8192;

std::string Number(int n) { return Words(static_cast<double>(n)); }

EnvironmentLayout LayoutOf(const R2::Image& image) {
  const std::int64_t width = image.Width(), height = image.Height();
  if (width > 0 && width == 2 * height) return EnvironmentLayout::latitude_longitude;
  if (width > 0 && width == height) return EnvironmentLayout::angular_probe;
  // Whole faces follow: 4 w = 3 h has whole solutions only in threes and fours.
  if (width > 0 && (4 * width == 3 * height || 3 * width == 4 * height)) return EnvironmentLayout::cross;
  throw std::invalid_argument(
      "an environment map must be 2:1 (latitude-longitude), 1:1 (angular probe), or 3:4 or 4:3 (cross of six cube "
      "faces), got " +
      Number(image.Width()) + " x " + Number(image.Height()));
}

void CheckValues(const R2::Image& image) {
  const auto is_light = [](double channel) { return std::isfinite(channel) && channel >= 0; };
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const R2::Color c = image.At(x, y);
      if (is_light(c.r) && is_light(c.g) && is_light(c.b)) continue;
      throw std::invalid_argument("radiance must be finite and not negative, but pixel " + Number(x) + " " + Number(y) +
                                  " (from the left, from the bottom) is " + Words(c));
    }
}

int Nearest(double share, int count) { return std::clamp(static_cast<int>(share * count), 0, count - 1); }

/// `d` is unit.
R2::Color InProbe(const R2::Image& image, const R3::Vector& d) {
  const double sine = std::sqrt(d.x * d.x + d.y * d.y), radius = R1::Atan2(sine, -d.z) / pi;
  // Straight back every direction of the rim will do.
  const double x = sine > 0 ? d.x / sine * radius : radius, y = sine > 0 ? d.y / sine * radius : 0;
  return image.At(Nearest((x + 1) / 2, image.Width()), Nearest((y + 1) / 2, image.Height()));
}

/// Where a face of the cube is in the image, counted in faces from the lower left, and what its right and up are.
struct Face {
  int column, row;
  R3::Vector right, up;
};

Face FaceTowards(const R3::Vector& d, bool is_upright) {
  const int bottom = is_upright ? 1 : 0, middle = bottom + 1, top = bottom + 2;
  switch (MaxAxis(d)) {
    case 0:
      return d.x > 0 ? Face{2, middle, {0, 0, 1}, {0, 1, 0}} : Face{0, middle, {0, 0, -1}, {0, 1, 0}};
    case 1:
      return d.y > 0 ? Face{1, top, {1, 0, 0}, {0, 0, 1}} : Face{1, bottom, {1, 0, 0}, {0, 0, -1}};
    default:
      if (d.z < 0) return {1, middle, {1, 0, 0}, {0, 1, 0}};
      return is_upright ? Face{1, 0, {1, 0, 0}, {0, -1, 0}} : Face{3, middle, {-1, 0, 0}, {0, 1, 0}};
  }
}

R2::Color InCross(const R2::Image& image, const R3::Vector& d) {
  const bool is_upright = image.Width() < image.Height();
  const int size = is_upright ? image.Width() / 3 : image.Width() / 4;
  const Face face = FaceTowards(d, is_upright);
  const double distance = MaxComponent(Abs(d));
  return image.At(face.column * size + Nearest((Dot(d, face.right) / distance + 1) / 2, size),
                  face.row * size + Nearest((Dot(d, face.up) / distance + 1) / 2, size));
}

/// The edge below row `row`, of latitude -pi/2 + pi row / rows.
double SineOfEdge(int row, int rows) { return -R1::SinCosTurns(0.5 * row / rows).cosine; }

/// Of one texel in the row: width in longitude times height in the sine of latitude, without the difference of sines.
double SolidAngle(int row, int rows) {
  const double longitudes = pi / rows, middle = 0.5 * (row + 0.5) / rows;
  return longitudes * 2 * R1::SinCosTurns(middle).sine * R1::SinCosTurns(0.25 / rows).sine;
}

/// The sine of latitude at a share of a row's height in it.
double SineOf(int row, double share, int rows) {
  const double low = SineOfEdge(row, rows), high = SineOfEdge(row + 1, rows);
  return low + share * (high - low);
}

/// From -z by +x, at a share of a column's width.
R1::SineCosine LongitudeOf(int column, double share, int rows) {
  return R1::SinCosTurns(0.5 * (column + share) / rows - 0.5);
}

R3::Vector Towards(double sine_of_latitude, const R1::SineCosine& longitude) {
  const double radius = std::sqrt(std::max(0.0, (1 - sine_of_latitude) * (1 + sine_of_latitude)));
  return {radius * longitude.sine, sine_of_latitude, -radius * longitude.cosine};
}

/// Each texel is the mean over the middles of its four quarters of equal solid angle.
template <typename Lookup>
R2::Image Resampled(int rows, const Lookup& lookup) {
  constexpr double quarters[] = {0.25, 0.75};
  std::vector<R1::SineCosine> longitudes;  // two a column
  for (int x = 0; x < 2 * rows; ++x)
    for (const double share : quarters) longitudes.push_back(LongitudeOf(x, share, rows));
  R2::Image map(2 * rows, rows);
  for (int y = 0; y < rows; ++y) {
    const double latitudes[] = {SineOf(y, quarters[0], rows), SineOf(y, quarters[1], rows)};
    for (int x = 0; x < 2 * rows; ++x) {
      const R1::SineCosine* in_column = &longitudes[2 * static_cast<std::size_t>(x)];
      R2::Color sum;
      for (const double latitude : latitudes)
        for (int i = 0; i < 2; ++i) sum += lookup(Towards(latitude, in_column[i]));
      map.Set(x, y, sum / 4);
    }
  }
  return map;
}

R2::Image Unfolded(R2::Image image, EnvironmentLayout layout) {
  CheckValues(image);
  switch (layout) {
    case EnvironmentLayout::latitude_longitude:
      return image;
    case EnvironmentLayout::angular_probe:
      return Resampled(std::clamp(image.Height(), fewest_rows, most_rows),
                       [&](const R3::Vector& d) { return InProbe(image, d); });
    case EnvironmentLayout::cross:
      return Resampled(std::clamp(2 * std::min(image.Width(), image.Height()) / 3, fewest_rows, most_rows),
                       [&](const R3::Vector& d) { return InCross(image, d); });
  }
  return image;
}

bool IsAllBlack(const R2::Image& image) {
  return std::all_of(image.Channels().begin(), image.Channels().end(), [](float c) { return c == 0; });
}

std::vector<double> Weights(const R2::Image& map, int row, bool is_black) {
  std::vector<double> weights;
  for (int x = 0; x < map.Width(); ++x) weights.push_back(is_black ? 1 : Luminance(map.At(x, row)));
  return weights;
}

std::vector<DiscreteDistribution> Columns(const R2::Image& map, bool is_black) {
  std::vector<DiscreteDistribution> columns;
  for (int y = 0; y < map.Height(); ++y) columns.emplace_back(Weights(map, y, is_black));
  return columns;
}

DiscreteDistribution Rows(const R2::Image& map, bool is_black) {
  std::vector<double> rows;
  for (int y = 0; y < map.Height(); ++y) {
    double sum = 0;
    for (const double weight : Weights(map, y, is_black)) sum += weight;
    rows.push_back(sum * SolidAngle(y, map.Height()));
  }
  return DiscreteDistribution(rows);
}

template <typename Number>
std::vector<double> OfRows(int count, const Number& number) {
  std::vector<double> numbers;
  for (int row = 0; row < count; ++row) numbers.push_back(number(row));
  return numbers;
}

/// atan2(y, x) in turns, within quick_error; y and x not both 0.
///   source   Hastings, Approximations for digital computers (1955), sheet 13: the arctangent up to 1 within 2e-8
///   radians
double QuickTurns(double y, double x) {
  const double wide = std::abs(x), high = std::abs(y);
  const double ratio = std::min(wide, high) / std::max(wide, high), z = ratio * ratio;
  const double radians =
      ratio *
      (1 + z * (-.3333314528 +
                z * (.1999355085 +
                     z * (-.1420889944 +
                          z * (.1065626393 +
                               z * (-.0752896400 + z * (.0429096138 + z * (-.0161657367 + z * .0028662257))))))));
  const double octant = radians / (2 * pi), quadrant = high > wide ? 0.25 - octant : octant;
  const double half = x < 0 ? 0.5 - quadrant : quadrant;
  return y < 0 ? -half : half;
}
constexpr double quick_error = 4e-9;  // 2e-8 / (2 pi), and a fifth more for rounding

/// Whether a place among `count` texels that was found by QuickTurns, of which a row spans half a turn, is surely in
/// the texel that it seems to be in.
bool IsInside(double place, int count) {
  const double error = 2 * quick_error * count, share = place - std::floor(place);
  return share > error && share < 1 - error && place > 0 && place < count;
}

/// Nearer to a texel's edge than this share of it, rounding may give a direction to the neighbor. The narrowest texels
/// are those at the poles: of 2^20 rows the last spans 2^-37.7 in the sine of latitude, which is off by 2^-51 at most.
constexpr double edge_share = 0x1p-10;
bool IsNearEdge(double share) { return share < edge_share || share > 1 - edge_share; }

}  // namespace

std::string_view Name(EnvironmentLayout layout) {
  switch (layout) {
    case EnvironmentLayout::latitude_longitude:
      return "latitude-longitude map";
    case EnvironmentLayout::angular_probe:
      return "angular probe";
    case EnvironmentLayout::cross:
      return "cross of six faces";
  }
  return "";
}

Environment::Environment(R2::Image image, std::string file)
    : file_(std::move(file)),
      layout_(LayoutOf(image)),
      map_(Unfolded(std::move(image), layout_)),
      is_black_(IsAllBlack(map_)),
      sines_(OfRows(map_.Height() + 1, [&](int edge) { return SineOfEdge(edge, map_.Height()); })),
      solid_angles_(OfRows(map_.Height(), [&](int row) { return SolidAngle(row, map_.Height()); })),
      columns_(Columns(map_, is_black_)),
      rows_(Rows(map_, is_black_)) {}

Environment::Texel Environment::At(const R3::Vector& direction) const {
  if (const auto texel = QuicklyAt(direction)) [[likely]]
    return *texel;
  const R3::Vector d = Unit(direction);  // so that no component overflows; 0 for 0 and NaN, which is then some texel
  const double u = R1::Atan2(d.x, -d.z) / (2 * pi) + 0.5,
               v = R1::Atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z)) / pi + 0.5;
  return {Nearest(u, map_.Width()), Nearest(v, map_.Height())};
}

std::optional<Environment::Texel> Environment::QuicklyAt(const R3::Vector& d) const {
  if (!R3::IsSafeSquare(Dot(d, d))) return {};
  const double column = (QuickTurns(d.x, -d.z) + 0.5) * map_.Width(),
               row = (QuickTurns(d.y, std::sqrt(d.x * d.x + d.z * d.z)) * 2 + 0.5) * map_.Height();
  if (!IsInside(column, map_.Width()) || !IsInside(row, map_.Height())) return {};
  return Texel{static_cast<int>(column), static_cast<int>(row)};
}

R3::Vector Environment::Inside(const Texel& texel, const R2::Point& shares) const {
  const double low = sines_[static_cast<std::size_t>(texel.row)],
               high = sines_[static_cast<std::size_t>(texel.row) + 1];
  return Towards(low + shares.y * (high - low), LongitudeOf(texel.column, shares.x, map_.Height()));
}

double Environment::Pdf(const Texel& texel) const {
  const DiscreteDistribution& columns = columns_[static_cast<std::size_t>(texel.row)];
  return rows_.Probability(static_cast<std::size_t>(texel.row)) *
         columns.Probability(static_cast<std::size_t>(texel.column)) /
         solid_angles_[static_cast<std::size_t>(texel.row)];
}

R2::Color Environment::Radiance(const R3::Vector& direction) const {
  if (is_black_) return {};  // finding a texel takes an arctangent
  const Texel texel = At(direction);
  return map_.At(texel.column, texel.row);
}

Environment::Sample Environment::Draw(const R2::Point& u) const {
  const DiscreteDistribution::Drawn row = rows_.Draw(u.y), column = columns_[row.index].Draw(u.x);
  const Texel texel{static_cast<int>(column.index), static_cast<int>(row.index)};
  R3::Vector direction = Inside(texel, {column.rest, row.rest});
  // A place at the very edge may round to the neighbor, which may be black; the middle then stands for it.
  if ((IsNearEdge(column.rest) || IsNearEdge(row.rest)) && !(At(direction) == texel))
    direction = Inside(texel, {0.5, 0.5});
  return {direction, map_.At(texel.column, texel.row), Pdf(texel)};
}

Environment::Seen Environment::SeenTowards(const R3::Vector& direction) const {
  const Texel texel = At(direction);
  return {map_.At(texel.column, texel.row), Pdf(texel)};
}

}  // namespace ray
