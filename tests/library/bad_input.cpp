// Calls the public functions of the installed library with arguments that are empty, not finite,
// out of range or in the wrong order, and expects the error that their headers document. It
// includes only the public headers.
#include <twrench/twrench.h>

#include <array>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace twrench;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array not_finite{nan, infinity, -infinity};
constexpr std::array not_positive{nan, infinity, -infinity, 0.0, -1.0};
constexpr std::array negative{nan, infinity, -infinity, -1.0};

int calls = 0, failures = 0;

void fail(const char* what, const std::string& quantity, const std::string& got) {
  ++failures;
  std::printf("%s: expected an error about '%s', got %s\n", what, quantity.c_str(), got.c_str());
}

/// Expects an InvalidArgument (or an OutOfRange, which derives from it) about `quantity`.
void rejects(const char* what, const std::string& quantity, const std::function<void()>& call) {
  ++calls;
  try {
    call();
    fail(what, quantity, "none");
  } catch (const InvalidArgument& error) {
    if (error.quantity() != quantity) fail(what, quantity, error.what());
  } catch (const std::exception& error) {
    fail(what, quantity, error.what());
  }
}

Vector3d bad_vector(double bad) { return {1, bad, 2}; }

Matrix3d bad_matrix(double bad) {
  Matrix3d matrix = Matrix3d::Identity();
  matrix(1, 2) = bad;
  return matrix;
}

/// Returns a body that tumbles and turns over.
motion::FreeBody body() { return {Vector3d(1, 2, 3).asDiagonal(), {0.01, 1, 0.02}}; }

motion::Sample sample() { return motion::ExactMotion(body()).at(1); }

motion::Sample sample_with(const Matrix3d& X, const Vector3d& omega) { return {1, X, omega}; }

body::TriangleMesh tetrahedron() {
  return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
          .colors = {}};
}

void so3_functions() {
  const so3::AngleFunctions f = so3::angle_functions({1, 2, 3});
  const Vector3d fine(1, 2, 3);
  for (const double bad : not_finite) {
    const Vector3d v = bad_vector(bad);
    rejects("hat", "w", [&] { so3::hat(v); });
    rejects("vee", "Omega", [&] { so3::vee(bad_matrix(bad)); });
    rejects("angle_functions", "u", [&] { so3::angle_functions(v); });
    rejects("exp_times", "u", [&] { so3::exp_times(f, v, fine); });
    rejects("exp_times", "v", [&] { so3::exp_times(f, fine, v); });
    rejects("dexpinv", "u", [&] { so3::dexpinv(f, v, fine); });
    rejects("dexpinv", "omega", [&] { so3::dexpinv(f, fine, v); });
    rejects("exp", "u", [&] { so3::exp(v); });
    rejects("exp", "h", [&] { so3::exp(bad, Matrix3d::Zero()); });
    rejects("exp", "Omega", [&] { so3::exp(1, bad_matrix(bad)); });
    rejects("log", "X", [&] { so3::log(bad_matrix(bad)); });
  }
}

void meshes() {
  body::TriangleMesh index = tetrahedron(), coordinate = tetrahedron(), inside_out = tetrahedron();
  index.triangles[2][1] = 4;
  coordinate.vertices[3].x() = nan;
  std::swap(inside_out.vertices[1], inside_out.vertices[2]);
  for (const body::TriangleMesh& mesh : {index, coordinate}) {
    rejects("surface_area", "mesh", [&] { body::surface_area(mesh); });
    rejects("solid_integrals", "mesh", [&] { body::solid_integrals(mesh); });
    rejects("shell_integrals", "mesh", [&] { body::shell_integrals(mesh, 0.1); });
    rejects("make_mesh", "mesh", [&] { body::make_mesh(mesh); });
    rejects("make_mesh", "mesh", [&] { body::make_mesh(mesh, 0.1); });
  }
  if (body::surface_area({}) != 0) fail("surface_area", "nothing", "an area without triangles");
  rejects("solid_integrals", "mesh", [] { body::solid_integrals({}); });
  rejects("shell_integrals", "mesh", [] { body::shell_integrals({}, 0.1); });
  rejects("solid_integrals", "mesh", [&] { body::solid_integrals(inside_out); });
  for (const double bad : not_positive) {
    rejects("shell_integrals", "thickness", [&] { body::shell_integrals(tetrahedron(), bad); });
  }
  for (const double bad : negative) {
    rejects("make_mesh", "thickness", [&] { body::make_mesh(tetrahedron(), bad); });
  }
}

/// Expects an error from every function of a shape, a part and parts.
void rejects_shape(const std::string& quantity, const body::Shape& shape) {
  rejects("volume", quantity, [&] { body::volume(shape); });
  rejects("centroid", quantity, [&] { body::centroid(shape); });
  rejects("central_inertia", quantity, [&] { body::central_inertia(shape, 1); });
  rejects("bounding_radius", quantity, [&] { body::bounding_radius(shape); });
  rejects("support", quantity, [&] { body::support(shape, {0, 0, 1}); });
  rejects("bounding_box", quantity, [&] { body::bounding_box(shape); });
  const std::array parts{body::Part{shape, 1, Vector3d::Zero(), Matrix3d::Identity()}};
  rejects("mass_properties", quantity, [&] { body::mass_properties(parts); });
  rejects("equimomental_points", quantity, [&] { body::equimomental_points(parts[0]); });
}

void shapes() {
  rejects_shape("mesh", body::Mesh{});
  rejects_shape("mesh", body::Mesh{std::make_shared<const body::TriangleMesh>(), 0, {}});
  for (const double bad : not_positive) {
    rejects_shape("radius", body::Cylinder{bad, 1});
    rejects_shape("length", body::Cylinder{1, bad});
    rejects_shape("size", body::Box{bad_vector(bad)});
    rejects_shape("radii", body::Ellipsoid{bad_vector(bad)});
    rejects_shape("radius", body::Cone{bad, 1});
    rejects_shape("length", body::Cone{1, bad});
    rejects_shape("tube_radius", body::Torus{2, bad});
    rejects_shape("radius", body::Capsule{bad, 1});
    rejects_shape("length", body::Capsule{1, bad});
    rejects_shape("inner_radius", body::Tube{2, bad, 1});
    rejects_shape("length", body::Tube{2, 1, bad});
  }
  for (const double bad : negative) rejects_shape("top_radius", body::Cone{1, 1, bad});
  for (const double bad : not_finite) rejects_shape("radius", body::Torus{bad, 1});
  rejects_shape("tube_radius", body::Torus{1, 1});
  rejects_shape("inner_radius", body::Tube{1, 2, 1});

  const body::Box box{{1, 2, 3}};
  for (const double bad : not_positive) {
    rejects("central_inertia", "mass", [&] { body::central_inertia(box, bad); });
  }
  for (const double bad : not_finite) {
    rejects("bounding_radius", "centre", [&] { body::bounding_radius(box, bad_vector(bad)); });
    rejects("support", "direction", [&] { body::support(box, bad_vector(bad)); });
    rejects("frame_with_z_along", "axis", [&] { body::frame_with_z_along(bad_vector(bad)); });
  }
  rejects("support", "direction", [&] { body::support(box, Vector3d::Zero()); });
  rejects("frame_with_z_along", "axis", [] { body::frame_with_z_along(Vector3d::Zero()); });
}

/// Expects an error from every function of a part.
void rejects_part(const std::string& quantity, const body::Part& part) {
  rejects("mass_properties", quantity, [&] { body::mass_properties({&part, 1}); });
  rejects("equimomental_points", quantity, [&] { body::equimomental_points(part); });
}

void bodies() {
  rejects("mass_properties", "parts", [] { body::mass_properties({}); });
  const body::Part box{body::Box{{1, 2, 3}}, 1, Vector3d::Zero(), Matrix3d::Identity()};
  body::Part part = box;
  for (const double bad : not_positive) part.density = bad, rejects_part("density", part);
  part = box;
  for (const double bad : not_finite) part.position.y() = bad, rejects_part("position", part);
  part = box;
  for (const double bad : {nan, infinity, 0.0, -1.0}) {
    part.body_from_part(0, 0) = bad;
    rejects_part("body_from_part", part);
  }
  part = box;
  part.density = 1e300;
  part.position = {1e10, 0, 0};
  rejects("mass_properties", "parts", [&] { body::mass_properties(std::array{part, box}); });

  for (const double bad : not_finite) {
    rejects("principal_axes", "inertia", [&] { body::principal_axes(bad_matrix(bad)); });
    rejects("equimomental_box", "inertia", [&] { body::equimomental_box(bad_matrix(bad)); });
    rejects("FreeBody", "inertia", [&] { motion::FreeBody(bad_matrix(bad), {1, 2, 3}); });
    rejects("FreeBody", "omega", [&] { motion::FreeBody(Matrix3d::Identity(), bad_vector(bad)); });
  }
  rejects("principal_axes", "inertia", [] { body::principal_axes(bad_matrix(0.1)); });
  rejects("FreeBody", "inertia", [] { motion::FreeBody(bad_matrix(0.1), {1, 2, 3}); });
  const Matrix3d flat = Vector3d(1, 1, 0).asDiagonal();
  rejects("equimomental_box", "moments", [&] { body::equimomental_box(flat); });
  rejects("equimomental_ellipsoid", "moments", [&] { body::equimomental_ellipsoid(flat); });
  rejects("equimomental_cross", "moments", [&] { body::equimomental_cross(flat); });
  rejects("FreeBody", "inertia", [&] { motion::FreeBody(flat, {1, 2, 3}); });
  const Matrix3d unit = Matrix3d::Identity();
  rejects("FreeBody", "omega", [&] { motion::FreeBody(unit, {1e200, 0, 0}); });
  rejects("FreeBody", "inertia", [&] { motion::FreeBody(1e-320 * unit, {1, 0, 0}); });
}

void exact_motions() {
  const motion::ExactMotion exact(body());
  std::vector<double> X(18), omega(6);
  for (const double bad : not_finite) {
    const std::vector<double> times{0, bad};
    rejects("ExactMotion::at", "t", [&] { exact.at(bad); });
    rejects("ExactMotion::at", "times[1]", [&] { exact.at(times); });
    rejects("ExactMotion::at", "times[1]", [&] { exact.at(times, X, omega); });
    rejects("flip_times", "t_end", [&] { exact.flip_times(bad); });
    rejects("exact_step", "t", [&] { motion::exact_step(body(), bad); });
    const Vector3d spin = bad_vector(bad);
    rejects("FreeBody::with_omega", "omega", [&] { body().with_omega(spin); });
    rejects("FreeBody::with_start", "omega",
            [&] { body().with_start(spin, Matrix3d::Identity()); });
    rejects("FreeBody::with_start", "attitude", [&] {
      body().with_start({1, 2, 3}, bad_matrix(bad));
    });
    rejects("Sample::quaternion", "X", [&] {
      sample_with(bad_matrix(bad), {1, 2, 3}).quaternion();
    });
  }
  const std::vector<double> times{0, 1}, wrong(5);
  std::vector<double> short_array(5);
  rejects("ExactMotion::at", "X", [&] { exact.at(times, short_array, omega); });
  rejects("ExactMotion::at", "omega", [&] { exact.at(times, X, short_array); });
  rejects("attitude_at", "index", [&] { motion::attitude_at(X, 2); });
  rejects("attitude_at", "index", [] { motion::attitude_at({}, 0); });
  const Matrix3d reflection = -Matrix3d::Identity(), unit = Matrix3d::Identity();
  for (const Matrix3d& attitude : {reflection, Matrix3d(2 * unit), Matrix3d(bad_matrix(0.1))}) {
    rejects("FreeBody", "attitude", [&] { motion::FreeBody(unit, {1, 2, 3}, attitude); });
  }
  ++calls;
  try {
    exact.flip_times(1e300);
    fail("flip_times", "flips", "none");
  } catch (const motion::MotionError& error) {
    if (error.reason() != motion::MotionError::Reason::too_many_flips) {
      fail("flip_times", "flips", error.what());
    }
  }
  if (!exact.flip_times(-1).empty()) fail("flip_times", "nothing", "flips before the start");

  const std::vector<double> moments{1, 2, 3}, spin{1, 2, 3};
  for (const double bad : not_positive) {
    const std::vector<double> inertia{1, bad, 3};
    rejects("exact_many", "inertia[0, 1]", [&] {
      motion::exact_many({inertia, spin}, times, {X, omega});
    });
    rejects("first_flip_times", "inertia[0, 1]", [&] {
      motion::first_flip_times({inertia, spin}, {short_array.data(), 1});
    });
  }
  for (const double bad : not_finite) {
    const std::vector<double> bad_spin{1, bad, 3}, bad_times{0, bad};
    rejects("exact_many", "omega[0, 1]", [&] {
      motion::exact_many({moments, bad_spin}, times, {X, omega});
    });
    rejects("exact_many", "times[1]", [&] {
      motion::exact_many({moments, spin}, bad_times, {X, omega});
    });
  }
  rejects("exact_many", "inertia", [&] { motion::exact_many({wrong, spin}, times, {X, omega}); });
  rejects("exact_many", "omega", [&] { motion::exact_many({moments, wrong}, times, {X, omega}); });
  rejects("exact_many", "samples.X", [&] {
    motion::exact_many({moments, spin}, times, {short_array, omega});
  });
  rejects("exact_many", "samples.omega", [&] {
    motion::exact_many({moments, spin}, times, {X, short_array});
  });
  rejects("first_flip_times", "first", [&] {
    motion::first_flip_times({moments, spin}, short_array);
  });
}

void polhodes() {
  const Vector3d moments(1, 2, 3), mu(0.6, 0, 0.8);
  for (const Vector3d& bad : {Vector3d(3, 2, 1), Vector3d(1, 3, 2), Vector3d(1, nan, 3),
                              Vector3d(0, 2, 3), Vector3d(-1, 2, 3), Vector3d(1, 2, infinity)}) {
    rejects("level_through", "moments", [&] { motion::level_through(bad, mu); });
    rejects("level_family", "moments", [&] { motion::level_family(bad, 3); });
    rejects("separatrix", "moments", [&] { motion::separatrix(bad); });
  }
  for (const double bad : not_finite) {
    rejects("level_through", "mu", [&] { motion::level_through(moments, bad_vector(bad)); });
  }
  for (const Vector3d& bad : {Vector3d(0, 0, 0), Vector3d(2, 0, 0)}) {
    rejects("level_through", "mu", [&] { motion::level_through(moments, bad); });
  }
  rejects("level_family", "count", [&] { motion::level_family(moments, -1); });

  const motion::EnergyLevel level = *motion::level_through(moments, mu);
  const auto rejects_level = [](const char* quantity, const motion::EnergyLevel& bad) {
    rejects("EnergyLevel::at", quantity, [&] { bad.at(1); });
    rejects("EnergyLevel::is_separatrix", quantity, [&] { bad.is_separatrix(); });
    rejects("herpolhode_annulus", quantity, [&] { motion::herpolhode_annulus(bad); });
  };
  rejects_level("moments", {{3, 2, 1}, level.energy, level.axis, level.side});
  rejects_level("moments", {{2, 2, 2}, level.energy, level.axis, level.side});
  for (const int bad : {-1, 1, 3}) {
    const auto axis = static_cast<body::PrincipalAxes::Axis>(bad);
    rejects_level("axis", {moments, level.energy, axis, level.side});
  }
  for (const double bad : {0.0, nan}) {
    rejects_level("side", {moments, level.energy, level.axis, bad});
    rejects_level("energy", {moments, bad, level.axis, level.side});
  }
  for (const double bad : not_finite) {
    rejects("EnergyLevel::at", "phi", [&] { level.at(bad); });
  }
}

void stabilities() {
  const Vector3d moments(1, 2, 3);
  constexpr auto axis = body::PrincipalAxes::least;
  for (const double bad : not_positive) {
    rejects("stability", "moments", [&] { motion::stability(bad_vector(bad), axis, 1); });
  }
  rejects("stability", "moments", [&] { motion::stability({3, 2, 1}, axis, 1); });
  rejects("stabilizing_wheel", "moments", [] { motion::stabilizing_wheel({3, 2, 1}, 1); });
  for (const int bad : {-1, 3}) {
    rejects("stability", "axis",
            [&] { motion::stability(moments, static_cast<body::PrincipalAxes::Axis>(bad), 1); });
  }
  const motion::Tilt tilt(body());
  for (const double bad : not_finite) {
    rejects("stability", "omega", [&] { motion::stability(moments, axis, bad); });
    rejects("stabilizing_wheel", "omega", [&] { motion::stabilizing_wheel(moments, bad); });
    const motion::Sample wrong = sample_with(Matrix3d::Identity(), bad_vector(bad));
    rejects("Tilt::of", "omega", [&] { tilt.of(wrong); });
    rejects("Tilt::direction", "omega", [&] { tilt.direction(wrong); });
  }
}

void interiors() {
  const Matrix3d inertia = Vector3d(1, 2, 3).asDiagonal(), attitude = Matrix3d::Identity();
  const motion::FreeBody wheeled(inertia, {0, 0, 1}, attitude, {.wheel = {0, 0, 1}});
  for (const double bad : not_finite) {
    rejects("FreeBody", "wheel", [&] {
      motion::FreeBody(inertia, {0, 0, 1}, attitude, {.wheel = bad_vector(bad)});
    });
    rejects("FreeBody::rigid_velocity", "m", [&] { wheeled.rigid_velocity(bad_vector(bad)); });
    rejects("FreeBody::turning_rate", "m", [&] { wheeled.turning_rate(bad_vector(bad)); });
    rejects("FreeBody::energy", "m", [&] { wheeled.energy(bad_vector(bad)); });
  }
  rejects("FreeBody", "wheel", [&] {
    motion::FreeBody(inertia, {0, 0, 1}, attitude, {.wheel = {0, 0, 1e200}});
  });
  for (const double bad : {0.0, -1.0, nan, 1e-3}) {
    rejects("FreeBody", "energy_loss_time", [&] {
      motion::FreeBody(inertia, {0, 0, 1}, attitude, {.energy_loss_time = bad});
    });
  }
  rejects("FreeBody", "energy_loss_time", [&] {
    motion::FreeBody(attitude, {0, 0, 1}, attitude, {.energy_loss_time = 10});
  });
  const motion::FreeBody unknown = wheeled.with_omega({1, 0, 0});
  rejects("ExactMotion::covers", "method exact", [&] {
    if (!motion::ExactMotion::covers(unknown)) motion::ExactMotion{unknown};
  });
}

void frames() {
  const motion::Sample fine = sample();
  const motion::FrameForces forces(motion::body_frame(body(), fine), body(), fine);
  for (const double bad : not_finite) {
    const motion::Sample wrong_X = sample_with(bad_matrix(bad), fine.omega);
    const motion::Sample wrong_omega = sample_with(fine.X, bad_vector(bad));
    rejects("angular_acceleration", "omega",
            [&] { motion::angular_acceleration(body(), wrong_omega); });
    rejects("angular_acceleration", "X", [&] { motion::angular_acceleration(body(), wrong_X); });
    rejects("body_frame", "X", [&] { motion::body_frame(body(), wrong_X); });
    rejects("body_frame", "omega", [&] { motion::body_frame(body(), wrong_omega); });
    rejects("steady_frame", "t", [&] { motion::steady_frame(body(), bad); });
    rejects("FrameForces", "attitude",
            [&] { motion::FrameForces({.attitude = bad_matrix(bad)}, body(), fine); });
    rejects("FrameForces", "omega",
            [&] { motion::FrameForces({.omega = bad_vector(bad)}, body(), fine); });
    rejects("FrameForces", "alpha",
            [&] { motion::FrameForces({.alpha = bad_vector(bad)}, body(), fine); });
    rejects("FrameForces", "X", [&] { motion::FrameForces({}, body(), wrong_X); });
    rejects("FrameForces::on", "position", [&] { forces.on(1, bad_vector(bad)); });
    rejects("energy", "inertia", [&] { motion::energy(bad_matrix(bad), fine.omega); });
    rejects("energy", "omega", [&] { motion::energy(body().inertia(), bad_vector(bad)); });
    rejects("diagnose", "X", [&] { motion::diagnose(body(), 1, wrong_X); });
    rejects("diagnose", "omega", [&] { motion::diagnose(body(), 1, wrong_omega); });
  }
  for (const double bad : negative) {
    rejects("FrameForces::on", "mass", [&] { forces.on(bad, {1, 2, 3}); });
    rejects("diagnose", "initial_energy", [&] { motion::diagnose(body(), bad, fine); });
  }
}

void methods() {
  for (const char* name : {"", "rkmk5", "EXACT"}) {
    rejects("find_method", "method", [&] { motion::find_method(name); });
  }
  const auto no_step = [](const motion::AcceptedStep&) {};
  const auto no_sample = [](const motion::Sample&) {};
  for (const motion::Method& method : motion::methods()) {
    const auto integrate = [&](const motion::StepControl& control, double t) {
      motion::integrate(body(), method, control, std::array{0.0, t});
      motion::make_propagator(body(), method, control)->sample_at(t);
    };
    for (const double bad : not_positive) {
      rejects("step", "step", [&] { integrate({.step = bad}, 1); });
    }
    rejects("max_steps", "max_steps", [&] { integrate({.max_steps = 0}, 1); });
    if (method.adaptive()) {
      for (const double bad : {nan, infinity, 0.0, -1.0, 1e-16}) {
        rejects("tolerance", "tolerance", [&] { integrate({.tolerance = bad}, 1); });
      }
    }
    const auto propagator = motion::make_propagator(body(), method, {});
    for (const double bad : not_finite) {
      rejects("integrate", "time", [&] { integrate({}, bad); });
      rejects("sample_at", "t", [&] { propagator->sample_at(bad); });
      rejects("samples_at", "t", [&] { propagator->samples_at(std::array{bad}); });
      rejects("take_step", "X", [&] { motion::take_step(body(), method, bad_matrix(bad), 0.1); });
      rejects("take_step", "h",
              [&] { motion::take_step(body(), method, Matrix3d::Identity(), bad); });
      rejects("angular_velocity", "X",
              [&] { motion::angular_velocity(body(), method, bad_matrix(bad)); });
    }
    for (const double bad : negative) {
      rejects("visit_steps", "t_end",
              [&] { motion::visit_steps(body(), method, {}, bad, no_step); });
      rejects("visit_samples", "time", [&] {
        motion::visit_samples(
            body(), method, {}, 1, [&](std::size_t) { return bad; }, no_sample);
      });
    }
    rejects("visit_samples", "time", [&] {
      motion::visit_samples(
          body(), method, {}, 2, [](std::size_t i) { return i == 0 ? 1.0 : 0.999; }, no_sample);
    });
    rejects("visit_samples", "time",
            [&] { motion::visit_samples(body(), method, {}, 1, {}, no_sample); });
    rejects("visit_samples", "visit", [&] {
      motion::visit_samples(body(), method, {}, 1, [](std::size_t) { return 1.0; }, {});
    });
    rejects("visit_steps", "visit", [&] { motion::visit_steps(body(), method, {}, 1, {}); });
  }
}

/// FlipSearch and EstimateCheck copy their arguments, which are temporary objects here.
void studies() {
  const Matrix3d unit = Matrix3d::Identity();
  const motion::AcceptedStep fine{0, 0.1, unit, unit, 1e-9};
  study::FlipSearch search(body(), motion::Method(motion::find_method("rkmk4")));
  study::EstimateCheck check(body());
  search.visit(fine);
  check.visit(fine);
  rejects("FlipSearch", "t", [&] { search.visit(fine); });
  const auto with = [&](auto member, auto value) {
    motion::AcceptedStep step = fine;
    step.t = 0.1;
    step.*member = value;
    return step;
  };
  using motion::AcceptedStep;
  for (const double bad : not_positive) {
    rejects("FlipSearch", "length", [&] { search.visit(with(&AcceptedStep::length, bad)); });
  }
  for (const double bad : not_finite) {
    rejects("FlipSearch", "t", [&] { search.visit(with(&AcceptedStep::t, bad)); });
    rejects("FlipSearch", "X", [&] { search.visit(with(&AcceptedStep::before, bad_matrix(bad))); });
    rejects("FlipSearch", "X", [&] { search.visit(with(&AcceptedStep::after, bad_matrix(bad))); });
    rejects("EstimateCheck", "X",
            [&] { check.visit(with(&AcceptedStep::before, bad_matrix(bad))); });
    rejects("local_error", "h",
            [&] { study::local_error(body(), with(&AcceptedStep::length, bad)); });
    rejects("local_error", "after",
            [&] { study::local_error(body(), with(&AcceptedStep::after, bad_matrix(bad))); });
  }
  for (const double bad : negative) {
    rejects("EstimateCheck", "error", [&] { check.visit(with(&AcceptedStep::error, bad)); });
  }

  study::StudyPlan plan;
  plan.methods = {&motion::find_method("rkmk4"), &motion::find_method("rkmk45")};
  plan.steps = {0.1};
  plan.tolerances = {1e-6};
  plan.duration = 1;
  const auto rejects_plan = [&](const char* quantity, auto change) {
    study::StudyPlan bad = plan;
    change(bad);
    rejects("run_study", quantity, [&] { study::run_study(body(), bad); });
  };
  for (const double bad : not_positive) {
    rejects_plan("duration", [&](study::StudyPlan& p) { p.duration = bad; });
    rejects_plan("step", [&](study::StudyPlan& p) { p.steps = {0.1, bad}; });
    rejects_plan("step", [&](study::StudyPlan& p) { p.first_step = bad; });
    rejects_plan("tolerance", [&](study::StudyPlan& p) { p.tolerances = {bad}; });
  }
  rejects_plan("max_steps", [](study::StudyPlan& p) { p.max_steps = 0; });
  rejects_plan("steps", [](study::StudyPlan& p) { p.steps = {}; });
  rejects_plan("tolerances", [](study::StudyPlan& p) { p.tolerances = {}; });
  rejects_plan("methods", [](study::StudyPlan& p) { p.methods.push_back(nullptr); });
}

}  // namespace

int main() {
  so3_functions();
  meshes();
  shapes();
  bodies();
  exact_motions();
  polhodes();
  stabilities();
  interiors();
  frames();
  methods();
  studies();
  std::printf("%d calls, %d without the documented error\n", calls, failures);
  return failures == 0 ? 0 : 1;
}
