#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "cases/case.h"
#include "module.h"

namespace twrench::python {

void add_cases(pybind11::module_& module) {
  module.def("case_names", &cases::case_names);
  module.def("case_json", [](const std::string& name) {
    return cases::case_json(cases::load_case(name, "name")).dump(-1, ' ', true);
  });
}

}  // namespace twrench::python
