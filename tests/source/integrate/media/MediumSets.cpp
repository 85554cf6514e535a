#include "source/integrate/media/MediumSets.h"

#include <gtest/gtest.h>

#include "tests/Project.h"
#include "tests/extremes/KnownScenes.h"

namespace ray {
namespace {

/// Glass (1.5), water (1.33) of a higher priority, and two more solids of glass; all of them absorb.
project::Stage Solids() {
  return statistics::StageOf(statistics::Material(0, 0, 1, 0, 10, 1.5) + statistics::Material(0, 0, 1, 0, 10, 1.33) +
                             statistics::Material(0, 0, 1, 0, 10, 1.7) +
                             "absorb 0 1 0 0 absorb 1 0 1 0 absorb 2 0 0 1 priority 1 2 "
                             "sphere 0 0 0 0 1 sphere 1 0 0 0 1.1 sphere 0 0 0 0 1.2 sphere 2 0 0 0 1.3");
}

TEST(MediumSets, AreTheSameHoweverTheyAreEntered) {
  const project::Stage stage = Solids();
  MediumSets sets;
  const auto all = sets.With(sets.With(sets.With(0, 0, stage.world), 1, stage.world), 3, stage.world);
  EXPECT_EQ(sets.With(sets.With(sets.With(0, 3, stage.world), 0, stage.world), 1, stage.world), all);
  EXPECT_EQ(sets.With(all, 1, stage.world), all);
  EXPECT_EQ(sets.Without(all, 2, stage.world), all);
  EXPECT_TRUE(sets.Has(all, 3, stage.world));
  EXPECT_FALSE(sets.Has(all, 2, stage.world));
  EXPECT_EQ(sets.Without(sets.Without(sets.Without(all, 3, stage.world), 0, stage.world), 1, stage.world), 0u);
}

TEST(MediumSets, AreFilledByHighestPriorityThenFirstSolid) {
  const project::Stage stage = Solids();
  MediumSets sets;
  EXPECT_EQ(sets.At(0, stage.world).Index(), 1);
  const auto glass = sets.With(0, 0, stage.world), two = sets.With(glass, 2, stage.world);
  EXPECT_EQ(sets.At(glass, stage.world).Index(), 1.5);
  EXPECT_EQ(sets.At(two, stage.world).absorb, (R2::Color{1, 0, 0}));  // once for both solids
  const auto mixed = sets.With(two, 3, stage.world);
  EXPECT_EQ(sets.At(mixed, stage.world).Index(), 1.5);
  EXPECT_EQ(sets.At(mixed, stage.world).absorb, (R2::Color{1, 0, 1}));
  const auto watery = sets.With(mixed, 1, stage.world);
  EXPECT_EQ(sets.At(watery, stage.world).Index(), 1.33);
  EXPECT_EQ(sets.At(watery, stage.world).absorb, (R2::Color{0, 1, 0}));
}

}  // namespace
}  // namespace ray
