#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/exact_many.h>
#include <twrench/motion/polhode.h>
#include <twrench/motion/stability.h>
#include <twrench/motion/trajectory.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "base/enumeration.h"
#include "interruptible.h"
#include "module.h"
#include "motion/phase.h"
#include "motion/visible_error.h"
#include "pickling.h"
#include "scene/limits.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style>;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Array new_array(std::vector<py::ssize_t> shape) { return Array(std::move(shape)); }

std::span<const double> numbers_of(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

std::span<double> numbers_of(Array& array) {
  return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

/// The samples' X and omega as arrays (n, 3, 3) and (n, 3).
std::pair<Array, Array> arrays_of(const std::vector<motion::Sample>& samples) {
  const auto count = static_cast<py::ssize_t>(samples.size());
  Array X = new_array({count, 3, 3}), omega = new_array({count, 3});
  double *X_to = X.mutable_data(), *omega_to = omega.mutable_data();
  for (const motion::Sample& sample : samples) {
    Eigen::Map<RowMajor>{X_to} = sample.X;
    Eigen::Map<Vector3d>{omega_to} = sample.omega;
    X_to += 9;
    omega_to += 3;
  }
  return {X, omega};
}

py::tuple integrate(const motion::FreeBody& body, const std::string& method, double step,
                    double tolerance, std::int64_t max_steps, const Array& times) {
  const std::span<const double> t = numbers_of(times);
  const motion::Method& found = motion::find_method(method);
  const motion::Trajectory result = run_interruptibly([&](const std::atomic<bool>& stop) {
    return motion::integrate(body, found, {step, tolerance, max_steps, &stop}, t);
  });
  const auto later = [](const motion::Sample& a, const motion::Sample& b) {
    return std::abs(a.t) < std::abs(b.t);
  };
  const auto last = std::ranges::max_element(result.samples, later);
  const std::string note =
      last == result.samples.end() ? std::string() : motion::visible_error(body, found, *last);
  const auto [X, omega] = arrays_of(result.samples);
  return py::make_tuple(X, omega, result.steps, result.evaluations, note);
}

/// Calls work(begin, end) for parts of 0 to `count` without Python's global lock, and runs Python's
/// signal handlers between them. Each item costs as much as `samples` samples.
template <typename Work>
void for_parts(std::size_t count, const Work& work, std::size_t samples = 1) {
  const std::size_t part = std::max<std::size_t>((std::size_t{1} << 20U) / (samples + 1), 1);
  for (std::size_t begin = 0; begin < count; begin += part) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const py::gil_scoped_release others_run;
    work(begin, std::min(begin + part, count));
  }
}

py::tuple exact_at(const motion::ExactMotion& motion, const Array& times) {
  const py::ssize_t n = times.size();
  Array X = new_array({n, 3, 3}), omega = new_array({n, 3});
  const std::span<const double> t = numbers_of(times);
  const std::span<double> X_to = numbers_of(X), omega_to = numbers_of(omega);
  for_parts(t.size(), [&](std::size_t begin, std::size_t end) {
    const std::size_t count = end - begin;
    motion.at(t.subspan(begin, count), X_to.subspan(9 * begin, 9 * count),
              omega_to.subspan(3 * begin, 3 * count));
  });
  return py::make_tuple(X, omega);
}

py::tuple exact_many(const Array& inertia, const Array& omega, const Array& times) {
  const py::ssize_t n = omega.shape(0), m = times.size();
  Array X = new_array({n, m, 3, 3}), velocities = new_array({n, m, 3});
  const std::span<const double> moments = numbers_of(inertia), start = numbers_of(omega),
                                t = numbers_of(times);
  const std::span<double> X_to = numbers_of(X), velocities_to = numbers_of(velocities);
  const bool alike = moments.size() == 3;
  for_parts(
      static_cast<std::size_t>(n),
      [&](std::size_t begin, std::size_t end) {
        const std::size_t count = end - begin, samples = count * t.size();
        motion::exact_many({.inertia = alike ? moments : moments.subspan(3 * begin, 3 * count),
                            .omega = start.subspan(3 * begin, 3 * count)},
                           t,
                           {.X = X_to.subspan(9 * begin * t.size(), 9 * samples),
                            .omega = velocities_to.subspan(3 * begin * t.size(), 3 * samples)});
      },
      t.size());
  return py::make_tuple(X, velocities);
}

Array first_flip_times(const Array& inertia, const Array& omega) {
  Array first = new_array({omega.shape(0)});
  const std::span<const double> moments = numbers_of(inertia), start = numbers_of(omega);
  const std::span<double> to = numbers_of(first);
  const bool alike = moments.size() == 3;
  for_parts(to.size(), [&](std::size_t begin, std::size_t end) {
    const std::size_t count = end - begin;
    motion::first_flip_times({.inertia = alike ? moments : moments.subspan(3 * begin, 3 * count),
                              .omega = start.subspan(3 * begin, 3 * count)},
                             to.subspan(begin, count));
  });
  return first;
}

/// The kind and the rate of a rotation about each principal axis.
py::list stability(const Vector3d& moments, double omega) {
  py::list all;
  for (const auto axis : body::PrincipalAxes::all) {
    const motion::Stability found = motion::stability(moments, axis, omega);
    all.append(py::make_tuple(enumerator_name(found.kind), found.rate));
  }
  return all;
}

/// The points of a closed curve at evenly spaced phi from 0 to 2 pi, (n, 3).
template <class Place>
Array points_of(const Place& place) {
  constexpr int last = 240;
  Array points = new_array({last + 1, 3});
  for (int i = 0; i <= last; ++i) {
    Eigen::Map<Vector3d>(points.mutable_data() + 3 * i) = place(2 * std::numbers::pi * i / last);
  }
  return points;
}

/// The curves of constant energy on the unit sphere in principal axes: for each the index of the
/// axis that it circles, and its points.
py::list level_curves(const Vector3d& moments, int count) {
  py::list curves;
  for (const motion::EnergyLevel& level : motion::level_family(moments, count)) {
    const auto place = [&](double phi) { return level.at(phi); };
    curves.append(py::make_tuple(static_cast<int>(level.axis), points_of(place)));
  }
  return curves;
}

/// The two circles of the separatrix; none for a symmetric body.
py::list separatrix_curves(const Vector3d& moments) {
  py::list curves;
  const auto circles = motion::separatrix(moments);
  if (!circles) return curves;
  for (const Vector3d& side : *circles) {
    const auto place = [&](double phi) -> Vector3d {
      return std::cos(phi) * Vector3d::UnitY() + std::sin(phi) * side;
    };
    curves.append(points_of(place));
  }
  return curves;
}

/// The energy, its drift, the orthogonality error and the momentum error, (4, n).
Array diagnose(const motion::FreeBody& body, const Array& X, const Array& omega) {
  const py::ssize_t n = omega.shape(0);
  Array result = new_array({4, n});
  double* const to = result.mutable_data();
  const double* const X_from = X.data();
  const double* const omega_from = omega.data();
  const double initial = motion::energy(body.inertia(), body.omega());
  const auto size = static_cast<std::size_t>(n);
  for_parts(size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const motion::Sample sample{0, Eigen::Map<const RowMajor>(X_from + 9 * i),
                                  Eigen::Map<const Vector3d>(omega_from + 3 * i)};
      const motion::Diagnostics d = motion::diagnose(body, initial, sample);
      to[i] = d.energy;
      to[size + i] = d.energy_drift;
      to[2 * size + i] = d.orthogonality_error;
      to[3 * size + i] = d.momentum_error;
    }
  });
  return result;
}

/// Unit quaternions (x, y, z, w), (n, 4), each with the sign that is nearer to the previous one.
Array quaternions(const Array& X) {
  const py::ssize_t n = X.shape(0);
  Array result = new_array({n, 4});
  double* const to = result.mutable_data();
  const double* const from = X.data();
  Eigen::Vector4d last(0, 0, 0, 1);
  for_parts(static_cast<std::size_t>(n), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Matrix3d attitude = Eigen::Map<const RowMajor>(from + 9 * i);
      Eigen::Vector4d q = Eigen::Quaterniond(attitude).normalized().coeffs();
      if (q.dot(last) < 0) q = -q;
      last = q;
      Eigen::Map<Eigen::Vector4d>(to + 4 * i) = q;
    }
  });
  return result;
}

}  // namespace

void add_dynamics(py::module_& module) {
  py::class_<motion::FreeBody>(module, "FreeBody")
      .def(py::init([](const Matrix3d& inertia, const Vector3d& omega, const Matrix3d& attitude,
                       const Vector3d& wheel, double energy_loss_time) {
        return motion::FreeBody(inertia, omega, attitude, {wheel, energy_loss_time});
      }))
      .def(py::pickle([](const motion::FreeBody& b) -> py::object { return state_of(b); },
                      &free_body_with))
      .def_property_readonly("is_rigid", &motion::FreeBody::is_rigid)
      .def_property_readonly("has_closed_form", &motion::ExactMotion::covers)
      .def_property_readonly("momentum", [](const motion::FreeBody& b) { return b.momentum(); })
      .def("phase", &motion::phase_of, py::call_guard<py::gil_scoped_release>());
  using Flips = motion::ExactMotion::Flips;
  py::class_<Flips>(module, "Flips")
      .def_readonly("interval", &Flips::interval)
      .def_readonly("first", &Flips::first)
      .def_readonly("swing", &Flips::swing)
      .def_property_readonly("turns_over", &Flips::turns_over);
  using Phase = motion::ExactMotion::Phase;
  py::class_<Phase>(module, "Phase")
      .def_readonly("period", &Phase::period)
      .def_readonly("total", &Phase::total)
      .def_readonly("dynamic", &Phase::dynamic);
  py::class_<motion::ExactMotion>(module, "ExactMotion")
      .def(py::init<const motion::FreeBody&>())
      .def("at", &exact_at)
      .def("flip_times",
           [](const motion::ExactMotion& motion, double t_end) {
             const std::vector<double> times = motion.flip_times(t_end);
             return Array(static_cast<py::ssize_t>(times.size()), times.data());
           })
      .def_property_readonly("flips", &motion::ExactMotion::flips)
      .def_property_readonly(
          "kind", [](const motion::ExactMotion& m) { return enumerator_name(m.kind()); });
  module.def("integrate", &integrate);
  module.def("exact_many", &exact_many);
  module.def("first_flip_times", &first_flip_times);
  module.def("level_curves", &level_curves);
  module.def("stability", &stability);
  module.def("stabilizing_wheel", &motion::stabilizing_wheel);
  module.def("separatrix_curves", &separatrix_curves);
  module.def("diagnose", &diagnose);
  module.def("quaternions", &quaternions);
  module.def("rotation", [](const Eigen::Vector4d& quaternion) -> Matrix3d {
    return scene::limits::check_rotation("attitude", quaternion).toRotationMatrix();
  });
}

}  // namespace twrench::python
