#include "R3/Spawn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

TEST(Spawn, MovesACoordinateToTheNextDoubleAlongItsWay) {
  const double least = std::numeric_limits<double>::denorm_min();
  for (const double x : {0.0, least, 1e-300, 0.5, 1.0, 3.0, 1e300, std::numeric_limits<double>::max()})
    for (const double at : {x, -x})
      for (const double way : {1e-9, -1e-9, 5.0, -5.0}) {
        const double next = R3::NextAlong(at, way);
        EXPECT_EQ(next, std::nextafter(at, way < 0 ? -R3::infinity : R3::infinity)) << at << " along " << way;
      }
}

TEST(Spawn, LeavesACoordinateWhereItIsWithoutAWayOrFartherOn) {
  EXPECT_EQ(R3::NextAlong(1.5, 0), 1.5);
  EXPECT_EQ(R3::NextAlong(R3::infinity, 1), R3::infinity);
  EXPECT_EQ(R3::NextAlong(-R3::infinity, -1), -R3::infinity);
}

}  // namespace
