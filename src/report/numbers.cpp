#include "report/numbers.h"

#include <fmt/format.h>

namespace twrench::report {

std::string digits(double value) {
  if (!std::isfinite(value)) return "–";
  return fmt::format("{:.8g}", value + 0.0);  // no minus before 0
}

std::string brief(double value) {
  if (!std::isfinite(value)) return "–";
  return value == 0 ? "0" : fmt::format("{:.2e}", value);
}

}  // namespace twrench::report
