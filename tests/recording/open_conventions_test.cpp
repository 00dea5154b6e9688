#include "recording/columns/open_conventions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "table/error.h"

namespace twrench::recording {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;
using testing::StartsWith;

using Names = std::vector<std::string>;

table::Header header_of(Names names, Names units = {}) {
  return {"run.csv", std::move(names), std::move(units), {}, {}};
}

/// The columns of each reading, as the user would give them.
Names readings_of(const Names& names, const std::string& said = {}) {
  Convention told;
  told.columns = parse_columns(said, "columns");
  Names all;
  for (const Convention& convention : conventions(header_of(names), told)) {
    all.push_back(format_columns(convention.columns));
  }
  return all;
}

std::string refusal(const table::Header& header, const Convention& said) {
  try {
    conventions(header, said);
  } catch (const table::BadTable& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

std::string refusal(const Names& names, const std::string& said = {}) {
  Convention told;
  told.columns = parse_columns(said, "columns");
  return refusal(header_of(names), told);
}

/// The unit of the only reading.
std::optional<RateUnit> unit_in(const Names& names, const Names& units = {}) {
  const auto all = conventions(header_of(names, units), {});
  EXPECT_THAT(all, SizeIs(1));
  return all.front().rate_unit;
}

TEST(Conventions, FindOurOwnNames) {
  EXPECT_THAT(readings_of({"wz", "t", "energy", "wx", "wy"}), ElementsAre("t=t,wx=wx,wy=wy,wz=wz"));
  EXPECT_THAT(readings_of({"T", "WX", "Wy", "WZ"}), ElementsAre("t=T,wx=WX,wy=Wy,wz=WZ"));
  EXPECT_THAT(readings_of({"t", "qw", "qx", "qy", "qz"}),
              ElementsAre("t=t,qw=qw,qx=qx,qy=qy,qz=qz"));
  EXPECT_THAT(
      readings_of({"t", "x11", "x12", "x13", "x21", "x22", "x23", "x31", "x32", "x33", "wx", "wy",
                   "wz", "energy", "energy_drift", "orthogonality_error", "momentum_error"}),
      ElementsAre("t=t,wx=wx,wy=wy,wz=wz,x11=x11,x12=x12,x13=x13,x21=x21,x22=x22,x23=x23,"
                  "x31=x31,x32=x32,x33=x33"));
}

// As `simulate` writes JSON.
TEST(Conventions, FindOurOwnArrays) {
  Names names{"t"};
  for (int i = 0; i < 9; ++i) names.push_back("X[" + std::to_string(i) + "]");
  for (int i = 0; i < 3; ++i) names.push_back("omega[" + std::to_string(i) + "]");
  EXPECT_THAT(readings_of(names),
              ElementsAre("t=t,wx=omega[0],wy=omega[1],wz=omega[2],x11=X[0],x12=X[1],x13=X[2],"
                          "x21=X[3],x22=X[4],x23=X[5],x31=X[6],x32=X[7],x33=X[8]"));
}

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

// As OpenSim writes it.
TEST(Conventions, TakeTheUnitFromTheLinesBeforeTheNames) {
  table::Header header = header_of({"time", "omega_x", "omega_y", "omega_z"});
  header.preamble = {"motion", "version=1", "inDegrees=yes", "endheader"};
  EXPECT_EQ(conventions(header, {}).front().rate_unit, RateUnit::deg_s);
  header.preamble[2] = "inDegrees=no";
  EXPECT_EQ(conventions(header, {}).front().rate_unit, RateUnit::rad_s);
  Convention said;
  said.rate_unit = RateUnit::deg_s;
  EXPECT_THAT(refusal(header, said), HasSubstr("state rad, but deg is given"));
  header.names = {"time", "omega_x (deg/s)", "omega_y (deg/s)", "omega_z (deg/s)"};
  EXPECT_THAT(refusal(header, {}), HasSubstr("'omega_x (deg/s)' states deg, but rad is given"));
}

TEST(Conventions, RefuseUnitsOfOtherQuantities) {
  EXPECT_THAT(refusal({"t", "wx_ms", "wy_ms", "wz_ms"}), HasSubstr("'wx_ms' is in ms"));
  EXPECT_THAT(refusal(header_of({"t", "wx", "wy", "wz"}, {"s", "g", "g", "g"}), {}),
              HasSubstr("'wx' is in g"));
  EXPECT_THAT(refusal(header_of({"t", "wx", "wy", "wz"}, {"deg", "rad/s", "rad/s", "rad/s"}), {}),
              HasSubstr("'t' is in deg"));
}

TEST(Conventions, PutOurOwnNamesBeforeOthers) {
  EXPECT_THAT(readings_of({"t", "time", "wx", "wy", "wz", "gyro_x", "gyro_y", "gyro_z"}),
              ElementsAre("t=t,wx=wx,wy=wy,wz=wz"));
}

// Simulator 05 of NASA's check cases, with positions, forces and one name twice.
TEST(Conventions, FindTheirWayAmongManyColumns) {
  EXPECT_THAT(
      readings_of({"time",
                   "eiPosition_ft_X",
                   "eiPosition_ft_Y",
                   "eiPosition_ft_Z",
                   "gePosition_ft_X",
                   "gePosition_ft_Y",
                   "gePosition_ft_Z",
                   "eiVelocity_ft_s_X",
                   "eiVelocity_ft_s_Y",
                   "eiVelocity_ft_s_Z",
                   "feVelocity_ft_s_X",
                   "feVelocity_ft_s_Y",
                   "feVelocity_ft_s_Z",
                   "altitudeMsl_ft",
                   "longitude_deg",
                   "latitude_deg",
                   "localGravity_ft_s2",
                   "eulerAngle_deg_Yaw",
                   "eulerAngle_deg_Pitch",
                   "eulerAngle_deg_Roll",
                   "bodyAngularRateWrtEi_deg_s_Roll",
                   "bodyAngularRateWrtEi_deg_s_Pitch",
                   "bodyAngularRateWrtEi_deg_s_Yaw",
                   "altitudeRateWrtMsl_ft_min",
                   "speedOfSound_ft_s",
                   "airDensity_slug_ft3",
                   "ambientPressure_lbf_ft2",
                   "ambientTemperature_dgR",
                   "aero_bodyForce_lbf_X",
                   "aero_bodyForce_lbf_Y",
                   "aero_bodyForce_lbf_Z",
                   "aero_bodyMoment_ftlbf_L",
                   "aero_bodyMoment_ftlbf_M",
                   "aero_bodyMoment_ftlbf_N",
                   "mach",
                   "dynamicPressure_lbf_ft2",
                   "trueAirspeed_nmi_h",
                   "feVelocity_ft_s_Z"},
                  ""),
      testing::Each(
          "t=time,wx=bodyAngularRateWrtEi_deg_s_Roll,wy=bodyAngularRateWrtEi_deg_s_Pitch,"
          "wz=bodyAngularRateWrtEi_deg_s_Yaw,yaw=eulerAngle_deg_Yaw,pitch=eulerAngle_deg_Pitch,"
          "roll=eulerAngle_deg_Roll"));
}

// The scalar may be first or last; a matrix may be written by rows or by columns.
TEST(Conventions, LeaveOpenWhatNamesLeaveOpen) {
  for (const Names& n : {Names{"q0", "q1", "q2", "q3"}, Names{"q1", "q2", "q3", "q4"},
                         Names{"quat[0]", "quat[1]", "quat[2]", "quat[3]"}}) {
    EXPECT_THAT(readings_of({"t", n[0], n[1], n[2], n[3]}),
                ElementsAre("t=t,qw=" + n[0] + ",qx=" + n[1] + ",qy=" + n[2] + ",qz=" + n[3],
                            "t=t,qw=" + n[3] + ",qx=" + n[0] + ",qy=" + n[1] + ",qz=" + n[2]));
  }
  Names names{"t"};
  for (int i = 0; i < 9; ++i) names.push_back("rot" + std::to_string(i));
  EXPECT_THAT(readings_of(names),
              ElementsAre(HasSubstr("x12=rot1,x13=rot2"), HasSubstr("x12=rot3,x13=rot6")));
  EXPECT_THAT(readings_of({"time", "sim_time", "p", "q", "r"}), SizeIs(2));
  EXPECT_THAT(readings_of({"t", "gyro_x", "gyro_y", "gyro_z", "omega_x", "omega_y", "omega_z"}),
              SizeIs(2));
}

TEST(Conventions, KnowTheColumnsOfAFileWithoutNamesByTheirNumber) {
  const auto unnamed = [](int count) {
    Names names;
    for (int i = 1; i <= count; ++i) names.push_back("#" + std::to_string(i));
    return names;
  };
  EXPECT_THAT(readings_of(unnamed(4)), ElementsAre("t=#1,wx=#2,wy=#3,wz=#4"));
  EXPECT_THAT(readings_of(unnamed(5)),
              ElementsAre("t=#1,qw=#2,qx=#3,qy=#4,qz=#5", "t=#1,qw=#5,qx=#2,qy=#3,qz=#4"));
  EXPECT_THAT(readings_of(unnamed(8)),
              ElementsAre("t=#1,wx=#6,wy=#7,wz=#8,qw=#2,qx=#3,qy=#4,qz=#5",
                          "t=#1,wx=#6,wy=#7,wz=#8,qw=#5,qx=#2,qy=#3,qz=#4",
                          "t=#1,wx=#2,wy=#3,wz=#4,qw=#5,qx=#6,qy=#7,qz=#8",
                          "t=#1,wx=#2,wy=#3,wz=#4,qw=#8,qx=#5,qy=#6,qz=#7",
                          "t=#1,qw=#5,qx=#6,qy=#7,qz=#8", "t=#1,qw=#8,qx=#5,qy=#6,qz=#7"));
  EXPECT_THAT(readings_of(unnamed(10)), SizeIs(2));
  EXPECT_THAT(readings_of(unnamed(13)), SizeIs(6));
  EXPECT_THAT(readings_of(unnamed(8), "wx=#2,wy=#3,wz=#4,t=#1"), SizeIs(1));
  EXPECT_THAT(refusal(unnamed(6)), HasSubstr("no columns have names of rates"));
}

TEST(Conventions, LeaveTheSequenceOfEulerAnglesOpen) {
  const auto header = header_of({"t", "euler_yaw_deg", "euler_pitch_deg", "euler_roll_deg"});
  const auto open = conventions(header, {});
  ASSERT_THAT(open, SizeIs(6));
  EXPECT_EQ(open.front().sequence, "zyx");
  EXPECT_EQ(open.front().angle_unit, Angle::degrees);
  EXPECT_EQ(open.front().rate_unit, std::nullopt);
  Convention said;
  said.sequence = "zxz";
  ASSERT_THAT(conventions(header, said), SizeIs(1));
  EXPECT_EQ(conventions(header, said).front().sequence, "zxz");
  EXPECT_THAT(
      conventions(header_of({"t", "phi", "theta", "psi"}), said).front().columns,
      ElementsAre(Pair("pitch", "theta"), Pair("roll", "phi"), Pair("t", "t"), Pair("yaw", "psi")));
}

TEST(Conventions, TakeWhatWasSaid) {
  EXPECT_THAT(readings_of({"a", "b", "c", "d", "qw", "qx", "qy", "qz"}, "t=a,wx=b,wy=C,wz=#4"),
              ElementsAre("t=a,wx=b,wy=c,wz=d"));
  // The time is detected; beside the given rates, nothing else is.
  EXPECT_THAT(readings_of({"time", "a", "b", "c", "qw", "qx", "qy", "qz"}, "wx=a,wy=b,wz=c"),
              ElementsAre("t=time,wx=a,wy=b,wz=c"));
  // Columns that are not given have our names.
  EXPECT_THAT(readings_of({"t", "wx", "WY", "r"}, "wz=r"), ElementsAre("t=t,wx=wx,wy=WY,wz=r"));
  EXPECT_THAT(readings_of({"a", "p", "q", "r"}, "t=a"), ElementsAre("t=a,wx=p,wy=q,wz=r"));
}

TEST(Conventions, SayWhatIsMissing) {
  EXPECT_THAT(refusal({"t", "wx", "wy"}), AllOf(HasSubstr("it has 'wx', 'wy', but nothing for wz"),
                                                HasSubstr("its columns are: t, wx, wy")));
  EXPECT_THAT(refusal({"t", "qx", "qy", "qz"}), HasSubstr("nothing for qw"));
  EXPECT_THAT(refusal({"wx", "wy", "wz"}), HasSubstr("no column is recognised as the time"));
  EXPECT_THAT(refusal({"t", "energy"}),
              HasSubstr("no columns have names of rates or of an attitude"));
  EXPECT_THAT(refusal({"t", "p", "q", "r"}, "wx=p,wy=q"),
              HasSubstr("columns are given for wy, but not for wz"));
  EXPECT_THAT(refusal({"t", "a", "p", "q", "r"}, "yaw=p,pitch=q,roll=r,qw=a,qx=p,qy=q,qz=r"),
              HasSubstr("given both for the quaternion and for the Euler angles"));
}

TEST(Conventions, SayWhatTheFileHasNot) {
  EXPECT_THAT(refusal({"time", "rate_a", "rate_b", "rate_c"}, "wx=rate_a,wy=rate_bb,wz=rate_c"),
              AllOf(HasSubstr("it has no column 'rate_bb' for wy"),
                    HasSubstr("did you mean 'rate_b'?"), HasSubstr("time, rate_a")));
  EXPECT_THAT(refusal({"time", "p", "q", "r"}, "t=#5"), HasSubstr("no column '#5' for t"));
  EXPECT_THAT(refusal({"time", "p", "q", "r"}, "t=#0"), HasSubstr("no column '#0' for t"));
}

// As in NASA's files. Only a user who selects such a column is asked which one is meant.
TEST(Conventions, AskWhichOfTwoColumnsIsMeant) {
  EXPECT_THAT(readings_of({"t", "v", "p", "q", "r", "v"}), ElementsAre("t=t,wx=p,wy=q,wz=r"));
  EXPECT_THAT(refusal({"t", "v", "p", "q", "r", "v"}, "t=v"),
              AllOf(HasSubstr("it has 2 columns 'v' (for t)"), HasSubstr("#2 or #6 is meant")));
  EXPECT_THAT(readings_of({"t", "v", "p", "q", "r", "v"}, "t=#6"),
              ElementsAre("t=#6,wx=p,wy=q,wz=r"));
  EXPECT_THAT(refusal({"t", "p", "q", "r", "p"}),
              HasSubstr("two columns could be wx: 'p' (#2) and 'p' (#5)"));
  EXPECT_THAT(refusal({"t", "p", "q", "r"}, "wx=p,wy=p,wz=r"),
              HasSubstr("the column 'p' is used for both wx and wy"));
}

TEST(Conventions, TakeTheUnitFromTheNames) {
  EXPECT_EQ(unit_in({"t", "p", "q", "r"}), std::nullopt);
  EXPECT_EQ(unit_in({"t", "p_deg_s", "q_deg_s", "r_deg_s"}), RateUnit::deg_s);
  EXPECT_EQ(unit_in({"t", "p [deg/s]", "q [deg/s]", "r [deg/s]"}), RateUnit::deg_s);
  EXPECT_EQ(unit_in({"t", "p (\u00b0/s)", "q (\u00b0/s)", "r (\u00b0/s)"}), RateUnit::deg_s);
  EXPECT_EQ(unit_in({"t", "gyro_x_dps", "gyro_y_dps", "gyro_z_dps"}), RateUnit::deg_s);
  EXPECT_EQ(unit_in({"t", "wx (rad/s)", "wy (rad/s)", "wz (rad/s)"}), RateUnit::rad_s);
  EXPECT_EQ(unit_in({"t", "wx", "wy", "wz"}, {"s", "deg/s", "deg/s", "deg/s"}), RateUnit::deg_s);
}

TEST(Conventions, KnowEveryUnit) {
  const std::pair<const char*, RateUnit> rates[] = {{"wx [rev/s]", RateUnit::rev_s},
                                                    {"wx_rps", RateUnit::rev_s},
                                                    {"wx_rpm", RateUnit::rpm},
                                                    {"wx (rev/min)", RateUnit::rpm},
                                                    {"trueAngularRate_X_rad_s", RateUnit::rad_s}};
  for (const auto& [name, unit] : rates) {
    const std::string x(name), axis = x.starts_with("true") ? "X" : "x";
    const auto with = [&](const char* other) {
      return std::string(x).replace(x.find(axis), 1, other);
    };
    EXPECT_EQ(unit_in({"t", x, with("y"), with("z")}), unit) << name;
  }
  const std::pair<const char*, TimeUnit> times[] = {
      {"t_ms", TimeUnit::ms},      {"time [us]", TimeUnit::us}, {"timestamp_ns", TimeUnit::ns},
      {"time_min", TimeUnit::min}, {"t (h)", TimeUnit::h},      {"elapsed_hours", TimeUnit::h},
      {"t [s]", TimeUnit::s}};
  for (const auto& [name, unit] : times) {
    const auto all = conventions(header_of({name, "wx", "wy", "wz"}), {});
    ASSERT_THAT(all, SizeIs(1)) << name;
    EXPECT_EQ(all.front().time_unit, unit) << name;
  }
  Convention said;
  said.time_unit = TimeUnit::s;
  EXPECT_THAT(refusal(header_of({"t_ms", "wx", "wy", "wz"}), said),
              HasSubstr("the column 't_ms' states ms, but s is given"));
}

TEST(Conventions, RefuseUnitsThatContradict) {
  Convention said;
  said.rate_unit = RateUnit::rad_s;
  EXPECT_THAT(refusal(header_of({"t", "p_deg_s", "q_deg_s", "r_deg_s"}), said),
              HasSubstr("the column 'p_deg_s' states deg, but rad is given"));
  EXPECT_THAT(refusal(header_of({"t", "wx", "wy", "wz"}, {"s", "deg/s", "rad/s", "deg/s"}), {}),
              HasSubstr("'wy' states rad, but deg is stated by another"));
  EXPECT_THAT(refusal(header_of({"t", "wx", "wy", "wz"}, {"s", "gon/s", "gon/s", "gon/s"}), {}),
              HasSubstr("is in gon, which is not supported"));
  EXPECT_THAT(refusal(header_of({"t", "yaw_rpm", "pitch_rpm", "roll_rpm"}), {}),
              HasSubstr("is in rpm, which is not supported"));
  said.rate_unit = RateUnit::deg_s;
  EXPECT_EQ(conventions(header_of({"t", "p_deg_s", "q_deg_s", "r_deg_s"}), said).front().rate_unit,
            RateUnit::deg_s);
}

TEST(Conventions, KeepTheUnitsOfRatesAndEulerAnglesApart) {
  Convention said;
  said.sequence = "zyx";
  const auto all = conventions(
      header_of({"t", "yaw_rad", "pitch_rad", "roll_rad", "p_deg_s", "q_deg_s", "r_deg_s"}), said);
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all.front().rate_unit, RateUnit::deg_s);
  EXPECT_EQ(all.front().angle_unit, Angle::radians);
}

TEST(Conventions, NoticeRatesInSpaceAxes) {
  const auto all = conventions(
      header_of({"t", "qw", "qx", "qy", "qz", "omega_world_x", "omega_world_y", "omega_world_z"}),
      {});
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_TRUE(all.front().rates_in_space);
  // In the axes of inertial space, or in the body's and relative to it?
  EXPECT_THAT(readings_of({"t", "qw", "qx", "qy", "qz", "omega_inertial_x", "omega_inertial_y",
                           "omega_inertial_z"}),
              ElementsAre("t=t,qw=qw,qx=qx,qy=qy,qz=qz"));
}

TEST(Conventions, DoNotTakeWhatIsNotMeant) {
  for (const Names& n :
       {Names{"vx", "vy", "vz"}, Names{"velocity_x", "velocity_y", "velocity_z"},
        Names{"accel.x", "accel.y", "accel.z"}, Names{"psi_dot", "theta_dot", "phi_dot"},
        Names{"x", "y", "z"}, Names{"moment_L", "moment_M", "moment_N"}}) {
    EXPECT_THAT(refusal({"t", n[0], n[1], n[2]}), HasSubstr("no columns have names of rates"))
        << n[0];
  }
}

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
  EXPECT_THAT(refusal({"t", "bias.gyro.x", "bias.gyro.y", "bias.gyro.z"}),
              HasSubstr("no columns have names of rates"));
  EXPECT_THAT(refusal({"x (m/s)", "wx", "wy", "wz"}),
              HasSubstr("no column is recognised as the time"));
}

TEST(Time, IsNotATemperature) {
  EXPECT_THAT(readings_of({"TimeUS", "GyrX", "GyrY", "GyrZ", "T"}), SizeIs(2));
  EXPECT_THAT(readings_of({"T", "wx", "wy", "wz"}), ElementsAre("t=T,wx=wx,wy=wy,wz=wz"));
}

TEST(Rates, OfBetaflightAreInDegrees) {
  EXPECT_EQ(unit_in({"time", "gyroADC[0]", "gyroADC[1]", "gyroADC[2]"}), RateUnit::deg_s);
}

TEST(Quaternions, MayHaveMarksAndFrames) {
  for (const char* names : {"motionQuaternion?(R)", "q_B_I_?", "ori_?", "rot_?"}) {
    const auto name = [&](char component) {
      std::string text = names;
      text[text.find('?')] = component;
      return text;
    };
    EXPECT_THAT(readings_of({"t", name('W'), name('X'), name('Y'), name('Z')}), SizeIs(1)) << names;
  }
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

}  // namespace
}  // namespace twrench::recording
