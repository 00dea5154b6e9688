#pragma once

#include "report/document.h"

namespace twrench::report {

/// Returns the equations that are solved and the measures of error that the tables have.
Section equations();

}  // namespace twrench::report
