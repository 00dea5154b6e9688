#include "table/number_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace twrench::table {
namespace {

Number read(std::string_view text, bool decimal_comma = false) {
  Number number;
  EXPECT_EQ(read_number(text, decimal_comma, number), Reading::number) << text;
  return number;
}

Reading reading_of(std::string_view text, bool decimal_comma = false) {
  Number number;
  return read_number(text, decimal_comma, number);
}

TEST(NumberText, IsReadToTheLastBit) {
  EXPECT_EQ(read("0.1").value, 0.1);
  EXPECT_EQ(read("9007199254740993").value, 9007199254740992.0);
  EXPECT_EQ(read("2.2250738585072011e-308").value, 2.2250738585072011e-308);
  EXPECT_EQ(read("1.7976931348623157e308").value, std::numeric_limits<double>::max());
  EXPECT_TRUE(std::signbit(read("-0").value));
}

// Random digits, and decimals halfway between two doubles, which are rounded to the even one.
TEST(NumberText, IsReadAsByTheStandardLibrary) {
  std::mt19937_64 random(7);
  const auto expect_same = [](const std::string& text) {
    const double expected = std::strtod(text.c_str(), nullptr);
    EXPECT_EQ(read(text).value, expected) << text;
    EXPECT_EQ(read("-" + text).value, -expected) << text;
  };
  for (int i = 0; i < 200'000; ++i) {
    std::string digits = std::to_string(random() >> random() % 64);
    if (random() % 4 == 0) digits = std::string(random() % 8, '0') + digits;
    if (random() % 8 != 0) digits.insert(random() % (digits.size() + 1), ".");
    if (random() % 8 == 0) digits += fmt::format("e{}", static_cast<int>(random() % 60) - 30);
    expect_same(digits);
  }
  for (std::uint64_t odd = (1ULL << 53U) + 1; odd < (1ULL << 53U) + 4000; odd += 2) {
    expect_same(std::to_string(odd));         // halfway
    expect_same(fmt::format("{}.001", odd));  // just above
    expect_same(fmt::format("0.{}", odd));
    std::uint64_t digits = odd;
    for (std::uint64_t decimals = 1; decimals <= 4; ++decimals) {  // halves, quarters ... of it
      digits *= 5;
      const std::string text = std::to_string(digits);
      expect_same(std::string(text).insert(text.size() - decimals, "."));
    }
  }
  // As near to the middle of two doubles as 22 decimals can be, but not there.
  for (const char* text :
       {"0.0004884155683295772119", "0.0004883853502495243506", "0.0002443269934543393872",
        "0.0002441926751247621753", "0.0001221634967271696936", "0.0001222155468519318689"}) {
    expect_same(text);
  }
  for (const char* text : {"8.5", "0.000", "18446744073709551615", "9999999999999999999",
                           "0.9999999999999999999", "9007199254740993e0", "9007199254740993e22"}) {
    expect_same(text);
  }
}

TEST(NumberText, MayHaveASignAndFortransExponent) {
  EXPECT_EQ(read("+1.5").value, 1.5);
  EXPECT_EQ(read("-.5").value, -0.5);
  EXPECT_EQ(read("1.5D+02").value, 150);
  EXPECT_EQ(read("-1.5d-2").value, -0.015);
  EXPECT_EQ(read("1,5", true).value, 1.5);
  EXPECT_EQ(read("-1,5E1", true).value, -15);
}

TEST(NumberText, IsNotEveryText) {
  for (const char* text : {"", "+", "-", "+-1", "1 2", "1,5", "0x10", "1e", "1e+", "abc", "1.5f",
                           "1:30", "d", "1d", "--1", "1_000", "e5", "."}) {
    EXPECT_EQ(reading_of(text), Reading::text) << text;
  }
  EXPECT_EQ(reading_of("1.5", true), Reading::text);
  EXPECT_EQ(reading_of("1,2,3", true), Reading::text);
}

TEST(NumberText, IsTooLargeOrTooSmall) {
  EXPECT_EQ(reading_of("1e309"), Reading::too_large);
  EXPECT_EQ(reading_of("-1e99999999999"), Reading::too_large);
  EXPECT_EQ(reading_of("1" + std::string(400, '0')), Reading::too_large);
  EXPECT_EQ(read("1e-400").value, 0);
  EXPECT_EQ(read("0." + std::string(400, '0') + "1").value, 0);
  EXPECT_EQ(read("1e-99999999999").value, 0);
}

TEST(NumberText, TellsItsDigits) {
  const auto expect = [](std::string_view text, int decimals, int significant) {
    const Number number = read(text);
    EXPECT_EQ(number.decimals, decimals) << text;
    EXPECT_EQ(number.significant, significant) << text;
  };
  expect("12.340", 3, 5);
  expect("-0.00120", 5, 3);
  expect("1.5e-3", 4, 2);
  expect("1.50E2", 0, 3);
  expect("12e2", -2, 2);
  expect("1200", 0, 4);
  expect("0.000", 3, 0);
  expect("0", 0, 0);
}

double rest_of(std::string_view text) {
  Number number;
  EXPECT_EQ(read_number(text, false, number), Reading::number) << text;
  return number.rest;
}

// As clocks that count from 1970 need them.
TEST(NumberText, KeepsWhatADoubleRoundsAway) {
  EXPECT_EQ(rest_of("1700000000123456789"), 1700000000123456789 - 1700000000123456768);
  EXPECT_EQ(rest_of("-1700000000123456789"), -21);
  EXPECT_EQ(rest_of("1.700000000123456789e18"), 21);
  EXPECT_EQ(rest_of("17000000001234567.89e2"), 21);
  EXPECT_NEAR(rest_of("1700000000.123456"), -1.28173828125e-9, 1e-20);
  EXPECT_NEAR(rest_of("0.1"), -5.551115123125783e-18, 1e-30);
  for (const char* text : {"0", "0.5", "1e22", "9007199254740992", "nan", "1e300", "1e-300"}) {
    EXPECT_EQ(rest_of(text), 0) << text;
  }
}

}  // namespace
}  // namespace twrench::table
