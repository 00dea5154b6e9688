#include "recording/conventions/body_axes.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>

namespace twrench::recording {
namespace {

constexpr std::string_view axis_letters = "xyz";

std::vector<BodyAxes> make_all() {
  std::vector<BodyAxes> all;
  std::array<int, 3> axis{0, 1, 2};
  do {
    for (int negated = 0; negated < 8; ++negated) {
      BodyAxes axes{axis, {}};
      for (std::size_t i = 0; i < 3; ++i) axes.sign[i] = (negated >> i & 1) != 0 ? -1 : 1;
      all.push_back(axes);
    }
  } while (std::ranges::next_permutation(axis).found);
  const auto changes = [](const BodyAxes& axes) {
    const auto negated = std::ranges::count(axes.sign, -1);
    std::ptrdiff_t moved = 0;
    for (int i = 0; i < 3; ++i) moved += axes.axis[static_cast<std::size_t>(i)] == i ? 0 : 1;
    return std::pair(negated, moved);
  };
  std::ranges::stable_sort(all, {}, changes);
  return all;
}

}  // namespace

Eigen::Matrix3d BodyAxes::matrix() const {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    matrix(i, axis[k]) = sign[k];
  }
  return matrix;
}

BodyAxes parse_body_axes(std::string_view text, const std::string& quantity) {
  const InvalidArgument refusal(quantity, fmt::format("is '{}'", text),
                                "name each axis of the body once, such as x,-z,y");
  BodyAxes axes;
  std::array<bool, 3> used{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) {
      if (!text.starts_with(',')) throw refusal;
      text.remove_prefix(1);
    }
    const bool has_sign = text.starts_with('-') || text.starts_with('+');
    axes.sign[i] = text.starts_with('-') ? -1 : 1;
    if (has_sign) text.remove_prefix(1);
    const std::size_t letter = text.empty() ? axis_letters.npos : axis_letters.find(text.front());
    if (letter == axis_letters.npos || used[letter]) throw refusal;
    used[letter] = true;
    axes.axis[i] = static_cast<int>(letter);
    text.remove_prefix(1);
  }
  if (!text.empty()) throw refusal;
  return axes;
}

std::string format_body_axes(const BodyAxes& axes) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) text += ',';
    if (axes.sign[i] < 0) text += '-';
    text += axis_letters[static_cast<std::size_t>(axes.axis[i])];
  }
  return text;
}

const std::vector<BodyAxes>& all_body_axes() {
  static const std::vector<BodyAxes> all = make_all();
  return all;
}

}  // namespace twrench::recording
