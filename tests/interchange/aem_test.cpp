#include "interchange/aem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <Eigen/Geometry>
#include <map>
#include <sstream>

#include "interchange/playback.h"

namespace twrench::interchange {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

scene::Scene tumbling() {
  scene::Scene scene;
  scene.name = "tumbling";
  scene.body.inertia = Eigen::Vector3d(2, 3, 4).asDiagonal();
  scene.motion.omega = {0.05, 1, 0.3};
  return scene;
}

std::string aem_of(const scene::Scene& scene, const std::vector<double>& times) {
  std::string text;
  write_aem(
      scene, parse_epoch("1996-11-28T21:29:07", "epoch"), "twrench", times.size(),
      [&](std::size_t i) { return times[i]; }, [&](std::string_view piece) { text += piece; });
  return text;
}

/// A reader of the keyword = value notation of CCSDS 504.0-B-1, section 4, modelled on its example.
struct Message {
  explicit Message(const std::string& text) {
    std::istringstream lines(text);
    bool in_data = false;
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 254U);
      if (line.empty() || line.starts_with("COMMENT ")) continue;
      if (const auto equals = line.find(" = "); equals != std::string::npos) {
        EXPECT_FALSE(in_data);
        keys[line.substr(0, equals)] = line.substr(equals + 3);
        order.push_back(line.substr(0, equals));
      } else if (line.find(' ') == std::string::npos) {
        in_data = line == "DATA_START";
        order.push_back(line);
      } else {
        EXPECT_TRUE(in_data);
        std::istringstream row(line);
        std::string epoch;
        double x = 0, y = 0, z = 0, w = 0;
        row >> epoch >> x >> y >> z >> w;
        epochs.push_back(epoch);
        attitudes.emplace_back(w, x, y, z);
      }
    }
  }

  std::map<std::string, std::string> keys;
  std::vector<std::string> order, epochs;
  std::vector<Eigen::Quaterniond> attitudes;
};

// Checks the reader above with the standard's example.
TEST(Aem, ReaderReadsTheExampleOfTheStandard) {
  const Message example(
      "CCSDS_AEM_VERS = 1.0\nCREATION_DATE = 2002-11-04T17:22:31\nORIGINATOR = NASA/JPL\n\n"
      "META_START\nCOMMENT It is to be used for attitude reconstruction only.\n"
      "OBJECT_NAME = MARS GLOBAL SURVEYOR\nOBJECT_ID = 1996-062A\nREF_FRAME_A = EME2000\n"
      "REF_FRAME_B = SC_BODY_1\nATTITUDE_DIR = A2B\nTIME_SYSTEM = UTC\n"
      "ATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = LAST\nMETA_STOP\n\nDATA_START\n"
      "1996-11-28T21:29:07.2555 0.56748 0.03146 0.45689 0.68427\n"
      "1996-11-28T22:08:03.5555 0.42319 -0.45697 0.23784 0.74533\nDATA_STOP\n");
  EXPECT_EQ(example.keys.at("OBJECT_NAME"), "MARS GLOBAL SURVEYOR");
  EXPECT_EQ(example.epochs.at(1), "1996-11-28T22:08:03.5555");
  EXPECT_EQ(example.attitudes.at(1).w(), 0.74533);
  EXPECT_EQ(example.attitudes.at(1).y(), -0.45697);
}

TEST(Aem, HasItsKeywordsInTheOrderOfTheStandard) {
  const std::string text = aem_of(tumbling(), {0, 1});
  EXPECT_THAT(text, StartsWith("CCSDS_AEM_VERS = 1.0\nCOMMENT "));
  const Message message(text);
  EXPECT_EQ(
      message.order,
      (std::vector<std::string>{
          "CCSDS_AEM_VERS", "CREATION_DATE", "ORIGINATOR", "META_START", "OBJECT_NAME", "OBJECT_ID",
          "REF_FRAME_A", "REF_FRAME_B", "ATTITUDE_DIR", "TIME_SYSTEM", "START_TIME", "STOP_TIME",
          "ATTITUDE_TYPE", "QUATERNION_TYPE", "META_STOP", "DATA_START", "DATA_STOP"}));
  EXPECT_EQ(message.keys.at("OBJECT_NAME"), "tumbling");
  EXPECT_EQ(message.keys.at("START_TIME"), message.epochs.front());
  EXPECT_EQ(message.keys.at("STOP_TIME"), message.epochs.back());
  EXPECT_EQ(message.epochs.back(), "1996-11-28T21:29:08.000000000");
}

TEST(Aem, HasTheExactMotionWhateverTheMethod) {
  scene::Scene scene = tumbling();
  scene.motion.method = "euler";
  std::vector<double> times;
  for (int i = 0; i <= 300; ++i) times.push_back(i / 7.0);
  const Message message(aem_of(scene, times));
  ASSERT_EQ(message.attitudes.size(), times.size());
  const motion::ExactMotion exact(
      motion::FreeBody(scene::mass_properties(scene.body).inertia, scene.motion.omega));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Eigen::Quaterniond& q = message.attitudes[i];
    EXPECT_NEAR(q.norm(), 1, 1e-14);
    EXPECT_LT(angle_between(q, exact.at(times[i]).X), 2e-9) << "its time is rounded to 1 ns";
    EXPECT_GT(q.dot(message.attitudes[i > 0 ? i - 1 : 0]), 0);
  }
}

// The matrix in the standard's annex maps the components of a vector in frame A to those in B.
TEST(Aem, TurnsFromAToBAsTheStandardHasIt) {
  const Message message(aem_of(tumbling(), {0, 2}));
  const Eigen::Quaterniond& q = message.attitudes[1];
  const double q1 = q.x(), q2 = q.y(), q3 = q.z(), qc = q.w();
  Eigen::Matrix3d b_from_a;
  b_from_a << q1 * q1 - q2 * q2 - q3 * q3 + qc * qc, 2 * (q1 * q2 + q3 * qc),
      2 * (q1 * q3 - q2 * qc), 2 * (q1 * q2 - q3 * qc), -q1 * q1 + q2 * q2 - q3 * q3 + qc * qc,
      2 * (q2 * q3 + q1 * qc), 2 * (q1 * q3 + q2 * qc), 2 * (q2 * q3 - q1 * qc),
      -q1 * q1 - q2 * q2 + q3 * q3 + qc * qc;
  const motion::ExactMotion exact(
      motion::FreeBody(Eigen::Vector3d(2, 3, 4).asDiagonal(), {0.05, 1, 0.3}));
  EXPECT_LT((b_from_a - exact.at(2).X.transpose()).norm(), 1e-13);
}

TEST(Aem, HasNoInstantTwice) {
  EXPECT_EQ(Message(aem_of(tumbling(), {0, 1, 1 + 1e-12})).epochs.size(), 2U);
}

// If a body turns in nanoseconds, all rows in whole nanoseconds would be the same.
TEST(Aem, HasFinerTimesForFasterBodies) {
  scene::Scene scene = tumbling();
  scene.motion.omega *= 1e10;
  std::vector<double> times;
  for (int i = 0; i <= 300; ++i) times.push_back(1e-11 * i / 7.0);
  const Message message(aem_of(scene, times));
  ASSERT_EQ(message.attitudes.size(), times.size());
  EXPECT_EQ(message.epochs.back(), "1996-11-28T21:29:07.000000000428571");
  const motion::ExactMotion exact(
      motion::FreeBody(scene::mass_properties(scene.body).inertia, scene.motion.omega));
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_LT(angle_between(message.attitudes[i], exact.at(times[i]).X), 2e-5)
        << "its time is rounded to 1 fs";
  }
}

TEST(Aem, IsInAscii) {
  scene::Scene scene = tumbling();
  scene.name = "kn\xc3\xa4uel\n";
  EXPECT_THAT(aem_of(scene, {0, 1}), HasSubstr("OBJECT_NAME = kn__uel_\n"));
}

}  // namespace
}  // namespace twrench::interchange
