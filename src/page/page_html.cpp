#include "page/page_html.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/enumeration.h"
#include "base/words.h"
#include "embedded/page.h"
#include "page/page_json.h"
#include "page/recording_json.h"
#include "page/template_filling.h"
#include "scene/limits.h"
#include "scene/natural_times.h"
#include "scene/scene_json.h"
#include "system/file.h"
#include "text/escape.h"

namespace twrench::page {
namespace {

/// Escapes the data, so that no part of it looks like the end of the script. From the source and
/// its scene, the page composes a command line for what it shows.
std::string scene_html(const PageScene& scene, const Surface& surface,
                       const motion::RecordedMotion* recording) {
  nlohmann::ordered_json json = page_json(scene.shown, surface, recording);
  json["program"] = "twrench " TWRENCH_VERSION;
  json["article"] = scene.has_article;
  const scene::Language language = scene.language.value_or(scene.shown.language);
  const bool is_chosen = scene.language || language != scene::Language::en;
  if (is_chosen) json["language"] = enumerator_name(language);
  // A built-in story has a name for each language.
  json["source"] = scene::is_scene_file(scene.source) ? scene.source : scene.original.name;
  json["source_options"] = scene.source_options;
  if (recording != nullptr) json["recording"]["options"] = scene.recording_options;
  nlohmann::ordered_json original = scene::scene_json(scene.original);
  if (original != json["scene"]) json["source_scene"] = std::move(original);
  std::string data;
  for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<') {
      data += "\\u003c";
    } else {
      data += c;
    }
  }
  return "<script type=\"application/json\" id=\"scene\">" + data + "</script>";
}

/// The times of a film with shots suit its shots, which a page leaves out. An energy loss is shown
/// for as long as in the film.
void set_times_without_shots(scene::Scene& scene) {
  if (scene.shots.empty() || !scene.motion.is_rigid()) return;
  using scene::Origin;
  for (const auto member : {&scene::Origins::duration, &scene::Origins::speed}) {
    Origin& origin = scene.origins.*member;
    if (origin == Origin::scene) origin = Origin::none;
  }
  scene::set_natural_times(scene);
}

double within(const scene::limits::Limit& limit, double value) {
  return std::clamp(value, limit.low, limit.high);
}

/// Changes the times that the user did not give: the timeline shows three to five times between
/// flips, and each takes 2 to 10 s. The page rounds a speed to a power of 2 from 0.55 to 1.1 times
/// of it (web/app/state.js).
void suit_flips(scene::Scene& scene) {
  const motion::FreeBody body = scene::free_body(scene);
  if (!body.is_rigid()) return;
  const auto flips = motion::ExactMotion(body).flips();
  if (!flips || !flips->turns_over() || !std::isfinite(flips->interval)) return;
  const double interval = flips->interval;
  double &duration = scene.motion.duration, &speed = scene.film.speed;
  if (scene.origins.duration != scene::Origin::user) {
    duration = within(scene::limits::duration, std::clamp(duration, 3 * interval, 5 * interval));
  }
  if (scene.origins.speed != scene::Origin::user) {
    speed =
        within(scene::limits::speed, std::clamp(speed, interval / 10 / 0.55, interval / 2 / 1.1));
  }
}

/// Returns the recorded motion that the page plays beside the exact one; nothing if there is none.
std::optional<PageRecording> recording_of(const scene::Scene& scene) {
  if (!scene.motion.recording) return std::nullopt;
  const scene::ShownRecording& recording = *scene.motion.recording;
  if (!recording.has_body) {
    throw InvalidArgument(recording.file,
                          "a page shows the exact motion beside it, and the body is not given",
                          "name a scene or a mesh, or give its inertia");
  }
  return page_recording(recording);
}

constexpr const char* no_page = "this build does not include the page";
constexpr const char* remedy_for_no_page = "run scripts/maintain/page.sh, which adds it";

/// The page without a scene; empty if this build has none.
std::string_view built_in_page() {
  const auto& files = embedded::page();
  const auto found = files.find("page.html");
  return found == files.end() ? std::string_view() : found->second;
}

}  // namespace

std::string page_template(const std::string& file) {
  constexpr std::size_t most_bytes = std::size_t{1} << 26U;
  if (!file.empty()) {
    const auto bytes = system::read_regular_file(file, most_bytes);
    return {bytes.begin(), bytes.end()};
  }
  if (const auto found = built_in_page(); !found.empty()) return std::string(found);
  throw system::FileError("page", no_page, remedy_for_no_page);
}

std::string note_on_missing_page() {
  if (!built_in_page().empty()) return {};
  return fmt::format("{}, so the report is static; {}", no_page, remedy_for_no_page);
}

scene::Scene shown_scene(scene::Scene scene) {
  const std::vector<Eigen::Vector3d>& wheels = scene.overlay.compare_wheel;
  if (!scene.motion.wheel && !wheels.empty()) scene.motion.wheel = wheels.back();
  set_times_without_shots(scene);
  if (!scene.motion.recording) suit_flips(scene);
  return scene;
}

PageDocument page_html(const std::string& page_template, const PageScene& scene,
                       const std::function<std::string()>& draw_pictures) {
  const std::optional<PageRecording> recording = recording_of(scene.shown);
  const Surface surface = surface_of(scene.shown.body);
  const std::string title = text::escape_xml(scene.shown.shown_title());
  TemplateFilling page(page_template);
  page.put("{{title}}", title);
  page.put("{{title}}", title);
  const std::string data = scene_html(scene, surface, recording ? &recording->motion : nullptr);
  page.put("<!-- twrench:poster -->", draw_pictures());
  page.put("<!-- twrench:scene -->", data);
  PageDocument document{std::move(page).filled(), {}};
  if (recording && !recording->note.empty()) document.notes.push_back(recording->note);
  if (const auto& simplified = surface.simplification) {
    document.notes.push_back(
        fmt::format("the page draws {} of {} triangles; mass properties use all of them",
                    simplified->drawn, simplified->given));
  }
  return document;
}

std::string content_policy(const std::string& page_template) {
  const std::size_t policy = page_template.find("<meta http-equiv=\"Content-Security-Policy\"");
  if (policy == std::string::npos) return {};
  return page_template.substr(policy, page_template.find('>', policy) + 1 - policy);
}

}  // namespace twrench::page
