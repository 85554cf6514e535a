#include "R1/Elementary.h"

#include <gtest/gtest.h>

#include <climits>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "tests/Draw.h"
#include "tests/Folder.h"
#include "tests/Project.h"
#include "tests/Quad.h"

// The exact value in 113 bits: from gcc's library where a type of twice the size of double exists, otherwise from the C
// library, whose long double has 113 bits there.
#if defined(__SIZEOF_FLOAT128__)
extern "C" {
Quad sinq(Quad), cosq(Quad), tanq(Quad), asinq(Quad), acosq(Quad), atanq(Quad), atan2q(Quad, Quad), expq(Quad),
    expm1q(Quad), logq(Quad), log1pq(Quad), log10q(Quad), powq(Quad, Quad), cbrtq(Quad), hypotq(Quad, Quad);
}
#define TRUTH(name) name##q
#else
#define TRUTH(name) name##l
#endif

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), least = std::numeric_limits<double>::denorm_min();
const double nan = std::nan("");

/// Returns the distance to the exact value in its ulp.
double ErrorInUlp(double got, Quad truth) {
  const double nearest = oracle::Double(truth);
  if (got == nearest || (std::isnan(got) && std::isnan(nearest))) {
    if (!std::isfinite(got) || got == 0)
      return std::signbit(got) == std::signbit(nearest) || std::isnan(got) ? 0 : infinity;
  } else if (!std::isfinite(nearest) || !std::isfinite(got)) {
    return infinity;
  }
  const double size = std::max(std::abs(nearest), std::numeric_limits<double>::min());
  const double ulp = std::scalbn(1, std::ilogb(size) - 52);
  return oracle::Double(oracle::Abs(Quad(got) - truth) / Quad(ulp));
}

struct Worst {
  double error = 0, x = 0, y = 0;

  void See(double got, Quad truth, double at_x, double at_y = 0) {
    const double e = ErrorInUlp(got, truth);
    if (!(e <= error)) error = e, x = at_x, y = at_y;
  }
  std::string Where() const {
    char text[100];
    std::snprintf(text, sizeof text, "%.4f ulp at %a, %a", error, x, y);
    return text;
  }
};

/// Returns any double: random bits.
double Anything(Draw& draw) {
  const auto half = [&] { return static_cast<std::uint32_t>(draw.Whole(INT32_MIN, INT32_MAX)); };
  return std::bit_cast<double>(std::uint64_t{half()} << 32 | half());
}

/// Returns zeros, infinities, NaN, the ends of the subnormal and normal numbers, and both sides of values that are
/// often special.
std::vector<double> Specials() {
  std::vector<double> all{nan};
  for (const double x : {0.0,
                         infinity,
                         least,
                         0x1p-1022,
                         0x1p-1023,
                         0x1p-600,
                         0x1p-300,
                         0x1p-60,
                         0x1p-54,
                         0x1p-53,
                         0x1p-28,
                         0x1p-20,
                         0.5,
                         1.0,
                         2.0,
                         3.0,
                         0x1p20,
                         0x1p52,
                         0x1p53,
                         0x1p54,
                         0x1p300,
                         0x1p600,
                         0x1p1023,
                         std::numbers::pi,
                         std::numbers::pi / 2,
                         std::numbers::pi / 4,
                         std::numbers::ln2,
                         std::numbers::ln2 / 256,
                         709.782712893384,
                         745.1332191019411,
                         708.3964185322641})
    for (const double near : {std::nextafter(x, 0.0), x, std::nextafter(x, infinity)})
      for (const double sign : {1.0, -1.0}) all.push_back(sign * near);
  return all;
}

/// Returns 1 and slightly more or less, down to its last bit, where logarithms nearly vanish.
double NearOne(Draw& draw) { return 1 + std::ldexp(draw.Between(-1, 1), draw.Whole(-52, -1)); }

/// Returns numbers spread evenly over an interval, and with random exponents.
struct Interval {
  double low, high;
  double Number(Draw& draw, int i) const {
    if (i % 3) return draw.Between(low, high);
    const double size = std::max(std::abs(low), std::abs(high));
    const double x = std::ldexp(draw.Between(0.5, 1), draw.Whole(-60, std::ilogb(size) + 1));
    return std::clamp(draw.Whole(0, 1) ? x : -x, low, high);
  }
};

using Function = double (*)(double);
using Truth = Quad (*)(Quad);

void ExpectWithin(double ulp, Function function, Truth truth, const std::vector<Interval>& intervals,
                  const std::vector<double>& more = {}) {
  Draw draw(903);
  Worst worst;
  const auto see = [&](double x) { worst.See(function(x), truth(x), x); };
  for (const double x : Specials()) see(x);
  for (const double x : more) see(x);
  for (int i = 0; i < Count(10'000, 1'000'000); ++i) see(Anything(draw)), see(NearOne(draw));
  for (const Interval& interval : intervals)
    for (int i = 0; i < Count(60'000, 6'000'000); ++i) see(interval.Number(draw, i));
  EXPECT_LE(worst.error, ulp) << worst.Where();
}

/// Returns the doubles around multiples of pi/2, where sine or cosine nearly vanish, and the nearest of all.
///   source   the nearest: Muller, Elementary Functions (2016), table 11.1
std::vector<double> NearMultiplesOfHalfPi() {
  std::vector<double> all{0x1.6ac5b262ca1ffp+849, 0x1.921fb54442d18p+0, 5319372648326541.0 * 0x1p202};
  Draw draw(904);
  for (int i = 0; i < Count(20'000, 2'000'000); ++i) {
    const double n = i < 5000 ? i : std::floor(std::ldexp(1, draw.Whole(0, 50)) * draw.Between(1, 2));
    const double x = oracle::Double(Quad(n) * TRUTH(acos)(Quad(0)));
    for (const double near : {std::nextafter(x, 0.0), x, std::nextafter(x, infinity)})
      all.push_back(near), all.push_back(-near);
  }
  return all;
}

const std::vector<Interval> angles{{-1, 1}, {-10, 10}, {-1e6, 1e6}, {-0x1p40, 0x1p40}};

TEST(Elementary, SineAndCosineAreWithinEightTenthsOfAnUlp) {
  ExpectWithin(0.8, R1::Sin, TRUTH(sin), angles, NearMultiplesOfHalfPi());
  ExpectWithin(0.8, R1::Cos, TRUTH(cos), angles, NearMultiplesOfHalfPi());
}

TEST(Elementary, TheTangentIsWithinNinetyFiveHundredthsOfAnUlp) {
  ExpectWithin(0.95, R1::Tan, TRUTH(tan), angles, NearMultiplesOfHalfPi());
}

TEST(Elementary, ArcFunctionsAreWithinFiftyFiveHundredthsOfAnUlp) {
  ExpectWithin(0.55, R1::Asin, TRUTH(asin), {{-1, 1}, {0.99, 1}});
  ExpectWithin(0.55, R1::Acos, TRUTH(acos), {{-1, 1}, {0.99, 1}, {-1, -0.99}});
  ExpectWithin(0.55, R1::Atan, TRUTH(atan), {{-1, 1}, {-100, 100}});
}

TEST(Elementary, ExponentialsAndLogarithmsAreWithinTheirStatedErrors) {
  const Interval fits{-708.39, 709.78};
  ExpectWithin(
      0.55, [](double x) { return x < -708.39 ? 0 : R1::Exp(x); },
      [](Quad x) { return x < -708.39 ? 0 : TRUTH(exp)(x); }, {{-1, 1}, fits});
  ExpectWithin(0.76, R1::Exp, TRUTH(exp), {{-746, -708}});
  ExpectWithin(0.76, R1::Exp2, [](Quad x) { return TRUTH(pow)(2, x); }, {{-1, 1}, {-1080, 1030}});
  ExpectWithin(0.7, R1::Expm1, TRUTH(expm1), {{-1, 1}, {-0.01, 0.01}, fits});
  ExpectWithin(0.55, R1::Log, TRUTH(log), {{0, 2}, {0.99, 1.01}, {0, 1e300}});
  ExpectWithin(0.55, R1::Log1p, TRUTH(log1p), {{-1, 1}, {-0.01, 0.01}, {0, 1e300}});
  ExpectWithin(0.55, R1::Log10, TRUTH(log10), {{0, 2}, {0.99, 1.01}, {0, 1e300}});
  ExpectWithin(0.55, R1::Cbrt, TRUTH(cbrt), {{-2, 2}, {-1e300, 1e300}});
}

/// Returns all pairs of specials, pairs of random bits, and pairs from intervals.
Worst WorstOfPairs(double (*function)(double, double), Quad (*truth)(Quad, Quad),
                   const std::vector<std::pair<Interval, Interval>>& intervals) {
  Draw draw(905);
  Worst worst;
  const auto see = [&](double x, double y) { worst.See(function(x, y), truth(x, y), x, y); };
  for (const double x : Specials())
    for (const double y : Specials()) see(x, y);
  for (int i = 0; i < Count(20'000, 2'000'000); ++i) {
    const double x = Anything(draw), y = Anything(draw), near_one = NearOne(draw);
    see(x, y), see(near_one, y), see(x, near_one);
  }
  for (const auto& [of_x, of_y] : intervals)
    for (int i = 0; i < Count(60'000, 6'000'000); ++i) {
      const double x = of_x.Number(draw, i), y = of_y.Number(draw, i);
      see(x, y);
    }
  return worst;
}

TEST(Elementary, Atan2IsWithinFiftyFiveHundredthsOfAnUlp) {
  const Worst worst =
      WorstOfPairs(R1::Atan2, TRUTH(atan2), {{{-1, 1}, {-1, 1}}, {{0.9, 1}, {0.9, 1}}, {{-1, 1}, {-1e9, 1e9}}});
  EXPECT_LE(worst.error, 0.55) << worst.Where();
}

TEST(Elementary, HypotIsWithinFiftyFiveHundredthsOfAnUlp) {
  const Worst worst =
      WorstOfPairs(R1::Hypot, TRUTH(hypot), {{{-1, 1}, {-1, 1}}, {{0.9, 1}, {0, 0.01}}, {{-1, 1}, {-1e9, 1e9}}});
  EXPECT_LE(worst.error, 0.55) << worst.Where();
}

TEST(Elementary, PowersAreWithinFiftyFiveHundredthsOfAnUlp) {
  const Worst worst =
      WorstOfPairs(R1::Pow, TRUTH(pow),
                   {{{0, 1}, {0, 1000}}, {{0, 2}, {0.4, 0.5}}, {{0.999, 1.001}, {-1e6, 1e6}}, {{0, 2}, {2.4, 2.4}}});
  EXPECT_LE(worst.error, 0.76) << worst.Where();
}

TEST(Elementary, QuarterTurnsAreExactAndOthersWithinEightTenthsUlp) {
  for (int i = -8; i <= 8; ++i) {
    const auto [sine, cosine] = R1::SinCosTurns(0.25 * i);
    EXPECT_EQ(std::abs(sine), i & 1 ? 1 : 0) << i;
    EXPECT_EQ(std::abs(cosine), i & 1 ? 0 : 1) << i;
  }
  Draw draw(906);
  Worst worst;
  const Quad two_pi = 4 * TRUTH(acos)(Quad(0));
  for (int i = 0; i < Count(200'000, 20'000'000); ++i) {
    const double turns = Interval{-1, 1}.Number(draw, i), n = i % 5 ? 0 : draw.Whole(-1000, 1000), all = turns + n;
    // The remainder after whole quarters is exact, so that the oracle does not have to reduce a rounded product.
    const double quarters = std::nearbyint(4 * all);
    const Quad rest = (Quad(all) - Quad(quarters) / 4) * two_pi;
    const int quarter = static_cast<int>(quarters) & 3;
    const Quad s = TRUTH(sin)(rest), c = TRUTH(cos)(rest);
    const auto [sine, cosine] = R1::SinCosTurns(all);
    if (rest == 0) continue;
    worst.See(sine, quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c, all);
    worst.See(cosine, quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s, all);
  }
  EXPECT_LE(worst.error, 0.8) << worst.Where();
}

TEST(Elementary, FloorEqualsThatOfTheCLibrary) {
  const auto check = [](double x) {
    if (std::isnan(x))
      EXPECT_TRUE(std::isnan(R1::Floor(x)));
    else
      EXPECT_EQ(R1::Floor(x), std::floor(x)) << x;
  };
  for (const double edge : {0.0, 1.0, 0.5, 0x1p31, 0x1p51, 0x1p52, 0x1p53, 0x1p62, 0x1p63, 0x1p64, 1e300, least, infinity, nan})
    for (const double x : {edge, std::nextafter(edge, 0), std::nextafter(edge, infinity)}) check(x), check(-x);
  Draw draw(1);
  for (int i = 0; i < 100'000; ++i) check(std::ldexp(draw.Between(-1, 1), draw.Whole(-70, 70)));
}

TEST(Elementary, RepresentableResultsAreExact) {
  for (int i = -40; i <= 40; ++i) {
    EXPECT_EQ(R1::Exp2(i), std::ldexp(1, i));
    EXPECT_EQ(R1::Pow(i, 3), static_cast<double>(i) * i * i);
    EXPECT_EQ(R1::Cbrt(static_cast<double>(i) * i * i), i);
  }
  for (int i = 0; i < 16; ++i) EXPECT_EQ(R1::Log10(std::strtod(("1e" + std::to_string(i)).c_str(), nullptr)), i);
  EXPECT_EQ(R1::Hypot(3, 4), 5);
}

int StatusOf(const std::string& script, const std::string& arguments) {
  return std::system(
      ("'" + (project::Root() / "script" / script).string() + "' " + arguments + " > /dev/null").c_str());
}

TEST(Elementary, CallsOfTheCLibraryAreDetected) {
  EXPECT_EQ(StatusOf("check_functions.sh", ""), 0) << "see make check";
  const project::Folder tree;
  for (const char* folder : {"R1", "R2", "R3", "source", "grader", "page"}) std::filesystem::create_directory(tree / folder);
  const auto status_with = [&](const std::string& line) {
    std::ofstream(tree / "source/a.cpp") << line << '\n';
    return StatusOf("check_functions.sh", "'" + tree.Path().string() + "'");
  };
  for (const char* refused :
       {"x = std::sin(x);", "return powf(x, 2);", "y = 2 * ::exp (x);", "int s; lgamma_r(x, &s);"})
    EXPECT_NE(status_with(refused), 0) << refused;
  for (const char* passes :
       {"// as std::sin(x)", "f(\"exp(-r d)\");", "x = std::sqrt(y);", "a.log(x); b->log(x); Exp(x);"})
    EXPECT_EQ(status_with(passes), 0) << passes;
}

TEST(Elementary, TheCoefficientsAreThoseThatTheScriptDerives) {
  if (std::system("python3 -c 'import mpmath' 2> /dev/null") != 0) GTEST_SKIP() << "no mpmath here";
  const auto root = project::Root();
  const std::string same =
      "'" + (root / "script/elementary.py").string() + "' | cmp - '" + (root / "R1/Coefficients.h").string() + "'";
  EXPECT_EQ(std::system(same.c_str()), 0) << same;
}

}  // namespace
