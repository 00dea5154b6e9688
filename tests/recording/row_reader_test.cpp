#include "recording/row_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "recording/columns/columns.h"
#include "recording/columns/open_conventions.h"
#include "recording/conventions/attitude.h"
#include "recording/conventions/body_axes.h"
#include "system/error.h"

namespace twrench::recording {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

constexpr double degree = std::numbers::pi / 180;

/// A reader of the text by the only convention that its names and `said` leave open.
RowReader reader_of(std::string_view text, const Convention& said = {}) {
  auto table = table::open_table("run.csv", text);
  const auto all = conventions(table->header(), said);
  EXPECT_THAT(all, SizeIs(1));
  return {std::move(table), all.front()};
}

std::vector<Row> rows_of(RowReader& reader) {
  std::vector<Row> rows;
  for (Row row; reader.next(row);) rows.push_back(row);
  return rows;
}

std::vector<Row> rows_of(std::string_view text, const Convention& said = {}) {
  RowReader reader = reader_of(text, said);
  return rows_of(reader);
}

std::string refusal(std::string_view text, const Convention& said = {}) {
  try {
    rows_of(text, said);
  } catch (const table::BadTable& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

Convention with_sequence(const std::string& sequence) {
  Convention said;
  said.sequence = sequence;
  return said;
}

TEST(RowReader, ReadsRatesAndTimes) {
  RowReader reader = reader_of("t,wx,wy,wz\n0.5,1,-2,3\n1.5,4,5,6\n");
  EXPECT_TRUE(reader.has_rates());
  EXPECT_EQ(reader.attitude(), AttitudeForm::none);
  const std::vector<Row> rows = rows_of(reader);
  ASSERT_THAT(rows, SizeIs(2));
  EXPECT_EQ(rows[1].number, 2U);
  EXPECT_EQ(rows[0].t, 0);
  EXPECT_EQ(rows[1].t, 1);
  EXPECT_EQ(reader.first_time(), 0.5);
  EXPECT_EQ(rows[0].omega, Eigen::Vector3d(1, -2, 3));
  EXPECT_EQ(reader.place(), "run.csv:3");
}

TEST(RowReader, ConvertsUnits) {
  const std::vector<Row> rows =
      rows_of("time_ms,p (deg/s),q (deg/s),r (deg/s)\n0,180,90,-45\n250,1,2,3\n");
  EXPECT_DOUBLE_EQ(rows[1].t, 0.25);
  EXPECT_TRUE(rows[0].omega.isApprox(degree * Eigen::Vector3d(180, 90, -45), 1e-15));
  Convention said;
  said.rate_unit = RateUnit::deg_s;
  EXPECT_TRUE(rows_of("t,p,q,r\n0,180,90,-45\n", said)[0].omega.isApprox(rows[0].omega, 1e-15));
  EXPECT_EQ(rows_of("t,p,q,r\n0,1,2,3\n")[0].omega, Eigen::Vector3d(1, 2, 3));
  said.rate_unit = RateUnit::rpm;
  said.time_unit = TimeUnit::min;
  const Row minute = rows_of("t,p,q,r\n0,1,2,3\n0.5,60,0,-30\n", said)[1];
  EXPECT_DOUBLE_EQ(minute.t, 30);
  EXPECT_TRUE(minute.omega.isApprox(360 * degree * Eigen::Vector3d(1, 0, -0.5), 1e-15));
}

// A double near 1.7e9 has a spacing of 2.4e-7.
TEST(RowReader, SubtractsTheFirstTimeBeforeDigitsAreLost) {
  Convention nanoseconds;
  nanoseconds.time_unit = TimeUnit::ns;
  const Convention seconds;
  for (const auto& [text, convention] :
       {std::pair("t,wx,wy,wz\n1700000000.123456,1,2,3\n1700000000.143457,1,2,3\n", seconds),
        std::pair("t,wx,wy,wz\n1700000000123456000,1,2,3\n1700000000143457000,1,2,3\n",
                  nanoseconds),
        std::pair("t,wx,wy,wz\n-1.7e9,1,2,3\n-1699999999.979999,1,2,3\n", seconds),
        std::pair("[[1700000000.123456,1,2,3],[1700000000.143457,1,2,3]]", seconds)}) {
    Convention columns = convention;
    if (text[0] == '[') columns.columns = {{"t", "#1"}, {"wx", "#2"}, {"wy", "#3"}, {"wz", "#4"}};
    EXPECT_NEAR(rows_of(text, columns)[1].t, 0.020001, 1e-17) << text;
  }
  // Their doubles are the same.
  EXPECT_NEAR(
      rows_of("t,wx,wy,wz\n1700000000000000000,1,2,3\n1700000000000000001,1,2,3\n", nanoseconds)[1]
          .t,
      1e-9, 1e-24);
}

TEST(RowReader, TakesRoundRatesBesideAllDigitsForExact) {
  for (const auto& [rates, digit] :
       {std::pair("0,20,0", 20 * 2.3e-16), std::pair("0,21.5,0", 0.1)}) {
    const std::string text = fmt::format(
        "t,qw,qx,qy,qz,wx,wy,wz\n0,0.70710678118654757,0,0,0.70710678118654746,{0}\n1,1,0,0,0,{0}"
        "\n",
        rates);
    RowReader reader = reader_of(text);
    rows_of(reader);
    EXPECT_NEAR(reader.rate_resolution().at(20), digit, 0.5 * digit) << rates;
  }
}

// A simulator without a gyroscopic term writes 0.05, 2 and 0.03 in each row.
TEST(RowReader, TakesRatesAtWhichTheAttitudeTurnsForExact) {
  const auto digit_of = [](const Eigen::Vector3d& turning_at, int decimals) {
    std::string text = "t,qw,qx,qy,qz,wx,wy,wz\n";
    for (int i = 0; i < 50; ++i) {
      const Eigen::Quaterniond q(so3::exp(0.1 * i * turning_at));
      text += fmt::format("{:.1f},{:.{}f},{:.{}f},{:.{}f},{:.{}f},0.05,2,0.03\n", 0.1 * i, q.w(),
                          decimals, q.x(), decimals, q.y(), decimals, q.z(), decimals);
    }
    RowReader reader = reader_of(text);
    rows_of(reader);
    return reader.rate_resolution().at(2);
  };
  EXPECT_LT(digit_of({0.05, 2, 0.03}, 8), 1e-15);
  EXPECT_EQ(digit_of({0.051, 2, 0.03}, 8), 1);
  EXPECT_EQ(digit_of({0.05, 2, 0.03}, 3), 1);  // 0.051 would fit as well
}

TEST(RowReader, RefusesTimesAndRatesBeyondTheLimits) {
  EXPECT_THAT(
      refusal("t,wx,wy,wz\n0,1,2,3\n1,1,2e40,3\n"),
      AllOf(
          StartsWith("run.csv:3: the column 'wy': 2e+40 rad/s is beyond the limit of 1e+12 rad/s"),
          HasSubstr("correct or remove")));
  EXPECT_THAT(
      refusal("t,wx,wy,wz\n-1e100,1,2,3\n1,1,2,3\n"),
      AllOf(StartsWith("run.csv:2: the column 't': -1e+100 s is beyond the limit of 1e+20 s"),
            HasSubstr("unit of the times")));
  EXPECT_THAT(
      refusal("t,wx,wy,wz\n0,1,2,3\n1e16,1,2,3\n"),
      StartsWith(
          "run.csv:3: the column 't': 1e+16 s after the first row is beyond the limit of 1e+15 s"));
  EXPECT_THAT(refusal("t,wx,wy,wz\n0,1,2,3\n1e-16,1,2,3\n"),
              StartsWith("run.csv:3: the column 't': the time 1e-16 is only 1e-16 s after that"));
  EXPECT_THAT(refusal("t,wx,wy,wz\n0,1,2,3\n1,1e-200,0,0\n"),
              StartsWith("run.csv:3: the rates have the magnitude 1e-200 rad/s, but must be zero"));
  EXPECT_THAT(
      refusal("t,yaw,pitch,roll\n0,1,2,1e300\n", with_sequence("zyx")),
      StartsWith("run.csv:2: the column 'roll': 1e+300 rad is beyond the limit of 1e+12 rad"));
  EXPECT_EQ(refusal("t,wx,wy,wz\n0,1e12,-1e12,0\n1e15,0,1e-90,0\n"), "no error");
  EXPECT_EQ(refusal("time,wx,wy,wz\n1700000000000000000,1,2,3\n1700000000020000000,1,2,3\n"),
            "no error");
}

// Quantities that are rotated in a file are rotated back: rates, matrices, and rates in space axes.
TEST(RowReader, TakesTheFilesAxesToTheBodys) {
  const Eigen::Vector3d omega(1, 2, 3);
  const Eigen::Matrix3d X = rotation_by_euler_angles({2, 1, 0}, std::array{0.3, 0.5, -0.7});
  for (const BodyAxes& axes : all_body_axes()) {
    const Eigen::Matrix3d P = axes.matrix();
    const Eigen::Vector3d rates = P * omega;
    // If the file's body axes are left-handed, its space axes are, too.
    const Eigen::Matrix3d attitude = P.determinant() * X * P.transpose();
    for (const bool in_space : {false, true}) {
      const Eigen::Vector3d w = in_space ? Eigen::Vector3d(attitude * rates) : rates;
      std::string text = "t,wx,wy,wz,x11,x12,x13,x21,x22,x23,x31,x32,x33\n0";
      for (int i = 0; i < 3; ++i) text += fmt::format(",{:.17g}", w[i]);
      for (int i = 0; i < 9; ++i) text += fmt::format(",{:.17g}", attitude(i / 3, i % 3));
      Convention said;
      said.axes = axes;
      said.rates_in_space = in_space;
      const Row row = rows_of(text + "\n", said)[0];
      EXPECT_TRUE(row.omega.isApprox(omega, 1e-14)) << format_body_axes(axes) << in_space;
      EXPECT_TRUE(row.X.isApprox(X, 1e-14)) << format_body_axes(axes);
    }
  }
}

TEST(RowReader, TakesTheAttitudeOfAPartToThatOfTheBody) {
  Convention said;
  said.offset = Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()));
  const Eigen::Quaterniond body(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitY()));
  // Takes the part's axes to the body's, and these to those of space.
  const Eigen::Quaterniond part = body * *said.offset;
  const Row row = rows_of(fmt::format("t,qw,qx,qy,qz\n0,{:.17g},{:.17g},{:.17g},{:.17g}\n",
                                      part.w(), part.x(), part.y(), part.z()),
                          said)[0];
  EXPECT_TRUE(row.X.isApprox(body.toRotationMatrix(), 1e-14));
}

TEST(RowReader, ReadsMatrices) {
  const std::string text =
      "t,x11,x12,x13,x21,x22,x23,x31,x32,x33\n0,0,-1,0,1,0,0,0,0,1\n1,0,-1.001,0,1,0,0,0,0,1\n";
  const std::vector<Row> rows = rows_of(text);
  EXPECT_EQ(rows[0].X * Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  EXPECT_EQ(rows[0].orthogonality_error, 0);
  EXPECT_NEAR(rows[1].orthogonality_error, 1.001 * 1.001 - 1, 1e-15);
  Convention said;
  said.inverse = true;
  EXPECT_EQ(rows_of(text, said)[0].X, Eigen::Matrix3d(rows[0].X.transpose()));
}

// Values of SciPy 1.10: Rotation.from_quat([0.1, -0.2, 0.3, 0.9]).as_matrix()
TEST(RowReader, ReadsQuaternions) {
  const double length = std::sqrt(0.95);
  std::string text = "t,qx,qy,qz,qw\n0";
  for (const double part : {0.1, -0.2, 0.3, 0.9}) text += "," + std::to_string(part / length);
  Eigen::Matrix3d expected;
  expected << 0.7263157894736842, -0.6105263157894737, -0.31578947368421056, 0.5263157894736842,
      0.7894736842105263, -0.3157894736842105, 0.4421052631578947, 0.06315789473684214,
      0.8947368421052632;
  const Row row = rows_of(text + "\n")[0];
  EXPECT_TRUE(row.X.isApprox(expected, 1e-6)) << row.X;
  EXPECT_LT(row.orthogonality_error, 5e-6);  // what six decimals leave
  EXPECT_NEAR(rows_of("t,qw,qx,qy,qz\n0,1.05,0,0,0\n")[0].orthogonality_error, 0.1025, 1e-15);
}

// Values of SciPy 1.10: Rotation.from_euler(SEQUENCE, angles).as_matrix() with capital letters,
// which turn about the body's axes, for yaw 0.3, pitch -0.5, roll 1.1.
TEST(RowReader, ReadsEverySequenceOfEulerAngles) {
  const std::map<std::string, std::array<double, 9>> expected{
      {"zyx",
       {0.8383866435942031, -0.5422311184532652, 0.05561699401951625, 0.2593433800522307,
        0.3070707259497221, -0.9156683791022785, 0.4794255386042029, 0.78210803821827,
        0.3980680463041944}},
      {"zxy",
       {0.9646528437681837, -0.13404681954446868, -0.22688398176153382, -0.14884091885656586,
        0.43333692612370267, -0.8888562815953954, 0.21746556482323479, 0.8912073600614351,
        0.39806804630419435}},
      {"yxz",
       {0.7121204434202228, -0.6675276789610274, -0.2174655648232349, 0.13404681954446873,
        0.4333369261237031, -0.8912073600614352, 0.6891414399330501, 0.6054964131013194,
        0.39806804630419473}},
      {"yzx",
       {0.8383866435942033, -0.5449047199145748, 0.013663164262523259, 0.29552020666133955,
        0.43333692612370295, -0.8514029104439913, 0.4580127108472919, 0.7178425695599828,
        0.5243342464781752}},
      {"xyz",
       {0.8383866435942033, -0.2593433800522307, -0.47942553860420295, -0.274137479364328,
        0.5596031262976835, -0.7821080382182701, 0.47112257242740824, 0.787137441785704,
        0.39806804630419457}},
      {"xzy",
       {0.8383866435942033, -0.29552020666133955, -0.45801271084729195, -0.30963041729639224,
        0.43333692612370284, -0.8463735068765574, 0.4485942939089929, 0.8514029104439913,
        0.2718018461302139}},
      {"zxz",
       {0.2022081970379448, -0.9690400617530823, -0.1416799342470381, 0.8812231668928259,
        0.1169191465658761, 0.45801271084729184, -0.4272675686054834, -0.2174655648232348,
        0.8775825618903723}},
      {"zyz",
       {0.1169191465658761, -0.8812231668928259, -0.45801271084729184, 0.9690400617530823,
        0.2022081970379448, -0.1416799342470381, 0.2174655648232348, -0.4272675686054834,
        0.8775825618903723}},
      {"yxy",
       {0.2022081970379448, -0.1416799342470381, 0.9690400617530823, -0.4272675686054834,
        0.8775825618903723, 0.2174655648232348, -0.8812231668928259, -0.45801271084729184,
        0.1169191465658761}},
      {"yzy",
       {0.1169191465658761, 0.45801271084729184, 0.8812231668928259, -0.2174655648232348,
        0.8775825618903723, -0.4272675686054834, -0.9690400617530823, -0.1416799342470381,
        0.2022081970379448}},
      {"xyx",
       {0.8775825618903723, -0.4272675686054834, -0.2174655648232348, -0.1416799342470381,
        0.2022081970379448, -0.9690400617530823, 0.45801271084729184, 0.8812231668928259,
        0.1169191465658761}},
      {"xzx",
       {0.8775825618903723, 0.2174655648232348, -0.4272675686054834, -0.45801271084729184,
        0.1169191465658761, -0.8812231668928259, -0.1416799342470381, 0.9690400617530823,
        0.2022081970379448}}};
  for (const auto& [sequence, entries] : expected) {
    const Row row = rows_of("t,yaw,pitch,roll\n0,0.3,-0.5,1.1\n", with_sequence(sequence))[0];
    const Eigen::Matrix3d X =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(entries.data());
    EXPECT_TRUE(row.X.isApprox(X, 1e-14)) << sequence << "\n" << row.X;
  }
}

TEST(RowReader, TurnsRatesInSpaceIntoTheBodysAxes) {
  Convention said;
  said.rates_in_space = true;
  // A quarter of a turn about z: the body's x points along the space's y.
  const double half = std::sqrt(0.5);
  const std::string text = "t,qw,qx,qy,qz,wx,wy,wz\n0," + std::to_string(half) + ",0,0," +
                           std::to_string(half) + ",0,5,1\n";
  EXPECT_TRUE(rows_of(text, said)[0].omega.isApprox(Eigen::Vector3d(5, 0, 1), 1e-5));
  EXPECT_THROW(reader_of("t,wx,wy,wz\n0,1,2,3\n", said), InvalidArgument);
}

TEST(RowReader, RefusesTimesThatDoNotAscend) {
  EXPECT_THAT(refusal("t,p,q,r\n0,1,1,1\n1,1,1,1\n1,1,1,1\n"),
              AllOf(StartsWith("run.csv:4: the column 't': the time 1 is that of the row before"),
                    HasSubstr("remove doubled rows")));
  EXPECT_THAT(
      refusal("t,p,q,r\n0,1,1,1\n2,1,1,1\n1.5,1,1,1\n"),
      AllOf(
          HasSubstr("run.csv:4: the column 't': the time 1.5 is before that of the row before, 2"),
          HasSubstr("sort the rows")));
}

TEST(RowReader, RefusesWhatIsNotFinite) {
  EXPECT_THAT(refusal("t,p,q,r\n0,1,1,1\n1,1,nan,1\n"),
              StartsWith("run.csv:3: the column 'q': nan is not finite"));
  EXPECT_THAT(refusal("t,p,q,r\ninf,1,1,1\n"), HasSubstr("the column 't': inf is not"));
}

TEST(RowReader, RefusesWhatIsNoRotation) {
  const std::string matrix = "t,x11,x12,x13,x21,x22,x23,x31,x32,x33\n0,1,0,0,0,1,0,0,0,1\n";
  EXPECT_THAT(
      refusal(matrix + "1,1,0,0,0,1,0,0,0,-1\n"),
      AllOf(StartsWith(
                "run.csv:3: the matrix: it is a reflection, not a rotation: its determinant is -1"),
            HasSubstr("right-handed")));
  EXPECT_THAT(refusal(matrix + "1,1,0,0,1,0,0,0,0,1\n"), HasSubstr("the matrix: it is singular"));
  EXPECT_THAT(refusal(matrix + "1,0,0,0,0,0,0,0,0,0\n"),
              HasSubstr("the matrix: its rows have the lengths 0, 0 and 0 instead of 1"));
  EXPECT_THAT(refusal(matrix + "1,1e200,0,0,0,1e200,0,0,0,1e200\n"), HasSubstr("1e+200"));
  EXPECT_THAT(refusal(matrix + "1,1,0,0,0,1,0,0,0,1e4\n"),
              HasSubstr("its rows have the lengths 1, 1 and 1e+04 instead of 1"));
  EXPECT_THAT(refusal("t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,1,1,1\n"),
              StartsWith("run.csv:3: the quaternion: its length is 2 instead of 1"));
  EXPECT_THAT(refusal("t,qw,qx,qy,qz\n0,0,0,0,0\n"),
              HasSubstr("it is zero, which is not a valid attitude"));
  EXPECT_THAT(refusal("t,qw,qx,qy,qz\n0,1e200,1e200,0,0\n"),
              HasSubstr("its length is 1.41421e+200"));
}

TEST(RowReader, NeedsAWholeConvention) {
  Convention convention;
  convention.columns = {{"t", "t"}, {"wx", "p"}};
  EXPECT_THROW(RowReader(table::open_table("run.csv", "t,p\n0,1\n"), convention), ColumnError);
  convention.columns = {{"t", "t"}, {"yaw", "a"}, {"pitch", "b"}, {"roll", "c"}};
  EXPECT_THROW(RowReader(table::open_table("run.csv", "t,a,b,c\n0,1,2,3\n"), convention),
               InvalidArgument);
}

TEST(RowReader, TellsHowManyDigitsTheFileHas) {
  RowReader reader = reader_of(
      "t,p_deg_s,q_deg_s,r_deg_s\n0,1.2345,-0.1234,20.1234\n0.5,1.2345,-0.1234,20.1231\n1,0,0,0\n");
  rows_of(reader);
  EXPECT_DOUBLE_EQ(reader.rate_resolution().at(0.1), 1e-4 * degree);
  EXPECT_LT(reader.time_resolution().at(1), 1e-15);
}

/// Reads one of NASA's files (nasa/README.md) by the names of its columns.
RowReader nasa_reader(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(TWRENCH_TESTS_DIR) / "check/nasa" / name;
  auto table = table::open_table(file);
  const auto all = conventions(table->header(), with_sequence("zyx"));
  EXPECT_THAT(all, SizeIs(1));
  EXPECT_EQ(all.front().columns.at("wx"), "bodyAngularRateWrtEi_deg_s_Roll");
  return {std::move(table), all.front()};
}

TEST(RowReader, ReadsNasasFilesByTheirNames) {
  for (const char* name : {"tumbling_brick_sim_01.csv", "tumbling_brick_sim_05.csv"}) {
    RowReader reader = nasa_reader(name);
    EXPECT_EQ(reader.attitude(), AttitudeForm::euler);
    const std::vector<Row> rows = rows_of(reader);
    ASSERT_THAT(rows, SizeIs(301));
    EXPECT_TRUE(rows[0].omega.isApprox(degree * Eigen::Vector3d(10, 20, 30), 1e-11)) << name;
    EXPECT_TRUE(rows[0].X.isIdentity(1e-15));
  }
}

TEST(RowReader, NoticesWhichDigitsOfNasasFilesAreTrue) {
  RowReader reader = nasa_reader("tumbling_brick_sim_05.csv");
  rows_of(reader);
  EXPECT_DOUBLE_EQ(reader.time_resolution().at(0.2), std::ldexp(1.0, -26));
  EXPECT_LT(reader.rate_resolution().at(0.2), 1e-16);
  RowReader other = nasa_reader("tumbling_brick_sim_01.csv");
  rows_of(other);
  EXPECT_LT(other.time_resolution().at(0.2), 1e-16);
  // Written with 16 digits of deg/s, converted from 12 digits of rad/s.
  EXPECT_NEAR(other.rate_resolution().at(0.2), 1e-12, 1e-20);
}

}  // namespace
}  // namespace twrench::recording
