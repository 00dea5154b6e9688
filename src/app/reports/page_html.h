#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::app {

/// Returns the page without a scene, as scripts/page.sh builds it: the file, or without a name what
/// is built in. Throws FileError where it cannot be read or nothing is built in.
std::string page_template(const std::string& file);

/// Returns the picture of a scene as an <img>; empty, with a warning, where nothing can be drawn,
/// because a page can do without.
std::string poster_html(const scene::Scene& scene);

/// The scene of a page.
struct PageScene {
  /// The scene that is shown.
  scene::Scene shown;
  /// The scene without the overrides of the command line.
  scene::Scene original;
  /// Its name or file, as a command line has it.
  std::string source;
  /// The options that a command line has with it, if it is a mesh.
  std::vector<std::string> source_options;
};

/// Returns the page of a scene. `poster` is an <img>. Throws FileError where the template lacks a
/// place for something.
std::string page_html(const std::string& page_template, const PageScene& scene,
                      const std::string& poster);

}  // namespace twrench::app
