#include "recording/columns/open_conventions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recording/readings_by_name.h"

namespace twrench::recording {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::SizeIs;

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
  EXPECT_THAT(readings_of({"Var1", "Var2", "Var3", "Var4"}),
              ElementsAre("t=Var1,wx=Var2,wy=Var3,wz=Var4"));
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

}  // namespace
}  // namespace twrench::recording
