// Vectors whose values are stored inside the object as long as they fit.
#include "R1/StackVector.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

TEST(StackVector, HoldsMoreThanFitsInside) {
  R1::StackVector<int, 4> values;
  for (int i = 0; i < 1000; ++i) values.push_back(i);
  ASSERT_EQ(values.size(), 1000u);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(values[static_cast<std::size_t>(i)], i);
  values.truncate(3);
  EXPECT_EQ(values.back(), 2);
}

TEST(StackVector, IsAssignedAnyNumberOfEqualValues) {
  for (const std::size_t count : {0u, 4u, 5u, 100u}) {
    R1::StackVector<double, 4> values;
    values.push_back(1);
    values.assign(count, 7.5);
    EXPECT_EQ(values.size(), count);
    EXPECT_EQ(static_cast<std::size_t>(std::count(values.begin(), values.end(), 7.5)), count);
    EXPECT_EQ(values.empty(), count == 0);
  }
}

}  // namespace
