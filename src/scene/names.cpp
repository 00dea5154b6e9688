#include "scene/names.h"

#include <fmt/format.h>
#include <twrench/base/nearest.h>

#include <algorithm>

#include "scene/limits.h"

namespace twrench::scene {
namespace {

template <typename Enumeration>
Enumeration find(const std::vector<std::string>& names, const std::string& name,
                 const std::string& what) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw unknown_name(what, name, names);
  return static_cast<Enumeration>(found - names.begin());
}

template <typename Enumeration>
std::string name_in(const std::vector<std::string>& names, Enumeration value) {
  return names[static_cast<std::size_t>(value)];
}

}  // namespace

const std::vector<std::string>& theme_names() {
  static const std::vector<std::string> names{"studio", "paper", "space"};
  return names;
}

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names{"wrench", "momentum", "poinsot", "quad"};
  return names;
}

const std::vector<std::string>& feature_names() {
  static const std::vector<std::string> names{
      "floor",  "axes",  "momentum",   "omega",  "trail",   "plane",
      "labels", "hud",   "components", "sphere", "poinsot", "curve",
      "method", "drift", "forces",     "tilt",   "moments"};
  return names;
}

const std::vector<std::string>& frame_names() {
  static const std::vector<std::string> names{"space", "body", "rotating"};
  return names;
}

const std::vector<std::string>& equimomental_names() {
  static const std::vector<std::string> names{"box", "ellipsoid", "cross"};
  return names;
}

Theme theme_of(const std::string& name, const std::string& what) {
  return find<Theme>(theme_names(), name, what);
}

View view_of(const std::string& name, const std::string& what) {
  return find<View>(view_names(), name, what);
}

Feature feature_of(const std::string& name, const std::string& what) {
  return find<Feature>(feature_names(), name, what);
}

Frame frame_of(const std::string& name, const std::string& what) {
  return find<Frame>(frame_names(), name, what);
}

Equimomental equimomental_of(const std::string& name, const std::string& what) {
  return find<Equimomental>(equimomental_names(), name, what);
}

std::string name_of(Theme theme) { return name_in(theme_names(), theme); }
std::string name_of(View view) { return name_in(view_names(), view); }
std::string name_of(Feature feature) { return name_in(feature_names(), feature); }
std::string name_of(Frame frame) { return name_in(frame_names(), frame); }
std::string name_of(Equimomental form) { return name_in(equimomental_names(), form); }

std::vector<std::string> compared_methods(std::vector<std::string> names, const std::string& what) {
  for (const std::string& name : names) motion::find_method(name, what);
  if (names.size() > limits::max_compared) {
    throw InvalidArgument(what, fmt::format("has {} methods, but at most {} are drawn side by side",
                                            names.size(), limits::max_compared));
  }
  return names;
}

}  // namespace twrench::scene
