#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "base/enumeration.h"
#include "check/report/checked_file.h"
#include "check/report/choice.h"
#include "check/report/report.h"
#include "comparison/comparison.h"
#include "comparison/report.h"
#include "errors.h"
#include "interruptible.h"
#include "module.h"
#include "output.h"
#include "plot/plots.h"
#include "recording/conventions/convention.h"
#include "replay/replay.h"
#include "scene/interior.h"
#include "scene/limits.h"
#include "scene/natural_times.h"
#include "scene/recording_table.h"
#include "system/file.h"
#include "table/reader.h"

namespace twrench::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// The values of the fields of a convention that the caller gives, by their names.
using Given = std::map<std::string, std::variant<bool, std::string, Eigen::Vector4d>>;

recording::Convention convention_of(const Given& given) {
  recording::Convention convention;
  for (const recording::Field& field : recording::convention_fields()) {
    const auto found = given.find(field.name);
    if (found == given.end()) continue;
    if (const auto* flag = std::get_if<bool>(&found->second)) {
      field.set(convention, *flag);
    } else if (const auto* text = std::get_if<std::string>(&found->second)) {
      field.set(convention, *text);
    } else {
      const auto& numbers = std::get<Eigen::Vector4d>(found->second);
      field.set(convention, scene::limits::check_rotation(field.name, numbers));
    }
  }
  return convention;
}

check::Bounds bounds_of(const std::map<std::string, double>& given) {
  const auto bound = [&](const char* name) {
    const auto found = given.find(name);
    return found == given.end() ? std::nullopt
                                : std::optional(scene::limits::check({0.0, scene::limits::huge},
                                                                     name, found->second));
  };
  return {.attitude_error = bound("max_attitude_error"),
          .rate_error = bound("max_rate_error"),
          .energy_drift = bound("max_energy_drift")};
}

/// The outputs of `twrench check` in its three formats.
struct CheckReports {
  std::string json, text, junit;
};

CheckReports reports_of(const check::CheckResult& result) {
  return {check::check_json(result, argument_text), check::check_text(result, argument_text),
          check::check_junit(result, argument_text)};
}

void draw_check(const system::OutputFile& plot, const check::CheckResult& result) {
  std::vector<plot::JudgedCurve> curves;
  for (const check::CheckedFile& file : result.files) {
    curves.push_back({fs::path(file.name).filename().string(), &file.judgement});
  }
  plot::draw_plot(plot, plot::check_plot(curves));
}

/// The columns of a table by their names, of the same length.
using Columns = std::vector<std::pair<std::string, py::array_t<double>>>;
/// The path of a file, or the name of a table in memory and its columns.
using Source = std::variant<std::string, std::pair<std::string, Columns>>;

/// Returns a function that opens the source, for any thread.
std::function<recording::Recording()> opener_of(const Source& source) {
  if (const auto* file = std::get_if<std::string>(&source)) {
    return [file] { return recording::Recording(fs::path(*file)); };
  }
  const auto& [name, arrays] = std::get<1>(source);
  std::vector<table::Column> columns;
  for (const auto& [key, numbers] : arrays) {
    const auto step = numbers.strides(0) / static_cast<py::ssize_t>(sizeof(double));
    columns.push_back({key, numbers.data(), step});
  }
  const auto rows = static_cast<std::size_t>(arrays.front().second.size());
  return [&name = name, columns = std::move(columns), rows] {
    return recording::Recording(table::open_table(name, columns, rows));
  };
}

/// Lets the scene show the recording for its whole duration, unless the caller gave another.
void show_recording(scene::Scene& scene, const Source& source, const Given& given, bool smooth) {
  const std::function<recording::Recording()> open = opener_of(source);
  const py::gil_scoped_release others_run;
  on_scene([&] {
    replay::show_recording(
        scene, open(), convention_of(given), replay::Body::known,
        smooth ? recording::Smoothing::within_noise : recording::Smoothing::none);
    scene::set_natural_times(scene);
    scene::check_shown_motion(scene);
  });
}

/// The same for the recording that the scene file names.
void show_own_recording(scene::Scene& scene) {
  const py::gil_scoped_release others_run;
  on_scene([&] {
    scene::propose_keys([&] { replay::show_own_recording(scene); });
    scene::set_natural_times(scene);
    scene::check_shown_motion(scene);
  });
}

/// Reads a recording in the convention that is given, or that its names determine. Returns the time
/// of its first row on the clock, the times since then, the rates and the attitudes by their rows;
/// those that it does not have are empty.
std::tuple<double, Eigen::VectorXd, RowMatrix, RowMatrix> read_recording(
    const Source& source, const Given& given, const std::optional<Eigen::Matrix3d>& inertia) {
  const std::function<recording::Recording()> open = opener_of(source);
  std::optional<check::Problem> problem;
  if (inertia) problem = check::Problem{.inertia = *inertia};
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    const recording::Recording recording = open();
    const recording::Convention convention =
        check::choose_convention(recording, convention_of(given), problem);
    if (has_momentum(convention) && !inertia) {
      throw InvalidArgument(recording.name(), "it has the angular momentum instead of rates",
                            "give the body, too");
    }
    recording::RowReader reader = recording.rows(convention);
    std::vector<double> times, omega, X;
    for (recording::Row row; reader.next(row);) {
      if (stop) throw Stopped{};
      times.push_back(row.t);
      if (reader.has_rates()) omega.insert(omega.end(), row.omega.begin(), row.omega.end());
      if (reader.attitude() == recording::AttitudeForm::none) continue;
      for (const double entry : row.X.reshaped<Eigen::RowMajor>()) X.push_back(entry);
    }
    const auto matrix = [](const std::vector<double>& numbers, Eigen::Index columns) {
      const auto rows = static_cast<Eigen::Index>(numbers.size()) / columns;
      return RowMatrix(Eigen::Map<const RowMatrix>(numbers.data(), rows, columns));
    };
    const Eigen::Map<const Eigen::VectorXd> t(times.data(),
                                              static_cast<Eigen::Index>(times.size()));
    return std::tuple(reader.first_time(), Eigen::VectorXd(t), matrix(omega, 3), matrix(X, 9));
  });
}

/// Returns the reports on all recordings and those on each of them. Without an inertia it is
/// fitted. `range` is recording::Extract. `plot` may be null.
std::pair<CheckReports, std::vector<CheckReports>> check_recordings(
    const std::vector<Source>& sources, const std::vector<double>& steps,
    const std::optional<Eigen::Matrix3d>& inertia, const std::optional<Eigen::Vector3d>& omega,
    std::optional<double> omega_time, bool fit, const std::string& frame,
    const std::pair<double, double>& range, const Given& given,
    const std::map<std::string, double>& bounds, const Output* plot) {
  std::vector<std::function<recording::Recording()>> openers;
  for (const Source& source : sources) openers.push_back(opener_of(source));
  if (plot != nullptr) plot::require_gnuplot(plot->file.format());
  for (const double step : steps) scene::limits::check(scene::limits::step, "steps", step);
  check::Problem problem{.fits_inertia = !inertia};
  if (inertia) problem.inertia = *inertia;
  if (omega) problem.omega = scene::limits::check_omega("omega", *omega);
  problem.omega_time = omega_time;
  problem.fit = fit;
  problem.frame = find_enumerator<check::FrameSource>(frame, "frame");
  const recording::Convention convention = convention_of(given);
  const check::Bounds most = bounds_of(bounds);
  const recording::Extract extract{range.first, range.second};
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    problem.stop = &stop;
    check::CheckResult result = check::check_files(
        openers.size(), [&](std::size_t i) { return openers[i]().between(extract); }, steps,
        convention, problem, most);
    if (plot != nullptr) draw_check(plot->file, result);
    const CheckReports of_all = reports_of(result);
    std::vector<CheckReports> of_each;
    for (check::CheckedFile& file : result.files) {
      of_each.push_back(reports_of({{std::move(file)}, {}}));
    }
    return std::pair(of_all, of_each);
  });
}

comparison::Criteria criteria_of(const std::string& metric, int threshold, double share,
                                 double min_similarity, int edges,
                                 const std::vector<std::array<int, 4>>& ignored) {
  comparison::Criteria criteria{find_enumerator<comparison::Metric>(metric, "metric"),
                                threshold,
                                share,
                                min_similarity,
                                edges,
                                {}};
  for (const auto& [x, y, width, height] : ignored) {
    criteria.ignored.push_back({x, y, width, height});
  }
  return criteria;
}

/// Returns the outputs of `twrench compare` in JSON, as text and as JUnit's XML.
std::array<std::string, 3> compare_pictures(const std::string& expected, const std::string& actual,
                                            const std::string& metric, int threshold, double share,
                                            double min_similarity, int edges,
                                            const std::vector<std::array<int, 4>>& ignored,
                                            const std::string& difference, const std::string& page,
                                            bool update, bool overwrite) {
  const comparison::Request request{
      expected,   actual, criteria_of(metric, threshold, share, min_similarity, edges, ignored),
      difference, page,   update,
      overwrite};
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    const comparison::Comparison found = comparison::compare(request, [&](int, int) {
      if (stop) throw Stopped{};
    });
    if (const auto* frame = found.first_unreadable()) throw *frame->failure;
    std::array<std::string, 3> reports;
    comparison::write_json(found, [&](std::string_view text) { reports[0] += text; });
    comparison::write_text(found, [&](std::string_view text) { reports[1] += text; });
    comparison::write_junit(found, [&](std::string_view text) { reports[2] += text; });
    if (update && !found.passed()) comparison::update_expected(found);
    return reports;
  });
}

}  // namespace

void add_checks(py::module_& module) {
  py::class_<CheckReports>(module, "CheckReports")
      .def_readonly("json", &CheckReports::json)
      .def_readonly("text", &CheckReports::text)
      .def_readonly("junit", &CheckReports::junit);
  module.def("read_recording", &read_recording);
  module.def("show_recording", &show_recording);
  module.def("show_own_recording", &show_own_recording);
  module.def("check", &check_recordings);
  module.def("compare", &compare_pictures);
}

}  // namespace twrench::python
