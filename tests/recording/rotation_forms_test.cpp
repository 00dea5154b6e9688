#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/columns/open_conventions.h"
#include "recording/columns/unread_columns.h"
#include "recording/conventions/attitude.h"
#include "recording/row_reader.h"
#include "table/error.h"

namespace twrench::recording {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double one_degree = std::numbers::pi / 180;

/// The columns of each reading, as the user would give them.
std::vector<std::string> columns_by_name(std::vector<std::string> names) {
  std::vector<std::string> all;
  for (const Convention& convention : conventions({"run.csv", std::move(names), {}}, {})) {
    all.push_back(format_columns(convention.columns));
  }
  return all;
}

/// The attitude in the first row.
Matrix3d attitude_in(const std::string& text) {
  auto table = table::open_table("run.csv", std::string_view(text));
  const auto all = conventions(table->header(), {});
  EXPECT_THAT(all, SizeIs(1));
  RowReader reader(std::move(table), all.front());
  Row row;
  EXPECT_TRUE(reader.next(row));
  return row.X;
}

std::string rotation_refusal(const std::string& text) {
  try {
    attitude_in(text);
  } catch (const table::BadTable& error) {
    return error.what();
  }
  return "no error";
}

/// Any rotation.
const double angle = 1.3;
const Vector3d axis = Vector3d(1, -2, 3).normalized();
const Matrix3d turn = AngleAxisd(angle, axis).toRotationMatrix();

std::string row_of(const char* names, const Vector3d& v) {
  return fmt::format("t,{}\n0,{:.17g},{:.17g},{:.17g}\n", names, v[0], v[1], v[2]);
}

TEST(RotationForms, AreFoundByTheirNames) {
  for (const char* stem : {"rotvec_", "rv_", "rotation_vector.", "axisangle_", "prv_"}) {
    const std::string s(stem);
    EXPECT_THAT(columns_by_name({"t", s + "x", s + "y", s + "z"}),
                ElementsAre(fmt::format("t=t,rvx={0}x,rvy={0}y,rvz={0}z", s)))
        << stem;
  }
  EXPECT_THAT(columns_by_name({"t", "rx", "ry", "rz"}),
              AllOf(SizeIs(7), testing::Contains("t=t,rvx=rx,rvy=ry,rvz=rz"),
                    testing::Contains("t=t,yaw=rz,pitch=ry,roll=rx")));
  EXPECT_THAT(columns_by_name({"t", "rotvec[0]", "rotvec[1]", "rotvec[2]"}),
              ElementsAre("t=t,rvx=rotvec[0],rvy=rotvec[1],rvz=rotvec[2]"));
  EXPECT_THAT(columns_by_name({"t", "ax", "ay", "az", "angle"}),
              ElementsAre("t=t,axisx=ax,axisy=ay,axisz=az,angle=angle"));
  for (const char* stem : {"sigma_BN_", "sigma_", "mrp_", "MRP", "modified_rodrigues_"}) {
    const std::string s(stem);
    EXPECT_THAT(columns_by_name({"t", s + "1", s + "2", s + "3"}),
                ElementsAre(fmt::format("t=t,mrpx={0}1,mrpy={0}2,mrpz={0}3", s)))
        << stem;
  }
  for (const char* stem : {"rodrigues_", "gibbs_", "crp"}) {
    const std::string s(stem);
    EXPECT_THAT(columns_by_name({"t", s + "1", s + "2", s + "3"}),
                ElementsAre(fmt::format("t=t,gibbsx={0}1,gibbsy={0}2,gibbsz={0}3", s)))
        << stem;
  }
}

TEST(RotationForms, StandBesideRatesInFramesOfBasilisk) {
  EXPECT_THAT(columns_by_name({"time_ns", "sigma_BN_1", "sigma_BN_2", "sigma_BN_3", "omega_BN_B_1",
                               "omega_BN_B_2", "omega_BN_B_3"}),
              ElementsAre("t=time_ns,wx=omega_BN_B_1,wy=omega_BN_B_2,wz=omega_BN_B_3,"
                          "mrpx=sigma_BN_1,mrpy=sigma_BN_2,mrpz=sigma_BN_3"));
}

TEST(RotationForms, StandBesideRatesInAxesOfSpace) {
  const table::Header header{"run.csv",
                             {"t", "sigma_BN_1", "sigma_BN_2", "sigma_BN_3", "omega_BN_N_1",
                              "omega_BN_N_2", "omega_BN_N_3"},
                             {}};
  const auto all = conventions(header, {});
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all.front().columns.at("wx"), "omega_BN_N_1");
  EXPECT_TRUE(all.front().rates_in_space);
}

// r may be a position, a an acceleration, and sigma a stress.
TEST(RotationForms, NamesWithOtherMeaningsGiveWayToAnAttitude) {
  const char* const quaternion = "t=t,qw=qw,qx=qx,qy=qy,qz=qz";
  EXPECT_THAT(columns_by_name({"t", "qw", "qx", "qy", "qz", "rx", "ry", "rz"}),
              ElementsAre(quaternion));
  EXPECT_THAT(columns_by_name({"t", "qw", "qx", "qy", "qz", "ax", "ay", "az", "angle"}),
              ElementsAre(quaternion));
  EXPECT_THAT(columns_by_name({"t", "qw", "qx", "qy", "qz", "sigma_1", "sigma_2", "sigma_3"}),
              ElementsAre(quaternion));
  EXPECT_THAT(columns_by_name({"t", "qw", "qx", "qy", "qz", "mrp_1", "mrp_2", "mrp_3"}), SizeIs(2));
}

// These are rather standard deviations.
TEST(RotationForms, DoNotTakeSigmaWithLettersForParameters) {
  EXPECT_THAT(columns_by_name({"t", "wx", "wy", "wz", "sigma_x", "sigma_y", "sigma_z"}),
              ElementsAre("t=t,wx=wx,wy=wy,wz=wz"));
}

TEST(RotationForms, AreDecoded) {
  constexpr double rounding = 1e-14;
  EXPECT_TRUE(attitude_in(row_of("rvx,rvy,rvz", angle * axis)).isApprox(turn, rounding));
  EXPECT_TRUE(attitude_in(row_of("rv_x_deg,rv_y_deg,rv_z_deg", angle / one_degree * axis))
                  .isApprox(turn, rounding));
  const Vector3d mrp = std::tan(angle / 4) * axis;
  EXPECT_TRUE(attitude_in(row_of("mrp_x,mrp_y,mrp_z", mrp)).isApprox(turn, rounding));
  const Vector3d shadow = -mrp / mrp.squaredNorm();
  EXPECT_TRUE(attitude_in(row_of("mrp_x,mrp_y,mrp_z", shadow)).isApprox(turn, rounding));
  const Vector3d gibbs = std::tan(angle / 2) * axis;
  EXPECT_TRUE(attitude_in(row_of("gibbs_x,gibbs_y,gibbs_z", gibbs)).isApprox(turn, rounding));
}

TEST(RotationForms, AxisAndAngleAreDecoded) {
  const auto row = [](const char* names, const Vector3d& along, double about) {
    return fmt::format("t,{}\n0,{:.17g},{:.17g},{:.17g},{:.17g}\n", names, along[0], along[1],
                       along[2], about);
  };
  const char* const names = "axis_x,axis_y,axis_z,angle_deg";
  EXPECT_TRUE(attitude_in(row(names, axis, angle / one_degree)).isApprox(turn, 1e-14));
  EXPECT_TRUE(attitude_in(row(names, Vector3d::Zero(), 0)).isIdentity(0));
  EXPECT_THAT(rotation_refusal(row(names, 2 * axis, 30)), HasSubstr("length of its axis is 2"));
}

// Numbers from SciPy 1.10: Rotation.from_euler("ZYX", [0.3, -1.1, 2.2]).as_rotvec() and as_mrp().
TEST(RotationForms, AgreeWithScipy) {
  const Matrix3d X = rotation_by_euler_angles(axes_of("zyx"), std::array{0.3, -1.1, 2.2});
  EXPECT_TRUE(
      rotation_by_vector(Vector3d(2.0750455548735558, -0.31886910393641982, 1.3673530273669008))
          .isApprox(X, 1e-14));
  EXPECT_TRUE(
      rotation_by_mrp(Vector3d(0.59925807995913305, -0.092087080466468144, 0.3948816197705729))
          .isApprox(X, 1e-14));
}

TEST(RotationForms, NumbersOfAnySizeAreRotations) {
  for (const double size : {0.0, 1e-300, 1e-8, 1.0, 1e8, 1e300}) {
    for (const auto& rotation : {rotation_by_mrp, rotation_by_rodrigues}) {
      EXPECT_TRUE(rotation(size * axis).isUnitary(1e-12)) << size;
    }
  }
  EXPECT_TRUE(rotation_by_vector({1e-300, 0, 0}).isIdentity(1e-15));
}

TEST(RotationForms, OfQuaternionsMayStateTheirOrder) {
  EXPECT_THAT(columns_by_name({"t", "quaternion_wxyz[0]", "quaternion_wxyz[1]",
                               "quaternion_wxyz[2]", "quaternion_wxyz[3]"}),
              ElementsAre("t=t,qw=quaternion_wxyz[0],qx=quaternion_wxyz[1],"
                          "qy=quaternion_wxyz[2],qz=quaternion_wxyz[3]"));
  EXPECT_THAT(columns_by_name({"t", "q_xyzw_1", "q_xyzw_2", "q_xyzw_3", "q_xyzw_4"}),
              ElementsAre("t=t,qw=q_xyzw_4,qx=q_xyzw_1,qy=q_xyzw_2,qz=q_xyzw_3"));
}

TEST(RotationForms, AreNamedIfTheyAreNotRead) {
  const auto unread = [](std::vector<std::string> names) {
    const table::Header header{"run.csv", std::move(names), {}};
    return unread_columns(header, conventions(header, {}).front());
  };
  EXPECT_THAT(unread({"t", "wx", "wy", "wz", "sigma_x", "sigma_y", "sigma_z"}),
              ElementsAre("sigma_x", "sigma_y", "sigma_z"));
  EXPECT_THAT(unread({"t", "wx", "wy", "wz", "s0", "s1", "s2", "s3", "temperature"}),
              ElementsAre("s0", "s1", "s2", "s3"));
  EXPECT_THAT(unread({"t", "wx", "wy", "wz", "ax", "ay", "az", "mag_x", "mag_y", "mag_z", "x"}),
              IsEmpty());
  EXPECT_THAT(unread({"t", "wx", "wy", "wz", "qw", "qx", "qy", "qz", "s1", "s2", "s3"}), IsEmpty());
  EXPECT_THAT(unread({"t", "wx", "wy", "wz", "-", "(%)"}), IsEmpty());  // no word at all
}

TEST(Rates, AreNamedIfTheyAreNotRead) {
  const auto unread = [](std::vector<std::string> names) {
    names.insert(names.begin(), {"t", "qw", "qx", "qy", "qz"});
    const table::Header header{"run.csv", std::move(names), {}};
    return unread_columns(header, conventions(header, {}).front());
  };
  EXPECT_THAT(unread({"turn_x", "turn_y", "turn_z"}), ElementsAre("turn_x", "turn_y", "turn_z"));
  EXPECT_THAT(unread({"omega_inertial_x", "omega_inertial_y", "omega_inertial_z"}), SizeIs(3));
  EXPECT_THAT(unread({"bias_gyro_x", "bias_gyro_y", "bias_gyro_z", "pos_x", "pos_y", "pos_z", "vx",
                      "vy", "vz", "vel_x", "vel_y", "vel_z", "euler_1", "euler_2", "euler_3"}),
              IsEmpty());
}

TEST(EulerAngles, AreFoundByAxesAndWithUnits) {
  const auto columns = [](std::vector<std::string> names) {
    Convention said;
    said.sequence = "zyx";
    std::vector<std::string> all;
    for (const Convention& one : conventions({"run.csv", std::move(names), {}}, said)) {
      all.push_back(format_columns(one.columns));
      EXPECT_EQ(one.angle_unit, Angle::degrees);
    }
    return all;
  };
  EXPECT_THAT(columns({"t", "Roll (\u00b0)", "Pitch (\u00b0)", "Yaw (\u00b0)"}), SizeIs(1));
  EXPECT_THAT(columns({"t", "euler_x_deg", "euler_y_deg", "euler_z_deg"}),
              ElementsAre("t=t,yaw=euler_z_deg,pitch=euler_y_deg,roll=euler_x_deg"));
  EXPECT_THAT(columns({"t", "heading [deg]", "pitch [deg]", "roll [deg]"}),
              ElementsAre("t=t,yaw=heading [deg],pitch=pitch [deg],roll=roll [deg]"));
  EXPECT_THAT(columns({"t", "euler[0] deg", "euler[1] deg", "euler[2] deg"}), SizeIs(2));
  EXPECT_THAT(columns({"t", "yaw_deg", "pitch_deg", "roll_deg", "heading_deg"}), SizeIs(1));
}

/// Rows of quaternions with this length, rounded to whole numbers.
std::string integers_of(double length) {
  std::string text = "t,qw,qx,qy,qz\n";
  for (int i = 0; i < 40; ++i) {
    const Eigen::Quaterniond q(AngleAxisd(0.1 * i, axis));
    text += fmt::format("{},{:.0f},{:.0f},{:.0f},{:.0f}\n", i, length * q.w(), length * q.x(),
                        length * q.y(), length * q.z());
  }
  return text;
}

TEST(ScaledQuaternions, AreReadInIntegersOfAnyLength) {
  for (const double length : {127.0, 32767.0, 1073741824.0}) {
    const std::string text = integers_of(length);
    auto table = table::open_table("run.csv", std::string_view(text));
    const Convention convention = conventions(table->header(), {}).front();
    RowReader reader(std::move(table), convention);
    int i = 0;
    for (Row row; reader.next(row); ++i) {
      const Matrix3d X = AngleAxisd(0.1 * i, axis).toRotationMatrix();
      EXPECT_LT((row.X - X).norm(), 4 / length) << length;
    }
    EXPECT_EQ(i, 40);
    EXPECT_NEAR(reader.quaternion_length(), length, 1);
    const Resolution resolution = reader.attitude_resolution();
    EXPECT_EQ(resolution.written, NumberFormat::decimals);
    EXPECT_NEAR(resolution.at(1), 1 / length, 1e-2 / length);
  }
}

TEST(ScaledQuaternions, MustAllHaveTheSameLength) {
  const std::string first = "t,qw,qx,qy,qz\n0,32767,0,0,0\n";
  EXPECT_EQ(rotation_refusal(first), "no error");
  const auto refusal_of_second = [&](const char* row) {
    const std::string text = first + row;
    auto table = table::open_table("run.csv", std::string_view(text));
    const Convention convention = conventions(table->header(), {}).front();
    RowReader reader(std::move(table), convention);
    Row read;
    try {
      while (reader.next(read)) continue;
    } catch (const table::BadTable& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(refusal_of_second("1,0,32766,0,0\n"), "no error");
  EXPECT_THAT(refusal_of_second("1,0,32000,0,0\n"),
              HasSubstr("run.csv:3: the quaternion: its length is 32000 instead of 32767 as in"));
  EXPECT_THAT(refusal_of_second("1,0,0,0,0\n"), HasSubstr("it is zero"));
  EXPECT_THAT(refusal_of_second("1,1,0,0,0\n"), HasSubstr("its length is 1 instead of 32767"));
}

}  // namespace
}  // namespace twrench::recording
