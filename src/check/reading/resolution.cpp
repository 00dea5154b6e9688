#include "check/reading/resolution.h"

#include <algorithm>
#include <cmath>

namespace twrench::check {

double Resolution::at(double value) const {
  const double size = std::abs(offset + value);
  const double doubles = std::numeric_limits<double>::epsilon() * size;
  const double in_file = size / unit;
  if (in_file == 0 || !std::isfinite(in_file)) return std::max(absolute, doubles);
  const double leading = base == 2 ? std::exp2(std::floor(std::log2(in_file)))
                                   : std::pow(10.0, std::floor(std::log10(in_file)));
  return std::max({absolute, unit * relative * leading, doubles});
}

}  // namespace twrench::check
