#include "picture/hud/hud_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "canvas/typesetting.h"

namespace twrench::picture::hud_text {
namespace {

constexpr TimeUnit second{0.1, 1, "s", "s"};

TEST(Time, OfAMotionOfDaysIsInDays) {
  const TimeUnit unit = time_unit(24 * 86400);
  EXPECT_EQ(time(1519128, 2160, unit), "17.58 d");
  EXPECT_EQ(time(0, 2160, unit), "0.00 d");
  EXPECT_EQ(rounded_time(1519128, unit), "17.6 d");
  EXPECT_EQ(rounded_time(86400 * 1234.5, unit), "1234 d");
  EXPECT_EQ(rounded_time(12.34, second), "12.3 s");
  EXPECT_EQ(rounded_time(86399, second), "86399 s");
}

TEST(Time, ShowsWhatAFrameMovesOn) {
  EXPECT_EQ(time(30, 0.1, second), "30.0 s");
  EXPECT_EQ(time(1.0 / 60, 1.0 / 60, second), "0.02 s");
  EXPECT_EQ(time(0.12345, 1e-9, second), "0.123 s");
  EXPECT_EQ(time(50, 25, second), "50 s");
}

TEST(Time, GroupsLongNumbers) {
  EXPECT_EQ(time(1e6, 1, second), "1\u2009000\u2009000 s");
  EXPECT_EQ(time(9999.5, 0.1, second), "9999.5 s");
  EXPECT_EQ(time(12345.5, 0.1, second), "12\u2009345.5 s");
}

TEST(Time, IsAsWideWhateverTheDigits) {
  const canvas::Typeface typeface = canvas::load_typeface("sans");
  const auto width = [&](double t) {
    return canvas::typeset(typeface.regular, time(t, 0.1, second)).width;
  };
  for (const double digits : {1.0, 11.0, 123.0, 12345.0}) {
    EXPECT_NEAR(width(8 * digits), width(digits), 1e-9) << digits;
  }
}

TEST(Drift, IsWrittenAsInPrint) {
  EXPECT_EQ(drift(-1.2e-14), "−1.2×10⁻¹⁴");
  EXPECT_EQ(drift(3.24e2), "+3.2×10²");
  EXPECT_EQ(drift(0.5), "+0.50");
  EXPECT_EQ(drift(-0.0349), "−0.035");
  EXPECT_EQ(drift(0.00994), "+9.9×10⁻³");
  EXPECT_EQ(drift(0.00996), "+0.010") << "rounding carries";
  EXPECT_EQ(drift(0.0996), "+0.10");
  EXPECT_EQ(drift(0.996), "+1.0");
  EXPECT_EQ(drift(3.5), "+3.5");
  EXPECT_EQ(drift(9.96), "+10");
  EXPECT_EQ(drift(99.4), "+99");
  EXPECT_EQ(drift(99.6), "+1.0×10²");
  EXPECT_EQ(drift(9.96e-5), "+1.0×10⁻⁴") << "rounding carries";
  EXPECT_EQ(drift(1), "+1.0");
  EXPECT_EQ(drift(0), "<10⁻¹⁴");
  EXPECT_EQ(drift(-0.0), "<10⁻¹⁴");
  EXPECT_EQ(drift(9.9e-15), "<10⁻¹⁴") << "no digits of round-off";
  EXPECT_EQ(drift(1e300), "+1.0×10³⁰⁰");
  EXPECT_EQ(drift(std::numeric_limits<double>::infinity()), "+inf");
  EXPECT_EQ(error(-2.3e-15), "<10⁻¹⁴");
  EXPECT_EQ(error(-2.3e-14), "2.3×10⁻¹⁴");
}

TEST(Setting, IsAsShortAsCanBe) {
  EXPECT_EQ(setting(0.01), "0.01");
  EXPECT_EQ(setting(1e-10), "10⁻¹⁰");
  EXPECT_EQ(setting(2.5e-7), "2.5×10⁻⁷");
  EXPECT_EQ(setting(1), "1");
}

TEST(Method, SaysWhatItsErrorHangsOn) {
  const auto words = [](const char* name, scene::Language language = scene::Language::en) {
    const motion::FreeBody body(Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitX());
    timeline::Solution solution{&motion::find_method(name), {}, body, 0, {}, {}, {}, {}};
    solution.control.step = 0.025;
    solution.control.tolerance = 1e-8;
    return method(solution, language);
  };
  EXPECT_EQ(words("rkmk45"), "rkmk45, tolerance 10⁻⁸");
  EXPECT_EQ(words("lie-euler"), "lie-euler, step 0.025 s");
  EXPECT_EQ(words("exact"), "exact, closed form");
  EXPECT_EQ(words("exact", scene::Language::nb), "exact, lukket form");
}

}  // namespace
}  // namespace twrench::picture::hud_text
