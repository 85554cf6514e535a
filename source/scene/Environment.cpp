#include "source/scene/Environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Numeric.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns the solid angle of one texel in the row: width in longitude times height in the sine of latitude, computed
/// without a difference of sines.
double SolidAngle(int row, int rows) {
  const double longitudes = pi / rows, middle = 0.5 * (row + 0.5) / rows;
  return longitudes * 2 * R1::SinCosTurns(middle).sine * R1::SinCosTurns(0.25 / rows).sine;
}

double LargestLuminance(const R2::Image& map) {
  double largest = 0;
  for (int y = 0; y < map.Height(); ++y)
    for (int x = 0; x < map.Width(); ++x) largest = std::max(largest, Luminance(map.At(x, y)));
  return largest;
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

/// Returns atan2(y, x) in turns, within quick_error; y and x not both 0.
///   source   Hastings, Approximations for digital computers (1955), sheet 13: the arctangent up to 1 within 2e-8
///   radians
inline double QuickTurns(double y, double x) {
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
  return std::copysign(half, y);
}
constexpr double quick_error = 4e-9;  // 2e-8 / (2 pi), plus a fifth for rounding

/// Takes values: with std::min's references g++ does not vectorize the loop below.
inline double Least(double a, double b) { return a < b ? a : b; }

/// Returns how far a position among `count` texels, found by QuickTurns, is from where its error could put it into a
/// neighbor; a row of them spans half a turn.
inline double Margin(double place, int count) {
  const double error = 2 * quick_error * count, share = place - std::floor(place);
  return Least(Least(share - error, (1 - error) - share), Least(place, count - place));
}

inline QuickPlace PlaceQuickly(const R3::Vector& d, int width, int height) {
  const double column = (QuickTurns(d.x, -d.z) + 0.5) * width,
               row = (QuickTurns(d.y, std::sqrt(d.x * d.x + d.z * d.z)) * 2 + 0.5) * height;
  const double margin = Least(Margin(column, width), Margin(row, height));
  return {column, row, R3::SafeScale(Dot(d, d)) == 1 ? margin : 0};
}

/// The share of a texel next to its edge within which rounding may assign a direction to the neighbor. The narrowest
/// texels are those at the poles: of 2^20 rows the last spans 2^-37.7 in the sine of latitude, which is off by 2^-51 at
/// most.
constexpr double edge_share = 0x1p-10;
bool IsNearEdge(double share) { return share < edge_share || share > 1 - edge_share; }

/// Returns the direction at shares of a column's width and, between two sines, of the height in the sine of latitude.
inline R3::Vector TowardsPlace(double low, double high, int column, const R2::Point& shares, int rows) {
  return Towards(low + shares.y * (high - low), LongitudeOf(column, shares.x, rows));
}

// Draw and SeenTowards for many samples, in loops that become vector instructions.

struct PlaceBatch {
  alignas(64) LightSamples::Each low, high;
  R1::Columns<R2::Point> shares;
  alignas(64) std::int32_t column[LightSamples::most];
};

R3_VECTORIZED
void GoToEach(const PlaceBatch& at, int rows, LightSamples& samples) {
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    samples.to_light.Set(i, TowardsPlace(at.low[i], at.high[i], at.column[i], at.shares[i], rows));
  }
}

using QuickPlaces = R1::Columns<QuickPlace>;

R3_VECTORIZED
void PlaceEachQuickly(const LightSamples& samples, int width, int height, QuickPlaces& places) {
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    places.Set(i, PlaceQuickly(samples.to_light[i], width, height));
  }
}

}  // namespace

Environment::Environment(R2::Image image, std::string file)
    : file_(std::move(file)),
      layout_(LayoutOf(image)),
      map_(Unfolded(std::move(image), layout_)),
      is_black_(IsAllBlack(map_)),
      brightest_(LargestLuminance(map_)),
      sines_(OfRows(map_.Height() + 1, [&](int edge) { return SineOfEdge(edge, map_.Height()); })),
      solid_angles_(OfRows(map_.Height(), [&](int row) { return SolidAngle(row, map_.Height()); })),
      columns_(Columns(map_, is_black_)),
      rows_(Rows(map_, is_black_)) {}

Environment::Texel Environment::At(const R3::Vector& direction) const {
  return TexelOf(PlaceQuickly(direction, map_.Width(), map_.Height()), direction);
}

Environment::Texel Environment::TexelOf(const QuickPlace& place, const R3::Vector& direction) const {
  if (place.margin > 0) [[likely]]
    return {static_cast<int>(place.column), static_cast<int>(place.row)};
  const R3::Vector d = Unit(direction);  // prevents overflow; 0 for 0 and NaN, which select an arbitrary texel
  const double u = R1::Atan2(d.x, -d.z) / (2 * pi) + 0.5,
               v = R1::Atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z)) / pi + 0.5;
  return {Nearest(u, map_.Width()), Nearest(v, map_.Height())};
}

R3::Vector Environment::Inside(const Texel& texel, const R2::Point& shares) const {
  const double low = sines_[static_cast<std::size_t>(texel.row)],
               high = sines_[static_cast<std::size_t>(texel.row) + 1];
  return TowardsPlace(low, high, texel.column, shares, map_.Height());
}

R3::Vector Environment::Kept(const R3::Vector& direction, const Texel& texel, const R2::Point& shares) const {
  const bool is_near_edge = IsNearEdge(shares.x) || IsNearEdge(shares.y);
  return is_near_edge && !(At(direction) == texel) ? Inside(texel, {0.5, 0.5}) : direction;
}

double Environment::Pdf(const Texel& texel) const {
  const DiscreteDistribution& columns = columns_[static_cast<std::size_t>(texel.row)];
  return rows_.Probability(static_cast<std::size_t>(texel.row)) *
         columns.Probability(static_cast<std::size_t>(texel.column)) /
         solid_angles_[static_cast<std::size_t>(texel.row)];
}

R2::Color Environment::Radiance(const R3::Vector& direction) const {
  if (is_black_) return {};  // finding a texel takes an arctangent
  return RadianceOf(At(direction));
}

Environment::Drawn Environment::DrawInRow(const DiscreteDistribution::Drawn& row, double u) const {
  const DiscreteDistribution::Drawn column = columns_[row.index].Draw(u);
  return {{static_cast<int>(column.index), static_cast<int>(row.index)},
          {column.rest, row.rest},
          row.probability * column.probability / solid_angles_[row.index]};
}

Environment::Sample Environment::Draw(const R2::Point& u) const {
  const auto [texel, shares, pdf] = DrawInRow(rows_.Draw(u.y), u.x);
  return {Kept(Inside(texel, shares), texel, shares), RadianceOf(texel), pdf};
}

Environment::Seen Environment::SeenTowards(const R3::Vector& direction) const {
  const Texel texel = At(direction);
  return {RadianceOf(texel), Pdf(texel)};
}

void Environment::DrawEach(LightSamples& samples, LightSamples::Each& pdfs) const {
  std::array<DiscreteDistribution::Drawn, LightSamples::most> rows;
  std::array<Drawn, LightSamples::most> drawn;
  PlaceBatch places;
  // The tables of large maps are not cached, so the entries of all samples are prefetched together.
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    rows[i] = rows_.Draw(samples.random[i].y);
    __builtin_prefetch(&columns_[rows[i].index]);
  }
  for (std::uint32_t i = 0; i < samples.count; ++i)
    __builtin_prefetch(columns_[rows[i].index].FirstLookup(samples.random[i].x));
  for (std::uint32_t i = 0; i < samples.count; ++i)
    __builtin_prefetch(columns_[rows[i].index].NextLookup(samples.random[i].x));
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    drawn[i] = DrawInRow(rows[i], samples.random[i].x);
    map_.Prefetch(drawn[i].texel.column, drawn[i].texel.row);
    const auto row = static_cast<std::size_t>(drawn[i].texel.row);
    places.low[i] = sines_[row], places.high[i] = sines_[row + 1];
    places.column[i] = drawn[i].texel.column, places.shares.Set(i, drawn[i].shares);
  }
  GoToEach(places, map_.Height(), samples);
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    const auto& [texel, shares, pdf] = drawn[i];
    pdfs[i] = pdf;
    samples.Set(i, Kept(samples.to_light[i], texel, shares), RadianceOf(texel) / pdf);
  }
}

void Environment::SeeEach(LightSamples& samples, LightSamples::Each& pdfs) const {
  QuickPlaces places;
  PlaceEachQuickly(samples, map_.Width(), map_.Height(), places);
  std::array<Texel, LightSamples::most> texels;
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    texels[i] = TexelOf(places[i], samples.to_light[i]);
    map_.Prefetch(texels[i].column, texels[i].row);
    __builtin_prefetch(&columns_[static_cast<std::size_t>(texels[i].row)]);
  }
  for (std::uint32_t i = 0; i < samples.count; ++i)
    __builtin_prefetch(
        columns_[static_cast<std::size_t>(texels[i].row)].LookupOf(static_cast<std::size_t>(texels[i].column)));
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    pdfs[i] = Pdf(texels[i]);
    samples.color.Set(i, RadianceOf(texels[i]));
  }
}

}  // namespace ray
