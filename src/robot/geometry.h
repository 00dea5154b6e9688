#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robot/robot.h"

namespace twrench::robot {

/// The mass properties of a homogeneous body, for a mass of 1 kg.
struct UnitBody {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< In m, in the frame of the link.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< About it in m^2, in the link's axes.
};

/// The distribution of mass that the geometries of a link suggest.
struct MassModel {
  /// The source in messages: "its visual geometry", "the surface of its collision geometry".
  std::string source;
  UnitBody body;
  /// Volume in m^3; nothing for a surface.
  std::optional<double> volume = {};
  /// Mass in kg, if the file states masses or densities of the geometries.
  std::optional<double> mass = {};
};

/// Returns the integrals over the surface of a shape, closed at its ends, in cm and for 1 g/cm^2;
/// `volume` is its area. Nothing for shapes other than boxes, balls, cylinders and capsules.
std::optional<body::SolidIntegrals> wall_integrals(const body::Shape& shape);

/// Finds and reads the meshes of a robot, each once.
class Meshes {
 public:
  /// `packages` are folders in which packages and models are looked for, before those that contain
  /// the robot's file.
  Meshes(const Robot& robot, std::vector<std::filesystem::path> packages)
      : robot_(robot), packages_(std::move(packages)) {}

  /// A mesh in the frame of its geometry, in cm.
  struct Loaded {
    /// The solid; nothing if the surface does not bound one.
    std::optional<body::Mesh> solid = {};
    /// The wall along its surface; nothing if it could not be read.
    std::optional<body::Mesh> wall = {};
    /// Why there is no solid, or the file could not be read; may be empty, as for a file that was
    /// not found.
    std::string problem = {};
  };

  const Loaded& load(const MeshReference& reference);

  /// Returns the files that were read.
  const std::vector<std::filesystem::path>& files() const { return files_; }

  /// Returns the meshes that were not found, as they were given.
  const std::set<std::string>& missing() const { return missing_; }

  /// Returns the file of a mesh; nothing if there is none.
  std::optional<std::filesystem::path> find(const std::string& uri) const;

 private:
  const Robot& robot_;
  std::vector<std::filesystem::path> packages_;
  std::map<std::string, Loaded> loaded_;  ///< By file and scale.
  std::vector<std::filesystem::path> files_;
  std::set<std::string> missing_;
};

/// Returns whether a mesh is in a package or a model, which is looked for in several folders.
bool is_in_package(const std::string& uri);

/// The geometries of a link with their meshes.
class LinkGeometry {
 public:
  LinkGeometry(const Link& link, Meshes& meshes);

  /// Returns the models of its mass, the most likely ones first. The visual and the collision
  /// geometry each give a solid and a surface, as far as they can be read.
  const std::vector<MassModel>& models() const { return models_; }

  /// Returns the mass properties of the collision geometries with the masses or densities that the
  /// file states, each a solid or a surface as it states, and its mass in kg; nothing if they
  /// cannot be computed or have no mass.
  std::optional<MassModel> stated() const { return model_of(Geometry::Use::collision, {}); }

  /// Returns why geometries could not be read or bound no solid, one line each.
  const std::vector<std::string>& problems() const { return problems_; }

  /// Returns whether there are geometries, and all are known.
  bool is_known() const { return is_known_; }

  /// Returns the greatest coordinate in m along a unit vector, in the frame of the link.
  double extent(const Eigen::Vector3d& direction) const;

  /// Returns the distance in m from a point to the convex hull of all geometries; 0 inside.
  double distance_outside(const Eigen::Vector3d& point) const;

  /// Returns the solids to draw, in the frame of the link, in cm: the visual geometry, or else the
  /// collision geometry.
  std::vector<body::Part> parts() const;

 private:
  struct Placed {
    Geometry::Use use;
    std::optional<body::Shape> solid, surface;
    Eigen::Isometry3d link_from_geometry;
    std::optional<double> mass, density;
    bool is_shell;
  };

  void add(const Geometry& geometry, Meshes& meshes);
  /// All as surfaces or all as solids or, if this is not given, each as the file states.
  std::optional<MassModel> model_of(Geometry::Use use, std::optional<bool> all_surfaces) const;
  Eigen::Vector3d farthest(const Eigen::Vector3d& direction) const;

  std::vector<Placed> placed_;
  std::vector<MassModel> models_;
  std::vector<std::string> problems_;
  bool is_known_ = true;
};

}  // namespace twrench::robot
