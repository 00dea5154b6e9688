// The names by which columns are recognised.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recording/columns/unread_columns.h"
#include "recording/readings_by_name.h"

namespace twrench::recording {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

TEST(Conventions, FindTheUsualNamesOfRates) {
  const std::vector<Names> triples{
      {"p", "q", "r"},
      {"omega_x", "omega_y", "omega_z"},
      {"omegaX", "omegaY", "omegaZ"},
      {"w_x", "w_y", "w_z"},
      {"w1", "w2", "w3"},
      {"w0", "w1", "w2"},
      {"gyro.x", "gyro.y", "gyro.z"},
      {"gyroX", "gyroY", "gyroZ"},
      {"angular_velocity.x", "angular_velocity.y", "angular_velocity.z"},
      {"AngVelX", "AngVelY", "AngVelZ"},
      {"roll rate", "pitch rate", "yaw rate"},
      {"\u03c9x", "\u03c9y", "\u03c9z"},
      {"body_rate_x", "body_rate_y", "body_rate_z"},
      {"rateRoll", "ratePitch", "rateYaw"},
      {"p_body", "q_body", "r_body"},
      {"rates[0]", "rates[1]", "rates[2]"},
      {"trueAngularRate_X_rad_s", "trueAngularRate_Y_rad_s", "trueAngularRate_Z_rad_s"},
      {"bodyAngularRateWrtEi_deg_s_Roll", "bodyAngularRateWrtEi_deg_s_Pitch",
       "bodyAngularRateWrtEi_deg_s_Yaw"}};
  for (const Names& n : triples) {
    EXPECT_THAT(readings_of({"time", n[2], n[0], n[1], "velocity_x", "velocity_y", "velocity_z"}),
                ElementsAre("t=time,wx=" + n[0] + ",wy=" + n[1] + ",wz=" + n[2]));
  }
}

TEST(Conventions, FindTheUsualNamesOfAttitudes) {
  const std::vector<Names> quaternions{
      {"quat_w", "quat_x", "quat_y", "quat_z"},
      {"q.w", "q.x", "q.y", "q.z"},
      {"qW", "qX", "qY", "qZ"},
      {"q_s", "q_x", "q_y", "q_z"},
      {"orientation.w", "orientation.x", "orientation.y", "orientation.z"},
      {"attitude_scalar", "attitude_i", "attitude_j", "attitude_k"}};
  for (const Names& n : quaternions) {
    EXPECT_THAT(readings_of({"t", n[1], n[2], n[3], n[0]}),
                ElementsAre("t=t,qw=" + n[0] + ",qx=" + n[1] + ",qy=" + n[2] + ",qz=" + n[3]));
  }
  for (const std::string stem : {"R", "r_", "dcm", "DCM_", "C"}) {
    Names names{"t"};
    for (int i = 1; i <= 3; ++i) {
      for (int j = 1; j <= 3; ++j) names.push_back(stem + std::to_string(10 * i + j));
    }
    EXPECT_THAT(readings_of(names), ElementsAre(AllOf(HasSubstr("x12=" + stem + "12"),
                                                      HasSubstr("x31=" + stem + "31"))));
  }
  EXPECT_THAT(readings_of({"t", "R[0][0]", "R[0][1]", "R[0][2]", "R[1][0]", "R[1][1]", "R[1][2]",
                           "R[2][0]", "R[2][1]", "R[2][2]"}),
              ElementsAre(AllOf(HasSubstr("x12=R[0][1]"), HasSubstr("x31=R[2][0]"))));
}

TEST(Conventions, FindTheUsualNamesOfTimes) {
  for (const char* name : {"t",
                           "T",
                           "time",
                           "Time (s)",
                           "t_s",
                           "time_ms",
                           "sim_time",
                           "timestamp_ns",
                           "seconds",
                           "elapsed [s]",
                           "timestamp",
                           "stamp",
                           "epoch",
                           "unix time",
                           "time_usec",
                           "TimeUS",
                           "t_ns",
                           "header.stamp",
                           "utc",
                           "SampleTimeFine",
                           "seconds_elapsed",
                           "epoc (ms)",
                           "timestamp [ns]"}) {
    EXPECT_THAT(readings_of({name, "p", "q", "r"}),
                ElementsAre(StartsWith(std::string("t=") + name)));
  }
  for (const char* name : {"time (deg)", "time_offset", "dt", "rate"}) {
    EXPECT_THAT(refusal({name, "wx", "wy", "wz"}), HasSubstr("no column is recognised as the time"))
        << name;
  }
}

TEST(Conventions, FindRatesAsLoggersNameThem) {
  const std::vector<Names> loggers{
      {"gyro_x", "gyro_y", "gyro_z"},
      {"GyroX", "GyroY", "GyroZ"},
      {"gyroscope_x", "gyroscope_y", "gyroscope_z"},
      {"ang_vel_x", "ang_vel_y", "ang_vel_z"},
      {"rotation_rate_x", "rotation_rate_y", "rotation_rate_z"},
      {"field.angular_velocity.x", "field.angular_velocity.y", "field.angular_velocity.z"},
      {"twist.angular.x", "twist.angular.y", "twist.angular.z"},
      {"motionRotationRateX(rad/s)", "motionRotationRateY(rad/s)", "motionRotationRateZ(rad/s)"},
      {"Gyr_X", "Gyr_Y", "Gyr_Z"},
      {"w_RS_S_x [rad s^-1]", "w_RS_S_y [rad s^-1]", "w_RS_S_z [rad s^-1]"},
      {"omega_BN_B_1", "omega_BN_B_2", "omega_BN_B_3"},
      {"AsX(\u00b0/s)", "AsY(\u00b0/s)", "AsZ(\u00b0/s)"},
      {"x-axis (deg/s)", "y-axis (deg/s)", "z-axis (deg/s)"},
      {"roll (deg/s)", "pitch (deg/s)", "yaw (deg/s)"}};
  for (const Names& names : loggers) {
    EXPECT_THAT(readings_of({"t", names[0], names[1], names[2]}),
                ElementsAre("t=t,wx=" + names[0] + ",wy=" + names[1] + ",wz=" + names[2]));
  }
  EXPECT_TRUE(conventions(header_of({"t", "qw", "qx", "qy", "qz", "omega_BN_N_1", "omega_BN_N_2",
                                     "omega_BN_N_3"}),
                          {})
                  .front()
                  .rates_in_space);
}

// Names that say nothing are rates only if the file's own name says so.
TEST(Conventions, TakeBareNamesForRatesInAFileOfAGyroscope) {
  for (const Names& names :
       {Names{"x", "y", "z"}, Names{"xyz[0]", "xyz[1]", "xyz[2]"}, Names{"gx", "gy", "gz"}}) {
    const std::string columns = "wx=" + names[0] + ",wy=" + names[1] + ",wz=" + names[2];
    table::Header header = header_of({"t", names[2], names[1], names[0]});
    EXPECT_THAT(refusal(header, {}), AllOf(HasSubstr("'" + names[0] + "'"), HasSubstr(columns)));
    header.file = "folder/vehicle_angular_velocity_0.csv";
    ASSERT_EQ(refusal(header, {}), "no error");
    EXPECT_EQ(format_columns(conventions(header, {}).front().columns), "t=t," + columns);
  }
}

TEST(Conventions, TakeNothingElseForRates) {
  const std::vector<Names> others{
      {"gyro_bias_x", "gyro_bias_y", "gyro_bias_z"},
      {"b_w_RS_S_x [rad s^-1]", "b_w_RS_S_y [rad s^-1]", "b_w_RS_S_z [rad s^-1]"},
      {"xyz_derivative[0]", "xyz_derivative[1]", "xyz_derivative[2]"},
      {"x (m/s^2)", "y (m/s^2)", "z (m/s^2)"},
      {"rate_setpoint_x", "rate_setpoint_y", "rate_setpoint_z"},
      {"acc_x (rad/s)", "acc_y (rad/s)", "acc_z (rad/s)"},
      {"gyro_x (m/s^2)", "gyro_y (m/s^2)", "gyro_z (m/s^2)"}};
  for (const Names& names : others) {
    EXPECT_THAT(refusal({"t", names[0], names[1], names[2]}),
                HasSubstr("no columns have names of rates or of an attitude"))
        << names[0];
  }
  // x, y, z beside an attitude are a position.
  EXPECT_THAT(readings_of({"t", "x", "y", "z", "qx", "qy", "qz", "qw"}),
              ElementsAre("t=t,qw=qw,qx=qx,qy=qy,qz=qz"));
}

// EuRoC's ground truth: the rates in it are biases.
TEST(Conventions, FindAttitudesAsDatasetsNameThem) {
  EXPECT_THAT(readings_of({"timestamp", "p_RS_R_x [m]", "p_RS_R_y [m]", "p_RS_R_z [m]", "q_RS_w []",
                           "q_RS_x []", "q_RS_y []", "q_RS_z []", "b_w_RS_S_x [rad s^-1]",
                           "b_w_RS_S_y [rad s^-1]", "b_w_RS_S_z [rad s^-1]"}),
              ElementsAre("t=timestamp,qw=q_RS_w [],qx=q_RS_x [],qy=q_RS_y [],qz=q_RS_z []"));
  EXPECT_THAT(readings_of({"timestamp", "q[0]", "q[1]", "q[2]", "q[3]", "delta_q_reset[0]",
                           "quat_reset_counter"}),
              SizeIs(2));
  EXPECT_THAT(
      readings_of({"time", "field.orientation.x", "field.orientation.y", "field.orientation.z",
                   "field.orientation.w", "field.orientation_covariance0"}),
      SizeIs(1));
}

// Basilisk's Euler parameters, PyBullet's orientation, and the floating base of Drake.
TEST(Conventions, FindQuaternionsAsEnginesNameThem) {
  EXPECT_THAT(readings_of({"t", "beta_BN_0", "beta_BN_1", "beta_BN_2", "beta_BN_3"}),
              testing::Contains("t=t,qw=beta_BN_0,qx=beta_BN_1,qy=beta_BN_2,qz=beta_BN_3"));
  EXPECT_THAT(readings_of({"t", "orn_x", "orn_y", "orn_z", "orn_w"}),
              ElementsAre("t=t,qw=orn_w,qx=orn_x,qy=orn_y,qz=orn_z"));
  EXPECT_THAT(readings_of({"t", "$world_body_qw", "$world_body_qx", "$world_body_qy",
                           "$world_body_qz", "$world_body_x"}),
              ElementsAre("t=t,qw=$world_body_qw,qx=$world_body_qx,qy=$world_body_qy,"
                          "qz=$world_body_qz"));
}

TEST(Conventions, FindTheStatesOfSimulators) {
  const auto numbered = [](const std::string& before, int count, const std::string& after = "") {
    Names names;
    for (int i = 0; i < count; ++i) names.push_back(fmt::format("{}{}{}", before, i, after));
    return names;
  };
  const auto joined = [](Names names, const Names& more) {
    names.insert(names.end(), more.begin(), more.end());
    return names;
  };
  EXPECT_THAT(
      readings_of(joined(joined({"time"}, numbered("qpos[", 7, "]")), numbered("qvel[", 6, "]"))),
      ElementsAre("t=time,wx=qvel[3],wy=qvel[4],wz=qvel[5],qw=qpos[3],qx=qpos[4],"
                  "qy=qpos[5],qz=qpos[6]"));
  EXPECT_THAT(readings_of(joined(joined({"time"}, numbered("qpos_", 4)), numbered("qvel_", 3))),
              ElementsAre("t=time,wx=qvel_0,wy=qvel_1,wz=qvel_2,qw=qpos_0,qx=qpos_1,qy=qpos_2,"
                          "qz=qpos_3"));
  EXPECT_THAT(refusal(joined({"time"}, numbered("qpos_", 14))), HasSubstr("no columns have names"));
  EXPECT_THAT(readings_of(joined({"time"}, numbered("root_state_", 13))), SizeIs(2));
  EXPECT_THAT(readings_of({"t", "rot_e0", "rot_e1", "rot_e2", "rot_e3", "wvel_loc_x", "wvel_loc_y",
                           "wvel_loc_z"}),
              ElementsAre("t=t,wx=wvel_loc_x,wy=wvel_loc_y,wz=wvel_loc_z,qw=rot_e0,qx=rot_e1,"
                          "qy=rot_e2,qz=rot_e3"));
  const auto isaac = conventions(
      header_of({"t", "root_quat_w_w", "root_quat_w_x", "root_quat_w_y", "root_quat_w_z",
                 "root_ang_vel_w_x", "root_ang_vel_w_y", "root_ang_vel_w_z"}),
      {});
  ASSERT_THAT(isaac, SizeIs(1));
  EXPECT_TRUE(isaac.front().rates_in_space);
  EXPECT_EQ(isaac.front().columns.at("qw"), "root_quat_w_w");
}

TEST(Conventions, FindQuaternionsAsViconNamesThem) {
  EXPECT_THAT(readings_of({"t", "RX", "RY", "RZ", "RW", "TX", "TY", "TZ"}),
              ElementsAre("t=t,qw=RW,qx=RX,qy=RY,qz=RZ"));
}

TEST(Conventions, ReadRatesBesideAnIncompleteAttitude) {
  const Names names{"t", "wx (rad/s)", "wy (rad/s)", "wz (rad/s)", "Pitch", "Roll"};
  const auto found = conventions(header_of(names), {});
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(unread_columns(header_of(names), found.front()), ElementsAre("Pitch", "Roll"));
}

// As OpenSim writes it.
TEST(Owners, MayPrecedeTheNames) {
  EXPECT_THAT(readings_of({"Sat.ElapsedSecs", "Sat.AngularVelocityX", "Sat.AngularVelocityY",
                           "Sat.AngularVelocityZ"}),
              ElementsAre("t=Sat.ElapsedSecs,wx=Sat.AngularVelocityX,wy=Sat.AngularVelocityY,"
                          "wz=Sat.AngularVelocityZ"));
  EXPECT_THAT(readings_of({"Clock:offsetTime", "IMU_ATTI(0):gyroX", "IMU_ATTI(0):gyroY",
                           "IMU_ATTI(0):gyroZ", "IMU_ATTI(0):quatW", "IMU_ATTI(0):quatX",
                           "IMU_ATTI(0):quatY", "IMU_ATTI(0):quatZ"}),
              SizeIs(1));
  EXPECT_THAT(readings_of({"/t", "/a/gyro/x", "/a/gyro/y", "/a/gyro/z", "/b/gyro/x", "/b/gyro/y",
                           "/b/gyro/z"}),
              SizeIs(2));
  EXPECT_THAT(
      readings_of({"time", "Six DOF/omega_b(1)", "Six DOF/omega_b(2)", "Six DOF/omega_b(3)"}),
      SizeIs(1));
  EXPECT_THAT(readings_of({"t", "pqr(1) rad/s", "pqr(2) rad/s", "pqr(3) rad/s"}), SizeIs(1));
  EXPECT_THAT(refusal({"t", "bias.gyro.x", "bias.gyro.y", "bias.gyro.z"}),
              HasSubstr("no columns have names of rates"));
  EXPECT_THAT(refusal({"x (m/s)", "wx", "wy", "wz"}),
              HasSubstr("no column is recognised as the time"));
}

TEST(Time, MayBeInDays) {
  for (const char* name :
       {"Sat.A1ModJulian", "mjd", "UTC MJD", "time_days", "Modified Julian Day"}) {
    const auto all = conventions(header_of({name, "wx", "wy", "wz"}), {});
    EXPECT_THAT(all, SizeIs(1)) << name;
    EXPECT_EQ(all.front().time_unit, TimeUnit::d) << name;
  }
}

TEST(Time, IsNotATemperature) {
  EXPECT_THAT(readings_of({"TimeUS", "GyrX", "GyrY", "GyrZ", "T"}), SizeIs(2));
  EXPECT_THAT(readings_of({"T", "wx", "wy", "wz"}), ElementsAre("t=T,wx=wx,wy=wy,wz=wz"));
}

TEST(Rates, OfBetaflightAreInDegrees) {
  EXPECT_EQ(unit_in({"time", "gyroADC[0]", "gyroADC[1]", "gyroADC[2]"}), RateUnit::deg_s);
}

TEST(Attitudes, MayHaveMarksAndFrames) {
  for (const char* names : {"motionQuaternion?(R)", "q_B_I_?", "ori_?", "rot_?"}) {
    const auto name = [&](char component) {
      std::string text = names;
      text[text.find('?')] = component;
      return text;
    };
    EXPECT_THAT(readings_of({"t", name('W'), name('X'), name('Y'), name('Z')}), SizeIs(1)) << names;
  }
  EXPECT_THAT(readings_of({"t", "Mat[1][1]", "Mat[1][2]", "Mat[1][3]", "Mat[2][1]", "Mat[2][2]",
                           "Mat[2][3]", "Mat[3][1]", "Mat[3][2]", "Mat[3][3]"}),
              SizeIs(1));
  EXPECT_THAT(readings_of({"t", "AngleX(deg)", "AngleY(deg)", "AngleZ(deg)"}), SizeIs(6));
  EXPECT_THAT(
      readings_of({"t", "quaternions[0]", "quaternions[1]", "quaternions[2]", "quaternions[3]"}),
      SizeIs(2));
  EXPECT_THAT(readings_of({"t", "q_r", "q_i", "q_j", "q_k"}),
              ElementsAre("t=t,qw=q_r,qx=q_i,qy=q_j,qz=q_k"));
}

TEST(Rates, MayBeKnownByTheirUnit) {
  EXPECT_EQ(unit_in({"t", "gx (dps)", "gy (dps)", "gz (dps)"}), RateUnit::deg_s);
  EXPECT_EQ(unit_in({"A_5E_Timestamp_CAL", "A_5E_Spin_X_CAL", "A_5E_Spin_Y_CAL", "A_5E_Spin_Z_CAL"},
                    {"ms", "deg/s", "deg/s", "deg/s"}),
            RateUnit::deg_s);
  EXPECT_THAT(readings_of({"t", "imu_gx", "imu_gy", "imu_gz"}), SizeIs(1));
  EXPECT_THAT(refusal({"t", "gx (m/s2)", "gy (m/s2)", "gz (m/s2)"}), HasSubstr("no columns"));
  EXPECT_THAT(readings_of({"time", "body.w_a[1]", "body.w_a[2]", "body.w_a[3]"}), SizeIs(1));
}

TEST(Units, ThatContradictEachOtherAreRefused) {
  EXPECT_THAT(refusal({"t", "wx_dps (rad/s)", "wy_dps (rad/s)", "wz_dps (rad/s)"}),
              HasSubstr("the column 'wx_dps (rad/s)' is in deg and rad"));
  EXPECT_THAT(
      refusal(header_of({"t", "wx_deg", "wy_deg", "wz_deg"}, {"s", "rad/s", "rad/s", "rad/s"}), {}),
      HasSubstr("is in deg by its name and in rad/s by its unit"));
}

TEST(Quaternions, ArePreferredToEulerAnglesOfOpenSequence) {
  EXPECT_THAT(readings_of({"t", "roll", "pitch", "yaw", "qz", "qy", "qx", "qw"}),
              ElementsAre("t=t,qw=qw,qx=qx,qy=qy,qz=qz"));
}

TEST(Quaternions, MayBeCalledRotations) {
  EXPECT_THAT(readings_of({"t", "rotation.x", "rotation.y", "rotation.z", "rotation.w"}),
              ElementsAre("t=t,qw=rotation.w,qx=rotation.x,qy=rotation.y,qz=rotation.z"));
  EXPECT_THAT(readings_of({"t", "rotation.x", "rotation.y", "rotation.z"}), SizeIs(6));
}

// Unity's quaternions, or the axes and angles of VRML.
TEST(Rotations, OfFourNumbersAreQuaternionsOrAxesAndAngles) {
  EXPECT_THAT(
      readings_of({"t", "rotation[0]", "rotation[1]", "rotation[2]", "rotation[3]"}),
      ElementsAre("t=t,qw=rotation[0],qx=rotation[1],qy=rotation[2],qz=rotation[3]",
                  "t=t,qw=rotation[3],qx=rotation[0],qy=rotation[1],qz=rotation[2]",
                  "t=t,axisx=rotation[0],axisy=rotation[1],axisz=rotation[2],angle=rotation[3]"));
  EXPECT_THAT(readings_of({"t", "rotation[0]", "rotation[1]", "rotation[2]", "rotation[3]", "qw",
                           "qx", "qy", "qz"}),
              ElementsAre("t=t,qw=qw,qx=qx,qy=qy,qz=qz"));
  Names matrix{"t"};
  for (int i = 0; i < 9; ++i) matrix.push_back("rotation[" + std::to_string(i) + "]");
  for (const std::string& reading : readings_of(matrix)) EXPECT_THAT(reading, HasSubstr("x33="));
}

// As three.js names the components.
TEST(Quaternions, MayHaveNoOtherWords) {
  EXPECT_THAT(readings_of({"time", "_x", "_y", "_z", "_w"}),
              ElementsAre("t=time,qw=_w,qx=_x,qy=_y,qz=_z"));
  EXPECT_THAT(readings_of({"time", "x", "y", "z", "w", "gyro_x", "gyro_y", "gyro_z"}),
              ElementsAre("t=time,wx=gyro_x,wy=gyro_y,wz=gyro_z"));
}

}  // namespace
}  // namespace twrench::recording
