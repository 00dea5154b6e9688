#include "table/aem_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "system/error.h"
#include "table/error.h"

namespace twrench::table {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string message_head = "CCSDS_AEM_VERS = 1.0\nCREATION_DATE = 2026-01-01T00:00:00\n\n";
const std::string frames = "REF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1\n";

/// A segment with this metadata and two rows of these values.
std::string segment(const std::string& metadata, const std::string& values = "0 0 0 1",
                    const std::string& object = "BODY", int second = 5) {
  const std::string epoch = "2026-03-04T10:11:0";
  return "META_START\nCOMMENT of a test\nOBJECT_NAME = " + object + "\n" + metadata +
         "META_STOP\nDATA_START\nCOMMENT rows\n" + epoch + std::to_string(second) + ".000 " +
         values + "\n" + epoch + std::to_string(second + 1) + ".000 " + values + "\nDATA_STOP\n";
}

const std::string quaternions =
    frames + "ATTITUDE_DIR = A2B\nATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = LAST\n";

std::unique_ptr<Reader> open_message(const std::string& text) {
  return open_table("a.aem", std::string_view(text));
}

std::vector<std::vector<double>> rows_in(const std::string& text) {
  const auto reader = open_message(text);
  std::vector<std::size_t> columns(reader->header().names.size());
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  std::vector<Number> numbers(columns.size());
  reader->begin_pass(columns);
  std::vector<std::vector<double>> rows;
  while (reader->next(numbers)) {
    std::vector<double>& row = rows.emplace_back();
    for (const Number& number : numbers) row.push_back(number.value);
  }
  return rows;
}

Header header_with(const std::string& metadata) {
  return open_message(message_head + segment(metadata))->header();
}

std::string refusal_of_message(const std::string& text) {
  try {
    rows_in(text);
  } catch (const Error& error) {
    const auto* bad = dynamic_cast<const InvalidArgument*>(&error);
    return std::string(error.what()) + (bad ? " -- " + bad->remedy() : "");
  }
  return "no error";
}

TEST(Aem, HasQuaternionsInEitherOrder) {
  const Header header = header_with(quaternions);
  EXPECT_THAT(header.names, ElementsAre("t", "qx", "qy", "qz", "qw"));
  EXPECT_EQ(header.states_inverse, false);
  const std::string first =
      frames + "ATTITUDE_DIR = B2A\nATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = FIRST\n";
  EXPECT_THAT(header_with(first).names, ElementsAre("t", "qw", "qx", "qy", "qz"));
  EXPECT_EQ(header_with(first).states_inverse, true);
  EXPECT_THAT(
      rows_in(message_head + segment(quaternions)),
      ElementsAre(ElementsAre(1772619065, 0, 0, 0, 1), ElementsAre(1772619066, 0, 0, 0, 1)));
}

TEST(Aem, KnowsWhichFrameIsThatOfTheBody) {
  const std::string reversed =
      "REF_FRAME_A = SC_BODY_1\nREF_FRAME_B = ICRF\nATTITUDE_TYPE = QUATERNION\n"
      "QUATERNION_TYPE = LAST\nATTITUDE_DIR = ";
  EXPECT_EQ(header_with(reversed + "A2B\n").states_inverse, true);
  EXPECT_EQ(header_with(reversed + "B2A\n").states_inverse, false);
}

TEST(Aem, OfVersion2GoesFromFrameAToFrameB) {
  const std::string text =
      "CCSDS_AEM_VERS = 2.0\n" + segment(frames +
                                             "ATTITUDE_TYPE = QUATERNION/ANGVEL\n"
                                             "ANGVEL_FRAME = SC_BODY_1\n",
                                         "0 0 0 1 10 20 30");
  const Header header = open_message(text)->header();
  EXPECT_THAT(header.names, ElementsAre("t", "qx", "qy", "qz", "qw", "wx", "wy", "wz"));
  EXPECT_THAT(header.units, ElementsAre("s", "", "", "", "", "deg/s", "deg/s", "deg/s"));
  EXPECT_EQ(header.states_inverse, false);
}

TEST(Aem, HasRatesInTheAxesOfEitherFrame) {
  const std::string rates = quaternions + "ATTITUDE_TYPE = QUATERNION/RATE\nRATE_FRAME = ";
  EXPECT_EQ(header_with(rates + "REF_FRAME_B\n").names[5], "wx");
  EXPECT_EQ(header_with(rates + "REF_FRAME_A\n").names[5], "omega_space_x");
  EXPECT_EQ(header_with(quaternions + "ATTITUDE_TYPE = QUATERNION/DERIVATIVE\n").names[5],
            "qx_dot");
}

TEST(Aem, HasEulerAnglesInTheOrderOfTheRotations) {
  const std::string angles = frames + "ATTITUDE_TYPE = EULER_ANGLE\nEULER_ROT_SEQ = ";
  const Header header = header_with(angles + "321\n");
  EXPECT_THAT(header.names, ElementsAre("t", "yaw", "pitch", "roll"));
  EXPECT_THAT(header.units, ElementsAre("s", "deg", "deg", "deg"));
  EXPECT_EQ(header.sequence, "zyx");
  EXPECT_THAT(header_with(angles + "XZY\n").names, ElementsAre("t", "roll", "yaw", "pitch"));
  EXPECT_THAT(header_with(angles + "313\n").names, ElementsAre("t", "yaw", "pitch", "roll"));
  EXPECT_THAT(refusal_of_message(message_head + segment(angles + "331\n")), HasSubstr("'331'"));
}

// The standard's example: alpha 0, delta 80 and angle 45 degrees are the quaternion 0.0805, 0.0334,
// 0.9204, 0.3812, of which 2 (q1 q3 + q2 qc) = 0.1736 is the x of the spin axis.
TEST(Aem, HasSpinAsEulerAngles) {
  const std::string spin = frames + "ATTITUDE_TYPE = SPIN/NUTATION\n";
  EXPECT_EQ(header_with(spin).sequence, "zxz");
  EXPECT_EQ(header_with(spin).states_inverse, false);
  EXPECT_THAT(rows_in(message_head + segment(spin, "0 80 45 1 2 3 4"))[0],
              ElementsAre(1772619065, 90, 10, 45, 1, 2, 3, 4));
}

// Those of B relative to A are minus the body's if the body is A.
TEST(Aem, HasAngularVelocitiesOfTheBody) {
  const std::string reversed =
      "REF_FRAME_A = SC_BODY_1\nREF_FRAME_B = ICRF\nATTITUDE_TYPE = QUATERNION/ANGVEL\n"
      "ANGVEL_FRAME = ";
  const auto open = [](const std::string& metadata) {
    return "CCSDS_AEM_VERS = 2.0\n" + segment(metadata, "0 0 0 1 10 20 30");
  };
  EXPECT_THAT(rows_in(open(reversed + "SC_BODY_1\n"))[0],
              ElementsAre(1772619065, 0, 0, 0, 1, -10, -20, -30));
  EXPECT_EQ(open_message(open(reversed + "SC_BODY_1\n"))->header().names[5], "wx");
  EXPECT_EQ(open_message(open(reversed + "ICRF\n"))->header().names[5], "omega_space_x");
  EXPECT_EQ(open_message(open(reversed + "LVLH\n"))->header().names[5], "rate_of_1");
}

// Version 1.0 may mean derivatives of the angles.
TEST(Aem, LeavesRatesOfUncertainMeaningUnread) {
  const std::string rates = "ATTITUDE_TYPE = QUATERNION/RATE\nRATE_FRAME = REF_FRAME_B\n";
  EXPECT_EQ(header_with(quaternions + rates).names[5], "wx");
  EXPECT_EQ(header_with(quaternions + rates + "EULER_ROT_SEQ = 321\n").names[5], "rate_of_1");
  EXPECT_EQ(header_with(quaternions + rates + "ATTITUDE_DIR = B2A\n").names[5], "rate_of_1");
}

TEST(Aem, JoinsConsecutiveSegmentsOfOneBody) {
  const auto rows = rows_in(message_head + segment(quaternions, "0 0 0 1", "BODY", 5) +
                            segment(quaternions, "1 0 0 0", "BODY", 6));
  ASSERT_EQ(rows.size(), 3U) << "the instant at which both meet is one row";
  EXPECT_EQ(rows[1][4], 1);
  EXPECT_EQ(rows[2][4], 0);
}

TEST(Aem, OfSeveralBodiesAsksForOne) {
  const std::string text = message_head + segment(quaternions, "0 0 0 1", "SHIP") +
                           segment(quaternions, "0 0 0 1", "PROBE");
  EXPECT_THAT(refusal_of_message(text),
              AllOf(HasSubstr("its 2 segments are of 2 objects: SHIP, PROBE"),
                    HasSubstr("sed -n '1,3p;4,17p' 'a.aem' > segment-1.aem"),
                    HasSubstr("sed -n '1,3p;18,31p' 'a.aem' > segment-2.aem")));
}

TEST(Aem, RefusesWhatItCannotRead) {
  const auto refusal = [](const std::string& metadata) {
    return refusal_of_message(message_head + segment(metadata));
  };
  EXPECT_THAT(refusal(frames + "ATTITUDE_TYPE = MATRIX\n"),
              HasSubstr("a.aem:4: its ATTITUDE_TYPE is MATRIX, which is not read"));
  EXPECT_THAT(refusal(frames + "ATTITUDE_TYPE = SPIN/WOBBLE\n"), HasSubstr("SPIN/WOBBLE"));
  EXPECT_THAT(refusal("REF_FRAME_A = SC_BODY_1\nREF_FRAME_B = ICRF\nATTITUDE_TYPE = SPIN\n"),
              HasSubstr("its spin axis is given in the frame of the body"));
  EXPECT_THAT(refusal(frames), HasSubstr("no ATTITUDE_TYPE"));
  EXPECT_THAT(refusal(frames + "ATTITUDE_TYPE = QUATERNION\n"), HasSubstr("no QUATERNION_TYPE"));
  EXPECT_THAT(refusal(quaternions + "ATTITUDE_DIR = UP\n"), HasSubstr("ATTITUDE_DIR is 'UP'"));
  const std::string whole = message_head + segment(quaternions);
  EXPECT_THAT(refusal_of_message(whole.substr(0, whole.size() - 12)),
              HasSubstr("it is cut off: DATA_STOP is missing"));
  EXPECT_THAT(refusal_of_message(message_head), HasSubstr("it has no data"));
  EXPECT_THAT(refusal_of_message("CCSDS_ACM_VERS = 2.0\n"),
              HasSubstr("a CCSDS message without attitude ephemerides"));
  EXPECT_THAT(refusal_of_message(message_head + segment(quaternions, "0 0 1")),
              HasSubstr("the row has 4 values, but 5 are due"));
  EXPECT_THAT(refusal_of_message(message_head + segment(quaternions, "0 0 x 1")),
              HasSubstr("the column 'qz': 'x' is no number"));
}

}  // namespace
}  // namespace twrench::table
