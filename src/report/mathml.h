#pragma once

#include <string>
#include <string_view>

namespace twrench::report {

/// Returns a formula in TeX as the content of <math> in MathML. Supports what the report's formulas
/// need: letters, numbers, operators, Greek letters, names of functions, ^ and _, \frac, \sqrt,
/// accents, \text, \mathrm, \left and \right, and the environments pmatrix, cases and aligned.
/// Throws std::invalid_argument about anything else.
std::string mathml(std::string_view tex);

}  // namespace twrench::report
