#include "recording/digits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "table/number_text.h"

namespace twrench::recording {
namespace {

template <typename Kind>
Resolution resolution_of(const std::vector<std::string>& texts, double unit = 1) {
  Kind digits;
  for (const std::string& text : texts) {
    table::Number number;
    EXPECT_EQ(table::read_number(text, false, number), table::Reading::number) << text;
    digits.add(number);
  }
  return digits.resolution(unit);
}

/// Values of a rate, written with a format of fmt.
std::vector<std::string> written(const std::string& format, double amplitude = 50) {
  std::vector<std::string> texts;
  for (int i = 0; i < 500; ++i) {
    texts.push_back(fmt::format(fmt::runtime(format), amplitude * std::sin(0.1 * i * i)));
  }
  return texts;
}

TEST(Digits, OfFixedDecimalsAreThoseOfTheLastPlace) {
  const Resolution resolution = resolution_of<Digits>(written("{:.4f}"));
  EXPECT_DOUBLE_EQ(resolution.at(0.01), 1e-4);
  EXPECT_DOUBLE_EQ(resolution.at(99), 1e-4);
  EXPECT_DOUBLE_EQ(resolution.at(0), 1e-4);
}

TEST(Digits, OfSignificantDigitsFollowTheSize) {
  for (const char* format : {"{:.6g}", "{:.5e}"}) {
    const Resolution resolution = resolution_of<Digits>(written(format));
    EXPECT_DOUBLE_EQ(resolution.at(12), 1e-4) << format;
    EXPECT_DOUBLE_EQ(resolution.at(99), 1e-4) << format;
    EXPECT_DOUBLE_EQ(resolution.at(-0.12), 1e-6) << format;
    EXPECT_LT(resolution.at(0), 1e-300) << format;
  }
}

TEST(Digits, OfDoublesAreAllThatTheyHave) {
  for (const char* format : {"{}", "{:.17g}"}) {
    const Resolution resolution = resolution_of<Digits>(written(format));
    EXPECT_DOUBLE_EQ(resolution.at(30), 30 * std::numeric_limits<double>::epsilon()) << format;
  }
}

TEST(Digits, OfSinglePrecisionAreNotMoreThanThoseOfFloats) {
  std::vector<std::string> texts;
  for (int i = 0; i < 100; ++i)
    texts.push_back(fmt::format("{}", double(std::sin(0.1F * float(i)))));
  const Resolution resolution = resolution_of<Digits>(texts);
  EXPECT_DOUBLE_EQ(resolution.at(1.5), std::numeric_limits<float>::epsilon());
  EXPECT_DOUBLE_EQ(resolution.at(30), 16 * double(std::numeric_limits<float>::epsilon()));
  // Numbers that are floats by chance do not count.
  EXPECT_LT(resolution_of<Digits>({"0.5000000000", "0.2500000000"}).at(0.5), 1e-9);
}

// Such a decimal is up to half a spacing from its float, which is as far from the exact number.
TEST(Digits, OfTheShortestDecimalsOfFloatsHaveTheirErrorsToo) {
  std::vector<std::string> texts;
  for (int i = 0; i < 100; ++i) texts.push_back(fmt::format("{}", std::sin(0.1F * float(i))));
  const double resolution = resolution_of<Digits>(texts).at(1.5);
  EXPECT_GT(resolution, 1.8 * double(std::numeric_limits<float>::epsilon()));
  EXPECT_LE(resolution, 2 * double(std::numeric_limits<float>::epsilon()));
}

// Beyond 2^24 they are whole numbers that zeros fill up to the point.
TEST(Digits, OfTheShortestDecimalsOfLargeFloatsAreThoseOfFloats) {
  std::vector<std::string> texts;
  for (int i = 0; i < 100; ++i)
    texts.push_back(
        fmt::format("{:.0f}", std::stod(fmt::format("{}", 3e12F * std::sin(0.1F * float(i))))));
  const Resolution resolution = resolution_of<Digits>(texts);
  EXPECT_EQ(resolution.written, NumberFormat::float32);
  EXPECT_GE(resolution.at(3e12), std::exp2(18));  // the spacing of floats there
  EXPECT_LE(resolution.at(3e12), std::exp2(19));
}

TEST(Digits, OfLargeWholeNumbersAreTheirOwn) {
  EXPECT_DOUBLE_EQ(resolution_of<Digits>(written("{:.0f}", 3e12)).at(3e12), 1);
}

// All of them are values of float32.
TEST(Digits, OfWholeNumbersInMemoryAreTheirOwn) {
  Digits digits;
  for (int i = 0; i < 500; ++i) digits.add({.value = std::round(32767 * std::sin(0.1 * i))});
  EXPECT_EQ(digits.resolution(1).written, NumberFormat::decimals);
  EXPECT_DOUBLE_EQ(digits.resolution(1).at(30000), 1);
}

// As in NASA's simulator 01: 12 digits of rad/s, converted to deg/s with 17.
TEST(Digits, ThatAChangeOfTheUnitAddedDoNotCount) {
  for (const double factor :
       {57.295779513, 180 / 3.14159265358979323846, 57.3, 0.017453292519943295, 1.0}) {
    std::vector<std::string> texts;
    for (int i = 1; i < 100; ++i) {
      const double printed = std::stod(fmt::format("{:.11e}", 0.5 * std::sin(0.1 * i)));
      texts.push_back(fmt::format("{}", printed * factor));
    }
    const Resolution resolution = resolution_of<Digits>(texts);
    EXPECT_NEAR(resolution.at(0.2 * factor), 1e-12 * factor, 1e-15 * factor) << factor;
    EXPECT_NEAR(resolution.at(0.02 * factor), 1e-13 * factor, 1e-16 * factor) << factor;
  }
  // There are too few numbers to decide, so all digits count.
  EXPECT_LT(resolution_of<Digits>({"0.50000000000000000", "1.5000000000000000"}).at(1), 1e-15);
}

TEST(Digits, AreInOurUnit) {
  const double degree = 3.14159265358979323846 / 180;
  EXPECT_DOUBLE_EQ(resolution_of<Digits>(written("{:.4f}"), degree).at(1), 1e-4 * degree);
  EXPECT_DOUBLE_EQ(resolution_of<Digits>(written("{:.6g}"), degree).at(12 * degree), 1e-4 * degree);
}

TEST(TimeDigits, OfEqualStepsAreExact) {
  for (const char* step : {"{:.1f}", "{}"}) {
    std::vector<std::string> texts;
    for (int i = 0; i < 1000; ++i) texts.push_back(fmt::format(fmt::runtime(step), 0.1 * i));
    EXPECT_LT(resolution_of<TimeDigits>(texts).at(100), 1e-13) << step;
  }
}

TEST(TimeDigits, OfRoundedStepsAreTheirLastPlace) {
  std::vector<std::string> texts;
  for (int i = 0; i < 1000; ++i) texts.push_back(fmt::format("{:.3f}", i / 60.0));
  EXPECT_DOUBLE_EQ(resolution_of<TimeDigits>(texts).at(10), 1e-3);
}

// A clock since 1970 that is cut off after the microseconds.
TEST(TimeDigits, OfClocksAreThoseOfTheDifferences) {
  std::vector<std::string> seconds, nanoseconds, equal, doubles;
  for (std::int64_t i = 0; i < 100; ++i) {
    seconds.push_back(fmt::format("17000000{:02}.{:06}", i / 30, i % 30 * 1000000 / 30));
    nanoseconds.push_back(fmt::format("17000000{:02}{:06}000", i / 30, i % 30 * 1000000 / 30));
    equal.push_back(fmt::format("{}", 1700000000000000000 + i * 20000001));
    doubles.push_back(fmt::format("{:.17g}", 1.7e9 + 0.0333333333 * double(i * i)));
  }
  EXPECT_DOUBLE_EQ(resolution_of<TimeDigits>(seconds).at(3), 1e-6);
  EXPECT_DOUBLE_EQ(resolution_of<TimeDigits>(nanoseconds, 1e-9).at(3), 1e-6);
  EXPECT_LT(resolution_of<TimeDigits>(equal, 1e-9).at(3), 1e-8);
  EXPECT_NEAR(resolution_of<TimeDigits>(doubles).at(3), 3.8e-7, 0.1e-7);
  EXPECT_LT(resolution_of<TimeDigits>({"1772619065.123456789"}).at(3), 1e-6);  // no difference
}

TEST(TimeDigits, OfAFewRoundNumbersAreExact) {
  for (const std::vector<std::string>& texts : {std::vector<std::string>{"0", "10"},
                                                {"0", "5"},
                                                {"0", "0.5", "10", "100"},
                                                {"0.0", "2.50"}}) {
    EXPECT_LT(resolution_of<TimeDigits>(texts).at(10), 1e-14) << texts.back();
  }
  EXPECT_DOUBLE_EQ(resolution_of<TimeDigits>({"0", "3.83"}).at(3.83), 0.01);
  std::vector<std::string> rounded;  // by a clock of 60 ticks a second
  for (int i = 0; i < 20; ++i) rounded.push_back(fmt::format("{:.2f}", i / 60.0));
  EXPECT_DOUBLE_EQ(resolution_of<TimeDigits>(rounded).at(0.3), 0.01);
}

TEST(TimeDigits, OfSinglePrecisionAreThoseOfFloats) {
  std::vector<std::string> texts;
  for (int i = 0; i < 1000; ++i) texts.push_back(fmt::format("{}", double(float(0.01 * i))));
  EXPECT_EQ(texts[1], "0.009999999776482582");
  EXPECT_DOUBLE_EQ(resolution_of<TimeDigits>(texts).at(9),
                   8 * double(std::numeric_limits<float>::epsilon()));
}

}  // namespace
}  // namespace twrench::recording
