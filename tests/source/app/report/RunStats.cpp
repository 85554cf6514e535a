#include "source/app/report/RunStats.h"

#include <gtest/gtest.h>

namespace ray {
namespace {

// Light that is cut off darkens an image; shares of samples that follow its noise do not.
TEST(RunStats, LostLightIsDistinguishedFromOtherBias) {
  RunStats stats;
  stats.options.render.budget.error = ErrorTarget{2, ErrorUnit::display};
  stats.share_cut = 0.02;
  const auto limits = [&](const std::vector<std::string>& biased) {
    stats.biased = biased;
    const std::string line = QualityLines(stats);
    return line.substr(line.find("samples per pixel") + 17);
  };
  EXPECT_EQ(limits({"max_depth 3", "adaptive tile"}),
            "; limited by -max_depth 3 (too dark by about 2%), biased by -adaptive tile\n");
  EXPECT_EQ(limits({"max_depth 3", "min_luminance 0.01"}),
            "; limited by -max_depth 3, -min_luminance 0.01 (too dark by about 2%)\n");
  stats.share_cut = 0;
  EXPECT_EQ(limits({"max_depth 3", "adaptive tile"}), "; biased by -adaptive tile\n");
  EXPECT_EQ(limits({}), "\n");
}

}  // namespace
}  // namespace ray
