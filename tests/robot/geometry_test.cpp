#include "robot/geometry.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

#include "robot/diagnosis.h"
#include "robot/samples.h"

namespace twrench::robot {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// The surface of a solid as the limit of the solid minus a slightly smaller one, per area.
Vector3d wall_by_difference(const std::function<body::Shape(double grown)>& shape) {
  constexpr double h = 1e-6;
  const auto moments = [](const body::Shape& s) {
    return Vector3d(body::central_inertia(s, body::volume(s)).diagonal());
  };
  return (moments(shape(h)) - moments(shape(-h))) / (2 * h);
}

TEST(Walls, AreTheLimitOfHollowBodies) {
  const auto box = [](double h) {
    return body::Box{Vector3d(1, 2, 3) + Vector3d::Constant(2 * h)};
  };
  const auto ball = [](double h) { return body::Ellipsoid{Vector3d::Constant(2 + h)}; };
  const auto cylinder = [](double h) { return body::Cylinder{0.5 + h, 3 + 2 * h}; };
  const auto capsule = [](double h) { return body::Capsule{0.5 + h, 3}; };
  const std::vector<std::function<body::Shape(double)>> shapes{box, ball, cylinder, capsule};
  for (const auto& shape : shapes) {
    const body::SolidIntegrals wall = *wall_integrals(shape(0));
    const Vector3d expected = wall_by_difference(shape);
    EXPECT_TRUE(Vector3d(wall.inertia.diagonal()).isApprox(expected, 1e-8))
        << wall.inertia.diagonal().transpose() << " but " << expected.transpose();
    constexpr double h = 1e-6;
    EXPECT_NEAR(wall.volume, (body::volume(shape(h)) - body::volume(shape(-h))) / (2 * h), 1e-7);
  }
  EXPECT_FALSE(wall_integrals(body::Torus{2, 1}));
}

LinkGeometry geometry_of(const Robot& robot) {
  Meshes meshes(robot, {});
  return LinkGeometry(robot.links.front(), meshes);
}

TEST(LinkGeometry, MeasuresTheDistanceToItsConvexHull) {
  const RobotFile file(
      "<robot name='r'><link name='a'>"
      "<visual><origin xyz='1 0 0'/><geometry><sphere radius='0.5'/></geometry></visual>"
      "<visual><origin xyz='-1 0 0'/><geometry><box size='1 1 1'/></geometry></visual>"
      "</link></robot>");
  const Robot robot = file.read();
  const LinkGeometry geometry = geometry_of(robot);
  EXPECT_EQ(geometry.distance_outside(Vector3d::Zero()), 0);  // between the two
  EXPECT_EQ(geometry.distance_outside({1.2, 0.2, 0.1}), 0);
  EXPECT_NEAR(geometry.distance_outside({3, 0, 0}), 1.5, 1e-6);
  EXPECT_NEAR(geometry.distance_outside({-1, 0, 2}), 1.5, 1e-3);
  EXPECT_NEAR(geometry.extent(Vector3d::UnitX()), 1.5, 1e-15);
  EXPECT_NEAR(geometry.extent(-Vector3d::UnitX()), 1.5, 1e-15);
}

TEST(LinkGeometry, FindsMeshesOfPackages) {
  const RobotFile file(
      "<robot name='r'><link name='a'>"
      "<visual><geometry><mesh filename='package://pack/meshes/t.obj' scale='2 2 -2'/></geometry>"
      "</visual></link></robot>");
  std::filesystem::create_directories(file.folder() / "pack/meshes");
  std::ofstream(file.folder() / "pack/meshes/t.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const Robot robot = file.read();
  const LinkGeometry geometry = geometry_of(robot);
  EXPECT_THAT(geometry.problems(), SizeIs(0));
  ASSERT_THAT(geometry.models(), SizeIs(2));
  // A tetrahedron of the edges 2 m, mirrored.
  EXPECT_NEAR(*geometry.models()[0].volume, 8.0 / 6, 1e-14);
  EXPECT_TRUE(geometry.models()[0].body.centre.isApprox(Vector3d(0.5, 0.5, -0.5), 1e-14));
}

// CAD programs write -4e-18 beside 0.
TEST(LinkGeometry, ClosesMeshesThatRoundingOpened) {
  for (const char* noise : {"1e-18", "1e-4"}) {
    for (const char* scale : {"1 1 1", "0.001 0.001 -0.001"}) {
      const RobotFile file(
          fmt::format("<robot name='r'><link name='a'><visual><geometry>"
                      "<mesh filename='t.obj' scale='{0}'/></geometry></visual>"
                      "<collision><geometry><mesh filename='t.obj' scale='{0}'/>"
                      "</geometry></collision></link></robot>",
                      scale));
      std::ofstream(file.folder() / "t.obj")
          << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv " << noise << " 0 0\n"
          << "f 1 3 2\nf 5 2 4\nf 2 3 4\nf 1 4 3\n";
      const Robot robot = file.read();
      const LinkGeometry geometry = geometry_of(robot);
      const bool is_rounding = noise == std::string("1e-18");
      EXPECT_EQ(geometry.models().front().volume.has_value(), is_rounding) << noise;
      // Once, though both geometries are this mesh.
      EXPECT_THAT(geometry.problems(), SizeIs(is_rounding ? 0 : 1)) << noise;
    }
  }
}

TEST(LinkGeometry, SaysWhereAMeshIsLookedFor) {
  const auto note = [](const std::string& uri) {
    const RobotFile file("<robot name='r'><link name='a'><visual><geometry><mesh filename='" + uri +
                         "'/></geometry></visual></link></robot>");
    const JudgedRobot judged = judge_robot(file.read(), {});
    EXPECT_THAT(judged.notes, SizeIs(1));
    return judged.notes.front();
  };
  EXPECT_THAT(note("package://a/b.stl"), HasSubstr("the folder that contains the packages"));
  EXPECT_THAT(note("meshes/b.stl"), HasSubstr("a mesh was not found: 'meshes/b.stl'; paths are "
                                              "relative to the folder"));
}

// The factors of the description multiply the unit of the file, here the millimetre.
TEST(LinkGeometry, TakesTheUnitOfAColladaMeshFromTheFile) {
  const RobotFile file(
      "<robot name='r'><link name='a'>"
      "<visual><geometry><mesh filename='t.dae' scale='2 2 2'/></geometry></visual>"
      "<collision><geometry><mesh filename='t.dae' scale='2 2 -2'/></geometry></collision>"
      "</link></robot>");
  std::ofstream(file.folder() / "t.dae")
      << "<?xml version='1.0'?><COLLADA version='1.4.1'><asset><unit meter='0.001'/></asset>"
         "<library_geometries><geometry id='g'><mesh>"
         "<source id='s'><float_array id='n'>0 0 0 500 0 0 0 500 0 0 0 500</float_array>"
         "<technique_common><accessor source='#n' count='4' stride='3'/></technique_common>"
         "</source><vertices id='v'><input semantic='POSITION' source='#s'/></vertices>"
         "<triangles><input semantic='VERTEX' source='#v' offset='0'/>"
         "<p>0 2 1 0 1 3 1 2 3 0 3 2</p></triangles></mesh></geometry></library_geometries>"
         "<library_visual_scenes><visual_scene id='w'><node><instance_geometry url='#g'/></node>"
         "</visual_scene></library_visual_scenes>"
         "<scene><instance_visual_scene url='#w'/></scene></COLLADA>";
  const Robot robot = file.read();
  const LinkGeometry geometry = geometry_of(robot);
  EXPECT_THAT(geometry.problems(), SizeIs(0));
  // Tetrahedra of the edges 1 m, the second one mirrored.
  ASSERT_GE(geometry.models().size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_NEAR(*geometry.models()[i].volume, 1.0 / 6, 1e-15);
    EXPECT_TRUE(geometry.models()[i].body.centre.isApprox(
        Vector3d(0.25, 0.25, i == 0 ? 0.25 : -0.25), 1e-14));
  }
}

TEST(LinkGeometry, IsNotKnownWithoutItsMesh) {
  const RobotFile file(
      "<robot name='r'><link name='a'>"
      "<visual><geometry><mesh filename='package://pack/t.stl'/></geometry></visual>"
      "<collision><geometry><box size='1 1 1'/></geometry></collision></link></robot>");
  const Robot robot = file.read();
  const LinkGeometry geometry = geometry_of(robot);
  EXPECT_FALSE(geometry.is_known());
  EXPECT_EQ(geometry.models().front().source, "its collision geometry");
}

// One line for all, and not one for each.
TEST(JudgedRobot, NamesTheFirstMeshesThatAreMissing) {
  std::string links;
  for (int i = 0; i < 60; ++i) {
    const std::string mesh = fmt::format("<geometry><mesh filename='{}/{:02}.stl'/></geometry>",
                                         i < 58 ? "package://p" : "m", i);
    links += fmt::format("<link name='{}'><visual>{}</visual><collision>{}</collision></link>", i,
                         mesh, mesh);
  }
  const RobotFile file("<robot name='r'>" + links + "</robot>");
  EXPECT_THAT(judge_robot(file.read(), {}).notes,
              ElementsAre(HasSubstr("58 meshes were not found: 'package://p/00.stl', "
                                    "'package://p/01.stl', 'package://p/02.stl' and 55 others; "
                                    "name the folder that contains the packages"),
                          HasSubstr("2 meshes were not found: 'm/58.stl' and 'm/59.stl'; paths")));
}

TEST(JudgedRobot, NamesEachProblemOfAMeshOnce) {
  std::string links;
  for (int i = 0; i < 10; ++i) {
    links += fmt::format(
        "<link name='{}'><visual><geometry><mesh filename='{}.stl'/></geometry>"
        "</visual></link>",
        i, i < 4 ? 0 : i);
  }
  const RobotFile file("<robot name='r'>" + links + "</robot>");
  for (int i = 0; i < 10; ++i) std::ofstream(file.folder() / fmt::format("{}.stl", i)) << "x";
  const auto notes = judge_robot(file.read(), {}).notes;
  ASSERT_THAT(notes, SizeIs(6));
  EXPECT_THAT(notes[0], HasSubstr("robot.urdf:1: links '0', '1', '2' and 1 other: cannot read"));
  EXPECT_THAT(notes[1], HasSubstr("robot.urdf:1: link '4': cannot read"));
  EXPECT_THAT(notes[5], HasSubstr("robot.urdf: 2 other meshes are not used as solids"));
}

}  // namespace
}  // namespace twrench::robot
