#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace twrench {

// Words of the command line as values. Each throws UsageError about `what`, the option. Numbers
// have a '.' whatever the locale; ranges are for the caller to check.

/// "A,B,...": the words as they are
std::vector<std::string> parse_words(const std::string& text);
double parse_number(const std::string& text, const std::string& what);
/// "T1,T2,..."
std::vector<double> parse_numbers(const std::string& text, const std::string& what);
/// "X,Y,Z"
Eigen::Vector3d parse_vector(const std::string& text, const std::string& what);
/// "WxH", not yet checked
Eigen::Vector2d parse_size(const std::string& text, const std::string& what);

}  // namespace twrench
