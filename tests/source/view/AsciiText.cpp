#include "source/view/AsciiText.h"

#include <gtest/gtest.h>

namespace {

// A file "ref ü.png" was "ref " and two boxes.
TEST(AsciiText, HasLettersWithoutTheirAccents) {
  EXPECT_EQ(ray::InAscii("ref \u00fc.png"), "ref u.png");
  EXPECT_EQ(ray::InAscii("\u00c5ngstr\u00f6m, \u0141\u00f3d\u017a, Dvo\u0159\u00e1k"), "Angstrom, Lodz, Dvorak");
  EXPECT_EQ(ray::InAscii("1\u20132 \u201cso\u201d"), "1-2 \"so\"");
}

TEST(AsciiText, HasOneSignForEachThatItLacks) {
  EXPECT_EQ(ray::InAscii("\u5149\u7ebf"), "??");
  EXPECT_EQ(ray::InAscii("\xF0\x9F\x98\x80."), "?.");
  EXPECT_EQ(ray::InAscii("a\xFFz\xC3"), "a?z?");
  EXPECT_EQ(ray::InAscii("plain"), "plain");
}

}  // namespace
