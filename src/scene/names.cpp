#include "scene/names.h"

#include <fmt/format.h>
#include <twrench/base/nearest.h>

#include <algorithm>

#include "scene/limits.h"

namespace twrench {
namespace {

// In the order of the enumerations.
const std::vector<std::string> themes{"studio", "paper", "space"};
const std::vector<std::string> views{"wrench", "momentum", "poinsot", "quad"};
const std::vector<std::string> features{"floor",  "axes", "momentum",   "omega",  "trail",  "plane",
                                        "labels", "hud",  "components", "sphere", "poinsot"};

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

Theme theme_of(const std::string& name, const std::string& what) {
  return find<Theme>(themes, name, what);
}

View view_of(const std::string& name, const std::string& what) {
  return find<View>(views, name, what);
}

Feature feature_of(const std::string& name, const std::string& what) {
  return find<Feature>(features, name, what);
}

std::string name_of(Theme theme) { return name_in(themes, theme); }
std::string name_of(View view) { return name_in(views, view); }
std::string name_of(Feature feature) { return name_in(features, feature); }

std::vector<std::string> compared_methods(std::vector<std::string> names, const std::string& what) {
  for (const std::string& name : names) find_method(name, what);
  if (names.size() > limits::max_compared) {
    throw InvalidArgument(what, fmt::format("has {} methods, but at most {} are drawn side by side",
                                            names.size(), limits::max_compared));
  }
  return names;
}

}  // namespace twrench
