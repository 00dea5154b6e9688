#pragma once

#include <Eigen/Core>
#include <functional>
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

/// A check for CLI::Option: of a value that is to be one of `names`. Throws where it is none.
std::function<std::string(const std::string&)> one_of(const std::string& what,
                                                      std::vector<std::string> names);

}  // namespace twrench
