#include "source/text/Number.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <string>

namespace ray {
namespace {

double Value(const std::string& word) {
  const auto [value, problem] = ParseNumber(word);
  return problem ? std::nan("") : value;
}

TEST(Number, TheFormsOfRealScenesAreRead) {
  EXPECT_EQ(Value("+20"), 20);
  EXPECT_EQ(Value(".5"), 0.5);
  EXPECT_EQ(Value("5."), 5);
  EXPECT_EQ(Value("-.7071"), -0.7071);
  EXPECT_EQ(Value("01.57"), 1.57);
  EXPECT_EQ(Value("1e-3"), 0.001);
  EXPECT_EQ(Value("-1E+3"), -1000);
  EXPECT_TRUE(std::signbit(Value("-0")));
}

TEST(Number, TheWholeWordMustBeANumber) {
  for (const char* word :
       {"",    "+",    "-",      ".",   "e5",  "1e",   "1e+", "12abc",  "1..2", "1.2.3", "+-1",       "-+1", "++1",
        "--1", "0x10", "-0x1p3", "1,5", "nan", "-nan", "NaN", "nan(1)", "inf",  "+inf",  "-Infinity", "1 "})
    EXPECT_TRUE(ParseNumber(word).problem) << word;
}

TEST(Number, TheProblemSaysWhatToDo) {
  EXPECT_STREQ(ParseNumber("abc").problem, "must be a number");
  EXPECT_STREQ(ParseNumber("nan").problem, "must be a finite number");
  EXPECT_STREQ(ParseNumber("-inf").problem, "must be a finite number");
  EXPECT_STREQ(ParseNumber("0x1p3").problem, "must be a decimal number");
  EXPECT_STREQ(ParseNumber("1,5").problem, "must be a number, with a point and no comma");
}

// The output of printf for NaN and infinity on several systems. Microsoft's up to 2013 rounds the letters to the
// requested digits as if they were a number.
TEST(Number, NanAndInfinityOfEverySystemAreRecognized) {
  for (const char* word :
       {"1.#QNAN", "-1.#IND",   "1.#INF",    "+1.#INF", "1.#SNAN", "1.#INF00", "-1.#IND000",     "1.#QNAN0",
        "1.#J",    "-1.#J",     "1.#IO",     "1.#R",    "1.#QO",   "1.#QNB",   "1.#INF000e+000", "1.#inf",
        "1.#NAN",  "-nan(ind)", "nan(snan)", "NaNQ",    "NaNS",    "Infinity", "-INF",           "+nan"}) {
    EXPECT_TRUE(SaysNanOrInfinity(word)) << word;
    EXPECT_STREQ(ParseNumber(word).problem, "must be a finite number") << word;
  }
  for (const char* word : {"1", "", "-", "1.#", "1.#comment", "1.#INFO", "1.#index", "1.#Jack", "2.#INF", "1#INF",
                           "1.#INFe", "1.#INFe+", "nancy", "info", "information", "nan(", "#QNAN"})
    EXPECT_FALSE(SaysNanOrInfinity(word)) << word;
}

TEST(Extremes, K6_OverflowIsAnErrorAndUnderflowIsNone) {
  EXPECT_TRUE(ParseNumber("1e400").problem);
  EXPECT_TRUE(ParseNumber("-1e999999999999999999999").problem);
  EXPECT_TRUE(ParseNumber(std::string(400, '9')).problem);
  EXPECT_TRUE(ParseNumber("0." + std::string(400, '0') + "1e900").problem);
  EXPECT_EQ(Value("1e-999"), 0);
  EXPECT_EQ(Value("-1e-999999999999999999999"), 0);
  EXPECT_EQ(Value("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(Value(std::string(400, '9') + "e-900"), 0);
  EXPECT_EQ(Value("0e999"), 0);
  EXPECT_EQ(Value("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(Value("1.7976931348623157e308"), std::numeric_limits<double>::max());
}

TEST(Extremes, K6_TenThousandDigitsAreStillANumber) {
  EXPECT_EQ(Value("0." + std::string(10000, '3')), 1.0 / 3);
  std::string seven(10000, '0');
  seven += "7";
  EXPECT_EQ(Value(seven), 7);
}

TEST(Extremes, K6_TheLocaleHasNoEffect) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"})
    if (std::setlocale(LC_ALL, name)) break;
  EXPECT_EQ(Value("1.5"), 1.5);
  EXPECT_TRUE(ParseNumber("1,5").problem);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Number, WholeNumbersAreWhole) {
  EXPECT_EQ(ParseWhole("+3").value, 3);
  EXPECT_EQ(ParseWhole("-1").value, -1);
  EXPECT_EQ(ParseWhole("007").value, 7);
  for (const char* word : {"", "+", "1.0", "1e3", "+-1", "0x1", "99999999999999999999", "one"})
    EXPECT_TRUE(ParseWhole(word).problem) << word;
}

}  // namespace
}  // namespace ray
