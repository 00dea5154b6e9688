#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <twrench/base/error.h>
#include <twrench/study/study.h>

#include <algorithm>

#include "interruptible.h"
#include "module.h"
#include "output.h"
#include "plot/plots.h"
#include "scene/limits.h"

namespace twrench::python {
namespace {

namespace py = pybind11;

/// `plot` may be null.
study::Study run_study(const motion::FreeBody& body, const std::vector<std::string>& methods,
                       const std::vector<double>& steps, const std::vector<double>& tolerances,
                       double duration, const Output* plot) {
  if (plot != nullptr) plot::require_gnuplot(plot->file.format());
  study::StudyPlan plan;
  for (const std::string& name : methods) {
    plan.methods.push_back(&motion::find_method(name, "methods"));
  }
  if (plot != nullptr && std::ranges::all_of(plan.methods, &motion::Method::exact)) {
    throw InvalidArgument("plot", "the exact method alone has no steps to plot");
  }
  if (plan.methods.empty()) throw InvalidArgument("methods", "there must be one at least");
  for (const double step : steps) scene::limits::check(scene::limits::step, "steps", step);
  for (const double tolerance : tolerances) {
    scene::limits::check(scene::limits::tolerance, "tolerances", tolerance);
  }
  plan.steps = steps;
  plan.tolerances = tolerances;
  plan.duration = duration;
  return run_interruptibly([&](const std::atomic<bool>& stop) {
    plan.stop = &stop;
    study::Study study = study::run_study(body, plan);
    if (plot != nullptr) plot::draw_plot(plot->file, plot::study_plot(study));
    return study;
  });
}

}  // namespace

void add_study(py::module_& module) {
  using motion::Method;
  py::class_<Method>(module, "Method")
      .def_property_readonly("name", [](const Method& m) { return m.name; })
      .def_readonly("order", &Method::order)
      .def_property_readonly("adaptive", &Method::adaptive)
      .def_readonly("conserves_energy", &Method::conserves_energy)
      .def_readonly("reversible", &Method::reversible)
      .def_property_readonly("source", [](const Method& m) { return m.source; })
      .def_property_readonly("summary", [](const Method& m) { return m.summary; });
  module.def(
      "methods",
      [] {
        std::vector<const Method*> all;
        for (const Method& method : motion::methods()) all.push_back(&method);
        return all;
      },
      py::return_value_policy::reference);

  using study::StudyRun;
  py::class_<StudyRun>(module, "StudyRun")
      .def_readonly("step", &StudyRun::step)
      .def_readonly("tolerance", &StudyRun::tolerance)
      .def_readonly("failure", &StudyRun::failure)
      .def_readonly("early_error", &StudyRun::early_error)
      .def_readonly("error", &StudyRun::error)
      .def_readonly("energy_drift", &StudyRun::energy_drift)
      .def_readonly("orthogonality_error", &StudyRun::orthogonality_error)
      .def_readonly("momentum_error", &StudyRun::momentum_error)
      .def_readonly("flip_times", &StudyRun::flips)
      .def_readonly("flip_error", &StudyRun::flip_error)
      .def_readonly("steps", &StudyRun::steps)
      .def_readonly("evaluations", &StudyRun::evaluations)
      .def_readonly("cpu_seconds", &StudyRun::cpu_seconds);
  using study::MethodStudy;
  py::class_<MethodStudy>(module, "MethodStudy")
      .def_property_readonly("method", [](const MethodStudy& s) { return s.method->name; })
      .def_readonly("runs", &MethodStudy::runs)
      .def_readonly("order", &MethodStudy::order);
  using study::Study;
  py::class_<Study>(module, "Study")
      .def_property_readonly("reference", [](const Study& s) { return s.reference->name; })
      .def_readonly("duration", &Study::duration)
      .def_readonly("early", &Study::early)
      .def_readonly("flip_times", &Study::flip_times)
      .def_readonly("methods", &Study::methods);
  module.def("study", &run_study);
}

}  // namespace twrench::python
