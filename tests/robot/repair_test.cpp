#include "robot/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "robot/samples.h"

namespace twrench::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Repair repair_of(const RobotFile& file, bool from_geometry = false) {
  return repair(judge_robot(file.read(), {}), from_geometry);
}

TEST(NearestPossible, KeepsWhatIsPossible) {
  const LinkMass body{2, Vector3d(1, 2, 3), Vector3d(3, 4, 5).asDiagonal()};
  EXPECT_TRUE(nearest_possible(body).inertia.isApprox(body.inertia, 1e-14));
}

TEST(NearestPossible, ChangesOnlyWhatIsImpossible) {
  // The second moments are 1.5, 1.5 and -0.5 before, and 1.5, 1.5 and nearly 0 after.
  const LinkMass body{1, Vector3d::Zero(), Vector3d(1, 1, 3).asDiagonal()};
  const LinkMass nearest = nearest_possible(body);
  EXPECT_TRUE(is_possible(nearest));
  EXPECT_TRUE(nearest.inertia.isApprox(Matrix3d(Vector3d(1.5, 1.5, 3).asDiagonal()), 1e-5));
}

TEST(Repair, ReplacesADiagonalMatrixOfMjcf) {
  // A box of 12 kg, whose moments are exchanged. The rotation is that of the inertial frame.
  const RobotFile file(
      "<mujoco model=\"m\">\n<worldbody>\n<body name=\"b\">\n"
      "<inertial pos=\"0 0 0\" quat=\"0.7071067811865476 0 0 0.7071067811865476\"  mass=\"12\" "
      "diaginertia=\"13 10 5\"/> <!-- kept -->\n"
      "<geom type=\"box\" size=\"0.5 1 1.5\" contype=\"0\" conaffinity=\"0\"/>\n"
      "</body>\n</worldbody>\n</mujoco>\n",
      "robot.xml");
  const Repair repaired = repair_of(file);
  ASSERT_THAT(repaired.changes, SizeIs(1));
  EXPECT_THAT(repaired.text,
              HasSubstr("<inertial pos=\"0 0 0\"  mass=\"12\" fullinertia=\"13 10 5 0 0 0\"/> "
                        "<!-- kept -->\n"));
}

TEST(Repair, ReplacesElementsOfSdf) {
  const RobotFile file(
      "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"><inertial><mass>12</mass><inertia>"
      "<ixx>13e6</ixx><iyy> 10e6 </iyy><izz>5e6</izz></inertia></inertial>"
      "<visual name=\"v\"><geometry><box><size>1 2 3</size></box></geometry></visual></link>"
      "</model></sdf>",
      "robot.sdf");
  const Repair repaired = repair_of(file);
  ASSERT_THAT(repaired.changes, SizeIs(1));
  EXPECT_THAT(repaired.text, HasSubstr("<ixx>13</ixx><iyy> 10 </iyy><izz>5</izz>"));
}

TEST(Repair, NamesALinkWhoseNumbersAreNotInTheFile) {
  // The products of a rotated box cannot be written, because the file has no elements for them.
  const RobotFile file(
      "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"><inertial><mass>12</mass><inertia>"
      "<ixx>1</ixx><iyy>1</iyy><izz>30</izz></inertia></inertial>"
      "<visual name=\"v\"><pose>0 0 0 0.3 0.2 0.1</pose><geometry><box><size>1 2 3</size></box>"
      "</geometry></visual></link></model></sdf>",
      "robot.sdf");
  const Repair repaired = repair_of(file, true);
  EXPECT_THAT(repaired.changes, IsEmpty());
  ASSERT_THAT(repaired.unrepaired, SizeIs(1));
  EXPECT_THAT(repaired.unrepaired[0].reason, HasSubstr("no place for one of the numbers"));
  EXPECT_EQ(repaired.text, judge_robot(file.read(), {}).robot.text);
}

TEST(Repair, LeavesLinksThatNothingDetermines) {
  const RobotFile file(
      "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"0\"/><inertia ixx=\"0\" "
      "ixy=\"0\" "
      "ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link></robot>");
  for (const bool from_geometry : {false, true}) {
    const Repair repaired = repair_of(file, from_geometry);
    EXPECT_THAT(repaired.changes, IsEmpty());
    EXPECT_THAT(repaired.unrepaired, SizeIs(1));
  }
}

}  // namespace
}  // namespace twrench::robot
