#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/columns/open_conventions.h"
#include "recording/row_reader.h"
#include "table/error.h"

namespace twrench::recording {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<Convention> of_momentum(std::vector<std::string> names) {
  return conventions({"run.csv", std::move(names), {}}, {});
}

RowReader momentum_reader(std::string_view text, const Matrix3d& body,
                          const BodyAxes& axes = BodyAxes()) {
  auto table = table::open_table("run.csv", text);
  Convention convention = conventions(table->header(), {}).front();
  convention.inertia = body;
  convention.axes = axes;
  return {std::move(table), convention};
}

const Matrix3d full_inertia{{2, 0.1, 0.2}, {0.1, 3, -0.3}, {0.2, -0.3, 4}};

TEST(Momentum, IsFoundByItsNames) {
  const std::vector<std::vector<std::string>> triples{
      {"Lx", "Ly", "Lz"},
      {"H_x", "H_y", "H_z"},
      {"L[0]", "L[1]", "L[2]"},
      {"h1", "h2", "h3"},
      {"angular_momentum_x", "angular_momentum_y", "angular_momentum_z"},
      {"L_body_x", "L_body_y", "L_body_z"},
      {"Lx [kg m^2/s]", "Ly [kg m^2/s]", "Lz [kg m^2/s]"},
      {"L_1 (N m s)", "L_2 (N m s)", "L_3 (N m s)"}};
  for (const auto& names : triples) {
    const auto all = of_momentum({"t", names[0], names[1], names[2]});
    ASSERT_THAT(all, SizeIs(1));
    EXPECT_EQ(format_columns(all.front().columns),
              fmt::format("t=t,lx={},ly={},lz={}", names[0], names[1], names[2]));
    EXPECT_FALSE(all.front().rates_in_space);
    EXPECT_FALSE(all.front().time_unit);
  }
  EXPECT_TRUE(of_momentum({"t", "L_space_x", "L_space_y", "L_space_z"}).front().rates_in_space);
}

TEST(Momentum, IsNotReadBesideRates) {
  const auto all = of_momentum({"t", "wx", "wy", "wz", "Lx", "Ly", "Lz"});
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(format_columns(all.front().columns), "t=t,wx=wx,wy=wy,wz=wz");
}

TEST(Momentum, IsDividedByTheInertia) {
  RowReader reader = momentum_reader("t,Lx,Ly,Lz\n0,1,-2,3\n", full_inertia);
  Row row;
  ASSERT_TRUE(reader.next(row));
  EXPECT_TRUE((full_inertia * row.omega).isApprox(Vector3d(1, -2, 3), 1e-14));
}

TEST(Momentum, InOtherAxesIsTurnedBeforehand) {
  RowReader reader =
      momentum_reader("t,Lx,Ly,Lz\n0,1,-2,3\n", full_inertia, parse_body_axes("x,-z,y", "axes"));
  Row row;
  ASSERT_TRUE(reader.next(row));
  EXPECT_TRUE((full_inertia * row.omega).isApprox(Vector3d(1, 3, 2), 1e-14));
  const std::string_view in_space =
      "t,L_space_x,L_space_y,L_space_z,x11,x12,x13,x21,x22,x23,x31,x32,x33\n"
      "0,1,-2,3,0,1,0,0,0,1,1,0,0\n";
  RowReader turned = momentum_reader(in_space, full_inertia);
  ASSERT_TRUE(turned.next(row));
  EXPECT_TRUE((full_inertia * row.omega).isApprox(Vector3d(3, 1, -2), 1e-14));
}

// Those of the largest component bound the error of every rate.
TEST(Momentum, HasDigitsInUnitsOfTheRates) {
  const Matrix3d moments = Vector3d(2, 3, 4).asDiagonal();
  RowReader reader =
      momentum_reader("t,Lx,Ly,Lz\n0,0.1234,-2.345,31.71\n1,3.111,4.17,20.12\n", moments);
  for (Row row; reader.next(row);) continue;
  EXPECT_EQ(reader.rate_resolution().count, 4);
  EXPECT_DOUBLE_EQ(reader.rate_resolution().at(0.5), 0.01 / 2);
}

TEST(Momentum, MayHaveAnySizeIfTheMomentsHave) {
  Row row;
  RowReader reader = momentum_reader("t,Lx,Ly,Lz\n0,1e22,2e22,3e22\n", 1e26 * full_inertia);
  ASSERT_TRUE(reader.next(row));
  EXPECT_LT(row.omega.norm(), 1e-3);
  RowReader too_fast = momentum_reader("t,Lx,Ly,Lz\n0,1e22,2e22,3e22\n", full_inertia);
  try {
    too_fast.next(row);
    FAIL();
  } catch (const table::BadTable& error) {
    EXPECT_THAT(error.what(), HasSubstr("run.csv:2: the rates have the magnitude"));
  }
}

TEST(Momentum, AndRatesCannotBothBeGiven) {
  Convention said;
  said.columns = parse_columns("lx=a,ly=b,lz=c,wx=d,wy=e,wz=f", "columns");
  EXPECT_THROW(conventions({"run.csv", {"t", "a", "b", "c", "d", "e", "f"}, {}}, said),
               table::BadTable);
}

}  // namespace
}  // namespace twrench::recording
