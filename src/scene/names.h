#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::scene {

// The names by which scene files and the command line select options. Each conversion from a name
// throws InvalidArgument about `what`, suggesting the nearest name.

Theme theme_of(const std::string& name, const std::string& what);
View view_of(const std::string& name, const std::string& what);
Feature feature_of(const std::string& name, const std::string& what);
Frame frame_of(const std::string& name, const std::string& what);
Equimomental equimomental_of(const std::string& name, const std::string& what);

// The names, in the order of the enumerations.

const std::vector<std::string>& theme_names();
const std::vector<std::string>& view_names();
const std::vector<std::string>& feature_names();
const std::vector<std::string>& frame_names();
const std::vector<std::string>& equimomental_names();

std::string name_of(Theme theme);
std::string name_of(View view);
std::string name_of(Feature feature);
std::string name_of(Frame frame);
std::string name_of(Equimomental form);

/// Returns the names if all are methods and not too many to be shown side by side.
std::vector<std::string> compared_methods(std::vector<std::string> names, const std::string& what);

}  // namespace twrench::scene
