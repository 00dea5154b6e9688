#include "page/page_html.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/argument.h"
#include "base/enumeration.h"
#include "embedded/page.h"
#include "page/page_json.h"
#include "page/template_filling.h"
#include "scene/limits.h"
#include "scene/natural_times.h"
#include "scene/scene_json.h"
#include "system/file.h"
#include "text/xml.h"

namespace twrench::page {
namespace {

/// Escapes the data, so that no part of it looks like the end of the script. From the source and
/// its scene, the page composes a command line for what it shows.
std::string scene_html(const PageScene& scene, const Surface& surface) {
  nlohmann::ordered_json json = page_json(scene.shown, surface);
  json["program"] = "twrench " TWRENCH_VERSION;
  json["article"] = scene.has_article;
  const scene::Language language = scene.language.value_or(scene.shown.language);
  const bool is_chosen = scene.language || language != scene::Language::en;
  if (is_chosen) json["language"] = enumerator_name(language);
  // A built-in story has a name for each language.
  json["source"] = scene::is_scene_file(scene.source) ? scene.source : scene.original.name;
  json["source_options"] = scene.source_options;
  json["source_scene"] = scene::scene_json(scene.original);
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
  suit_flips(scene);
  return scene;
}

void require_shown(const scene::Scene& scene) {
  const auto begins_turned = [](const scene::Shot& shot) {
    return shot.scene.motion.attitude.has_value();
  };
  if (!scene.motion.attitude && std::ranges::none_of(scene.shots, begins_turned)) return;
  throw InvalidArgument("attitude", "a page begins with X(0) = Id",
                        "leave it out; for a report, use " + argument("static"));
}

PageDocument page_html(const std::string& page_template, const PageScene& scene,
                       const std::string& pictures) {
  require_shown(scene.shown);
  const Surface surface = surface_of(scene.shown.body);
  const std::string title = text::escape_xml(scene.shown.shown_title());
  TemplateFilling page(page_template);
  page.put("{{title}}", title);
  page.put("{{title}}", title);
  page.put("<!-- twrench:poster -->", pictures);
  page.put("<!-- twrench:scene -->", scene_html(scene, surface));
  PageDocument document{std::move(page).filled(), {}};
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
