#include "solids.h"

#include "scene/dimensions.h"

namespace twrench::python {
namespace {

using Eigen::Vector3d;
using scene::limits::Limit;

/// Sets the dimensions of a shape one after the other.
struct SetDimensions {
  std::vector<double>::const_iterator& next;
  void operator()(const char*, double& value, const Limit&) const { value = *next++; }
  void operator()(const char*, Vector3d& value, const Limit&) const {
    for (double& entry : value) entry = *next++;
  }
};

struct GetDimensions {
  std::vector<double>& to;
  void operator()(const char*, double value, const Limit&) const { to.push_back(value); }
  void operator()(const char*, const Vector3d& value, const Limit&) const {
    to.insert(to.end(), value.begin(), value.end());
  }
};

template <typename Solid>
body::Shape solid_of(const std::vector<double>& dimensions) {
  Solid solid{};
  auto next = dimensions.begin();
  scene::for_dimensions(solid, SetDimensions{next});
  return solid;
}

}  // namespace

body::Shape solid_called(const std::string& name, const std::vector<double>& dimensions) {
  if (name == "cylinder") return solid_of<body::Cylinder>(dimensions);
  if (name == "box") return solid_of<body::Box>(dimensions);
  if (name == "ellipsoid") return solid_of<body::Ellipsoid>(dimensions);
  if (name == "cone") return solid_of<body::Cone>(dimensions);
  if (name == "torus") return solid_of<body::Torus>(dimensions);
  if (name == "capsule") return solid_of<body::Capsule>(dimensions);
  return solid_of<body::Tube>(dimensions);
}

std::vector<double> dimensions_of(const body::Shape& shape) {
  std::vector<double> dimensions;
  std::visit([&](const auto& known) { scene::for_dimensions(known, GetDimensions{dimensions}); },
             shape);
  return dimensions;
}

}  // namespace twrench::python
