#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench {

// What a scene chooses by name, as files and the command line spell it. Each way from a name
// throws UsageError about `what`, with the nearest name offered.

Theme theme_of(const std::string& name, const std::string& what);
View view_of(const std::string& name, const std::string& what);
Feature feature_of(const std::string& name, const std::string& what);

std::string name_of(Theme theme);
std::string name_of(View view);
std::string name_of(Feature feature);

/// The names themselves, where they are those of methods and not too many to be drawn side by side.
std::vector<std::string> compared_methods(std::vector<std::string> names, const std::string& what);

}  // namespace twrench
