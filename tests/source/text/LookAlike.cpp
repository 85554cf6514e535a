#include "source/text/LookAlike.h"

#include <gtest/gtest.h>

namespace ray {
namespace {

TEST(LookAlike, AWordWithOneGetsAHintWhatToType) {
  EXPECT_EQ(LookAlikeHint("\u22121"), "it has U+2212, a minus sign: type '-1'");
  EXPECT_EQ(LookAlikeHint("1\u20132"), "it has U+2013, an en dash: type '1-2'");
  EXPECT_EQ(LookAlikeHint("sphere\u00A0-1"), "it has U+00A0, a no-break space: type 'sphere -1'");
  EXPECT_EQ(LookAlikeHint("\uFEFFcamera"), "it has U+FEFF, a byte order mark, which is invisible: type 'camera'");
  EXPECT_EQ(LookAlikeHint("\u201Ca.png\u201D"), "it has U+201C, a curly quotation mark: type '\"a.png\"'");
  EXPECT_EQ(LookAlikeHint("\uFF11\uFF12\uFF0E\uFF15"), "it has U+FF11, a full-width character: type '12.5'");
  EXPECT_EQ(LookAlikeHint("\u200B"), "it has U+200B, a zero-width space: delete it");
  EXPECT_EQ(LookAlikeHint("\u3000"), "it has U+3000, an ideographic space: type a space");
}

TEST(LookAlike, OtherWordsGetNoHint) {
  for (const char* word : {"", "-1.5e3", "größe", "木.png", "\xFF\x80", "\xE2\x88", "a'b\"c"})
    EXPECT_EQ(LookAlikeHint(word), "") << word;
}

// For each digit of each script, the digit itself, by counting.
TEST(LookAlike, DigitsOfOtherScriptsAreTheDigits) {
  for (const char* zero : {"\u0660", "\u06F0", "\uFF10"})
    for (int digit = 0; digit <= 9; ++digit) {
      std::string text = zero;
      text.back() = static_cast<char>(text.back() + digit);
      EXPECT_EQ(WithoutLookAlikes("x" + text + "y"), "x" + std::to_string(digit) + "y");
    }
}

TEST(LookAlike, BytesThatAreNotTextStay) {
  EXPECT_EQ(WithoutLookAlikes("\xFF\u2212\xE2\x88"), "\xFF-\xE2\x88");
  EXPECT_EQ(WithoutLookAlikes("größe\u2212"), "größe-");
}

}  // namespace
}  // namespace ray
