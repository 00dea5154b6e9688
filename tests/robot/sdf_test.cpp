#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "robot/geometry.h"
#include "robot/samples.h"

namespace twrench::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Robot sdf(const std::string& inside) {
  return RobotFile("<sdf version='1.11'>\n" + inside + "</sdf>\n", "robot.sdf").read();
}

std::string refusal_of(const std::string& inside) {
  return RobotFile("<sdf version='1.11'>\n" + inside + "</sdf>\n", "robot.sdf").refusal();
}

std::string model_of(const std::string& link) {
  return "<model name='m'>\n<link name='arm'>\n" + link + "</link></model>\n";
}

constexpr const char* sdf_inertial =
    "<inertial><pose degrees='true'>0.1 2e-1 -.3  0 0 90</pose>\n"
    "<mass> 2.50 </mass><inertia><ixx>0.01</ixx><ixy>0.001</ixy><ixz>-2e-3</ixz>"
    "<iyy>2.0e-2</iyy><!-- no product --><izz>0.03</izz></inertia></inertial>\n";

TEST(Sdf, ReadsTheMassPropertiesOfALink) {
  const Robot robot = sdf(model_of(sdf_inertial));
  EXPECT_EQ(robot.format, Format::sdf);
  EXPECT_EQ(robot.name, "m");
  const Inertial& read = *robot.link("arm").inertial;
  EXPECT_EQ(read.mass.value, 2.5);
  EXPECT_EQ(read.centre_of_mass(), Eigen::Vector3d(0.1, 0.2, -0.3));
  const Eigen::Matrix3d inertia = read.inertia();
  EXPECT_NEAR(inertia(0, 0), 0.02, 1e-17);
  EXPECT_NEAR(inertia(1, 1), 0.01, 1e-17);
  EXPECT_NEAR(inertia(0, 1), -0.001, 1e-17);
  EXPECT_NEAR(inertia(1, 2), -0.002, 1e-17);
}

TEST(Sdf, MayHaveTheRootOfOldFiles) {
  const Robot robot = RobotFile("<gazebo>" + model_of(sdf_inertial) + "</gazebo>").read();
  EXPECT_EQ(robot.format, Format::sdf);
  EXPECT_EQ(robot.links.size(), 1U);
}

TEST(Sdf, KnowsThePlaceOfEachNumber) {
  const Robot robot = sdf(model_of(sdf_inertial));
  const Inertial& read = *robot.link("arm").inertial;
  const auto text_of = [&](const Written& number) {
    return robot.text.substr(number.place->begin, number.place->size);
  };
  EXPECT_EQ(text_of(read.mass), "2.50");
  EXPECT_EQ(text_of(read.centre[2]), "-.3");
  EXPECT_EQ(text_of(read.entries[xz]), "-2e-3");
  EXPECT_EQ(text_of(read.entries[zz]), "0.03");
  EXPECT_FALSE(read.entries[yz].place);
}

TEST(Sdf, AssumesTheDefaultsOfTheFormat) {
  const Robot robot =
      sdf("<model name='m'><link name='a'/>\n<link name='b'><inertial/></link>\n"
          "<link name='c'><inertial><inertia><ixx>3</ixx></inertia></inertial>"
          "</link></model>");
  for (const char* name : {"a", "b"}) {
    EXPECT_EQ(robot.link(name).inertial->mass.value, 1.0);
    EXPECT_EQ(robot.link(name).inertial->matrix(), Eigen::Matrix3d::Identity());
  }
  EXPECT_EQ(robot.link("c").inertial->matrix().diagonal(), Eigen::Vector3d(3, 1, 1));
  EXPECT_THAT(robot.notes,
              ElementsAre(HasSubstr("robot.sdf:3: inertial: it has no <inertia>"),
                          HasSubstr("robot.sdf: 'a' has no <inertial>: SDF assumes 1 kg")));
  const Robot frames = sdf("<model name='m'><link name='a'/><link name='b'/></model>");
  EXPECT_THAT(frames.notes, ElementsAre(HasSubstr("'a' and 'b' have no <inertial>: SDF assumes")));
}

TEST(Sdf, ReadsQuaternions) {
  const double half = std::numbers::sqrt2 / 2;
  const Robot robot = sdf(model_of(fmt::format(
      "<inertial><pose rotation_format='quat_xyzw'>1 2 3  0 0 {} {}</pose><inertia><ixx>1</ixx>"
      "<iyy>2</iyy><izz>2.5</izz></inertia></inertial>",
      2 * half, 2 * half)));
  const Eigen::Matrix3d inertia = robot.link("arm").inertial->inertia();
  EXPECT_TRUE(inertia.isApprox(Eigen::Vector3d(2, 1, 2.5).asDiagonal().toDenseMatrix(), 1e-15));
}

TEST(Sdf, QualifiesTheNamesOfLinksOfSeveralModels) {
  const std::string link = "<link name='l'><inertial auto='true'/></link>";
  EXPECT_EQ(sdf("<model name='m'>" + link + "</model>").links.front().name, "l");
  const Robot robot =
      sdf("<world name='w'><model name='a'>" + link + "<model name='b'>" + link +
          "</model><joint name='j' type='fixed'><parent>l</parent><child>b::l</child></joint>"
          "<include><uri>model://sun</uri></include></model><model name='c'>" +
          link +
          "<joint name='j' "
          "type='fixed'><parent>world</parent><child>l</child></joint></model></world>");
  EXPECT_EQ(robot.name, "w");
  ASSERT_EQ(robot.links.size(), 3U);
  EXPECT_EQ(robot.link("a::b::l").parent, "a::l");
  EXPECT_EQ(robot.link("a::l").parent, "");
  EXPECT_EQ(robot.link("c::l").parent, "");
  EXPECT_THAT(robot.notes,
              ElementsAre(HasSubstr("robot.sdf:2: include: the model model://sun is not read")));
}

TEST(Sdf, ReadsGeometries) {
  const auto visual = [](const std::string& shape) {
    return "<visual name='v'><geometry>" + shape + "</geometry></visual>\n";
  };
  const Robot robot = sdf(model_of(
      sdf_inertial + visual("<box><size>1 2 3</size></box>") +
      visual("<cylinder><radius>.1</radius><length>2</length></cylinder>") +
      visual("<sphere><radius>.1</radius></sphere>") +
      visual("<capsule><radius>.1</radius><length>2</length></capsule>") +
      visual("<ellipsoid><radii>1 2 3</radii></ellipsoid>") +
      visual("<cone><radius>.1</radius><length>2</length></cone>") +
      visual("<mesh><uri>model://m/a.stl</uri><scale>1 2 3</scale></mesh>") + visual("<empty/>") +
      "<collision name='c'><pose>1 2 3 0 0 1.5707963267948966</pose><geometry><box><size>1 1 1"
      "</size></box></geometry></collision>"));
  const std::vector<Geometry>& read = robot.link("arm").geometries;
  ASSERT_EQ(read.size(), 8U);
  const auto shape_of = [&](int i) { return std::get<body::Shape>(read[i].shape); };
  EXPECT_EQ(std::get<body::Box>(shape_of(0)).size, Eigen::Vector3d(100, 200, 300));
  EXPECT_EQ(std::get<body::Cylinder>(shape_of(1)).length, 200);
  EXPECT_EQ(std::get<body::Ellipsoid>(shape_of(2)).radii, Eigen::Vector3d(10, 10, 10));
  EXPECT_EQ(std::get<body::Capsule>(shape_of(3)).radius, 10);
  EXPECT_EQ(std::get<body::Ellipsoid>(shape_of(4)).radii, Eigen::Vector3d(100, 200, 300));
  EXPECT_EQ(std::get<body::Cone>(shape_of(5)).length, 200);
  EXPECT_EQ(std::get<MeshReference>(read[6].shape).uri, "model://m/a.stl");
  EXPECT_EQ(std::get<MeshReference>(read[6].shape).scale, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read[7].use, Geometry::Use::collision);
  EXPECT_EQ(read[7].link_from_geometry.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(read[7].link_from_geometry.linear()(1, 0), 1, 1e-15);
  EXPECT_TRUE(robot.notes.empty());
}

TEST(Sdf, NamesGeometriesThatItIgnores) {
  const Robot robot = sdf(model_of(
      "<inertial auto='1'><mass>3</mass></inertial>"
      "<collision name='c'><geometry><plane/></geometry></collision>\n"
      "<collision name='d'><geometry><mesh><uri>a.dae</uri><submesh><name>s</name></submesh>"
      "</mesh></geometry></collision>\n"
      "<collision name='e'><pose relative_to='f'/><geometry><sphere><radius>1</radius></sphere>"
      "</geometry></collision>"));
  EXPECT_THAT(robot.notes, ElementsAre(HasSubstr("plane: <plane> is ignored"),
                                       HasSubstr("submesh: part 's' of a mesh is ignored"),
                                       HasSubstr("its pose is relative to 'f'"),
                                       HasSubstr("its <mass> is ignored: SDF 1.12 would scale")));
  for (const Geometry& geometry : robot.link("arm").geometries)
    EXPECT_TRUE(std::holds_alternative<UnknownShape>(geometry.shape));
  Meshes meshes(robot, {});
  EXPECT_FALSE(LinkGeometry(robot.links.front(), meshes).is_known());
}

// Two cubes, of 1 m^3 at x = 0 and of 8 m^3 at x = 3 with half the density: 1000 + 4000 kg.
TEST(Sdf, FollowsTheCollisionsIfTheInertiaIsAutomatic) {
  const Robot robot = sdf(
      model_of("<inertial auto='true'><density>500</density></inertial>"
               "<visual name='v'><geometry><box><size>9 9 9</size></box></geometry></visual>"
               "<collision name='c'><density>1000</density><geometry><box><size>1 1 1</size></box>"
               "</geometry></collision><collision name='d'><pose>3 0 0 0 0 0</pose><geometry><box>"
               "<size>2 2 2</size></box></geometry></collision>"));
  EXPECT_TRUE(robot.links.front().is_from_geometry);
  EXPECT_FALSE(robot.links.front().inertial);
  Meshes meshes(robot, {});
  const auto model = LinkGeometry(robot.links.front(), meshes).stated();
  ASSERT_TRUE(model);
  EXPECT_NEAR(*model->mass, 5000, 1e-9);
  EXPECT_NEAR(model->body.centre[0], 2.4, 1e-14);
  EXPECT_NEAR(5000 * model->body.inertia(0, 0), 1000.0 / 6 + 4000 * 4.0 / 6, 1e-9);
}

TEST(Sdf, RefusesWhatItCannotRead) {
  EXPECT_THAT(refusal_of("<model name='m'><link/></model>"),
              HasSubstr("2 robot.sdf:2: link: it has no attribute 'name'"));
  EXPECT_THAT(refusal_of("<model><link/></model>"), HasSubstr("model: it has no attribute 'name'"));
  EXPECT_THAT(refusal_of("<world name='w'/>"), HasSubstr("it has no links"));
  EXPECT_THAT(refusal_of(model_of("<inertial><mass>1,5</mass></inertial>")),
              HasSubstr("robot.sdf:4: mass: its text is '1,5', which is not a number; write 1.5"));
  EXPECT_THAT(refusal_of(model_of("<inertial><mass/></inertial>")),
              HasSubstr("mass: its text has 0 numbers instead of 1"));
  EXPECT_THAT(refusal_of(model_of("<inertial><pose>1 2 3</pose></inertial>")),
              HasSubstr("pose: its text has 3 numbers instead of 6"));
  EXPECT_THAT(refusal_of(model_of("<inertial><pose relative_to='f'/></inertial>")),
              HasSubstr("remove the attribute relative_to"));
  EXPECT_THAT(refusal_of(model_of("<inertial><pose rotation_format='euler'/></inertial>")),
              HasSubstr("SDF has euler_rpy and quat_xyzw"));
  EXPECT_THAT(refusal_of(model_of("<inertial><pose rotation_format='quat_xyzw'>0 0 0 0 0 0 0"
                                  "</pose></inertial>")),
              HasSubstr("its quaternion is zero"));
  EXPECT_THAT(refusal_of(model_of("<visual name='v'/>")),
              HasSubstr("visual: it has no <geometry>"));
  EXPECT_THAT(refusal_of(model_of("<visual name='v'><geometry><box/></geometry></visual>")),
              HasSubstr("box: it has no <size>"));
  EXPECT_THAT(refusal_of(model_of("<visual name='v'><geometry><sphere><radius>nan</radius></sphere>"
                                  "</geometry></visual>")),
              HasSubstr("radius: a length is nan m"));
  EXPECT_THAT(refusal_of(model_of("<visual name='v'><pose>nan 0 0 0 0 0</pose><geometry><sphere>"
                                  "<radius>1</radius></sphere></geometry></visual>")),
              HasSubstr("pose: its position is not finite"));
  EXPECT_THAT(refusal_of(model_of("<visual name='v'><geometry><mesh><uri>a.stl</uri>"
                                  "<scale>1 1 1e300</scale></mesh></geometry></visual>")),
              HasSubstr("scale: its text is 1e+300"));
  EXPECT_THAT(refusal_of(model_of("<collision name='v'><density>-1</density><geometry><sphere>"
                                  "<radius>1</radius></sphere></geometry></collision>")),
              HasSubstr("a density is -1 kg/m^3"));
  EXPECT_THAT(refusal_of("<model name='m'><link name='a'/>\n<link name='a'/></model>"),
              HasSubstr("line 2 has a link of the same name"));
}

}  // namespace
}  // namespace twrench::robot
