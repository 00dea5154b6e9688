#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::page {

/// Returns the page without a scene, as scripts/maintain/page.sh builds it: the one in the file or,
/// if the name is empty, the built-in one. Throws FileError if the file cannot be read or none is
/// built in.
std::string page_template(const std::string& file);

/// Returns a note for a report that should contain a page and cannot, because this build has none;
/// empty if it has one.
std::string note_on_missing_page();

/// The scene of a page.
struct PageScene {
  /// The scene that is shown.
  scene::Scene shown;
  /// The scene without the overrides of the command line.
  scene::Scene original;
  /// Its name or file, as in a command line.
  std::string source;
  /// The options that follow the source in a command line, if it is a mesh.
  std::vector<std::string> source_options;
  /// The options by which a command line shows the recorded motion of the scene, if it has one.
  std::vector<std::string> recording_options;
  /// Whether the article, which explains the motion, is above the lab.
  bool has_article = false;
  /// The language of the page; nothing for the scene's or, if that is English, the reader's.
  std::optional<scene::Language> language = {};
};

/// A page with its scene.
struct PageDocument {
  std::string html;
  /// Notes for the user, one line each.
  std::vector<std::string> notes;
};

/// Returns the scene whose motion a page shows. If a film compares wheels, its page begins with the
/// last of them, unless the scene has its own. Unless the user gave them, the times of a film with
/// shots are natural, the motion lasts for three to five times between flips, and each of them
/// takes seconds.
scene::Scene shown_scene(scene::Scene scene);

/// Returns the page of a scene. `draw_pictures` returns <img> elements: the poster and the stills,
/// or nothing. It is called when nothing else can fail, because drawing takes long. Throws
/// FileError if the template lacks a mark, and InvalidArgument about a recorded motion that a page
/// cannot show.
PageDocument page_html(const std::string& page_template, const PageScene& scene,
                       const std::function<std::string()>& draw_pictures);

/// Returns the <meta> element of a page's content security policy; empty if the page has none.
std::string content_policy(const std::string& page_template);

}  // namespace twrench::page
