// Runs all tests, but only where floating-point numbers behave as the program's promises need them to (extremes, J5
// and J6): everything else measured there would be measured wrong.
#include <gtest/gtest.h>

#include <cfenv>
#include <cfloat>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace {

// Read through volatile, so that the compiler cannot answer in its own arithmetic.
double Opaque(double x) {
  volatile double y = x;
  return y;
}

bool RoundsToNearest() {
  return std::fegetround() == FE_TONEAREST && Opaque(1) + Opaque(DBL_EPSILON / 2) == 1 &&
         Opaque(1) + Opaque(DBL_EPSILON * 0.75) == 1 + DBL_EPSILON;
}

bool KeepsDenormals() {
  const double denormal = Opaque(DBL_MIN) / Opaque(4);
  return denormal > 0 && denormal * Opaque(4) == DBL_MIN;
}

// (1 + h)^2 = 1 + 2h + h^2, and with h = 2^-30 the last term is lost when the product is rounded on its own.
bool RoundsProductsBeforeAdding() {
  const double a = Opaque(1 + 0x1p-30), b = Opaque(1 + 0x1p-29);
  return a * a - b == 0;
}

// RoundsProductsBeforeAdding where the compiler may use an instruction that does both, as in kernels for such machines.
#if defined(__x86_64__)
[[gnu::target("fma"), gnu::noinline]] bool RoundsProductsWhereItNeedNot() {
  const double a = Opaque(1 + 0x1p-30), b = Opaque(1 + 0x1p-29);
  return a * a - b == 0;
}
bool RoundsProductsEverywhere() { return !__builtin_cpu_supports("fma") || RoundsProductsWhereItNeedNot(); }
#else
bool RoundsProductsEverywhere() { return RoundsProductsBeforeAdding(); }
#endif

bool KnowsNanAndInfinity() {
#ifdef __FAST_MATH__
  return false;
#else
  const double nan = Opaque(std::numeric_limits<double>::quiet_NaN());
  const double infinity = Opaque(std::numeric_limits<double>::infinity());
  return nan != nan && !(nan < 0) && !(nan >= 0) && infinity > DBL_MAX && 1 / Opaque(-0.0) == -infinity;
#endif
}

struct Pair {
  double a = 0, b = 0;
};

// g++ 12 with vectorization of straight code leaves the rounding to float away here.
[[gnu::noinline]] Pair RoundBoth(const Pair& p) {
  return {static_cast<double>(static_cast<float>(p.a)), static_cast<double>(static_cast<float>(p.b))};
}

bool RoundsNeighborsToFloat() {
  const Pair rounded = RoundBoth({Opaque(0.1), Opaque(0.7)});
  volatile float a = static_cast<float>(Opaque(0.1)), b = static_cast<float>(Opaque(0.7));
  return rounded.a == static_cast<double>(a) && rounded.b == static_cast<double>(b) && rounded.a != 0.1;
}

struct Fact {
  const char* name;
  bool (*holds)();
};

constexpr Fact facts[] = {
    {"numbers are rounded to nearest", RoundsToNearest},
    {"denormal numbers are kept", KeepsDenormals},
    {"products are rounded before they are added to (-ffp-contract=off)", RoundsProductsBeforeAdding},
    {"products are rounded before they are added to even where one instruction could do both (-ffp-contract=off)",
     RoundsProductsEverywhere},
    {"NaN and infinity are respected (no -ffast-math)", KnowsNanAndInfinity},
    {"double(float(x)) of neighboring members is rounded (-fno-tree-slp-vectorize)", RoundsNeighborsToFloat},
};

bool EnvironmentIsFit() {
  bool is_fit = true;
  for (const Fact& fact : facts) {
    if (fact.holds()) continue;
    std::fprintf(stderr, "refusing to test: it is not true here that %s\n", fact.name);
    is_fit = false;
  }
  return is_fit;
}

/// Collects why tests were skipped.
class SkipReasons : public testing::EmptyTestEventListener {
 public:
  // GpuCache from here: while a result is told, the framework holds the lock that asking for the test would take.
  void OnTestStart(const testing::TestInfo& test) override {
    test_ = std::string(test.test_suite_name()) + "." + test.name();
  }
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (result.skipped()) reasons_.push_back(test_ + ": " + result.message());
  }
  void Print() const {
    if (!reasons_.empty()) std::printf("skipped:\n");
    for (const std::string& reason : reasons_) std::printf("  %s\n", reason.c_str());
  }

 private:
  std::string test_;
  std::vector<std::string> reasons_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!EnvironmentIsFit()) return 1;
  auto* reasons = new SkipReasons;  // the listeners own it from here on
  testing::UnitTest& all = *testing::UnitTest::GetInstance();
  all.listeners().Append(reasons);
  const int status = RUN_ALL_TESTS();
  reasons->Print();
  std::printf("%d passed, %d failed, %d skipped\n", all.successful_test_count(), all.failed_test_count(),
              all.skipped_test_count());
  return status;
}
