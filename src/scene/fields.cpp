#include "scene/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/limits.h"
#include "scene/names.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;
using Texts = std::vector<std::string>;

template <typename Value>
ordered_json to_json(const Value& value) {
  return value;
}

ordered_json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json to_json(const Color& color) { return to_string(color); }

template <typename Value>
ordered_json to_json(const std::optional<Value>& value) {
  return value ? to_json(*value) : ordered_json();
}

// Each of the following completes a field whose value is what `member` returns a reference to.

template <typename Member>
Field number(Field field, const limits::Limit& limit, Member member) {
  field.kind = Field::Kind::number;
  field.set = [=](Scene& scene, const ordered_json& value, const std::string& what) {
    member(scene) = limits::check(limit, what, value.get<double>());
  };
  field.get = [=](const Scene& scene) { return to_json(member(scene)); };
  return field;
}

template <typename Member>
Field integer(Field field, const limits::Limit& limit, Member member) {
  field.kind = Field::Kind::integer;
  field.set = [=](Scene& scene, const ordered_json& value, const std::string& what) {
    member(scene) = limits::check_whole(limit, what, value.get<double>());
  };
  field.get = [=](const Scene& scene) { return to_json(member(scene)); };
  return field;
}

/// `parse` returns the value of a text, and throws InvalidArgument about `what`.
template <typename Parse, typename Member>
Field text(Field field, Parse parse, Member member) {
  field.kind = Field::Kind::text;
  field.set = [=](Scene& scene, const ordered_json& value, const std::string& what) {
    member(scene) = parse(value.get<std::string>(), what);
  };
  field.get = [=](const Scene& scene) { return to_json(member(scene)); };
  return field;
}

/// `parse` returns the value with one of these names.
template <typename Parse, typename Member>
Field choice(Field field, const Texts& names, Parse parse, Member member) {
  field.help +=
      fmt::format(": {} or {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
  field = text(std::move(field), parse, member);
  field.get = [=](const Scene& scene) { return name_of(member(scene)); };
  return field;
}

/// `check` returns the vector, and throws InvalidArgument about `what`.
template <typename Check, typename Member>
Field vector(Field field, Check check, Member member) {
  field.kind = Field::Kind::vector;
  field.set = [=](Scene& scene, const ordered_json& value, const std::string& what) {
    member(scene) = check(what, to_vector(value));
  };
  field.get = [=](const Scene& scene) { return to_json(member(scene)); };
  return field;
}

Eigen::Vector3d check_point(const std::string& what, const Eigen::Vector3d& point) {
  return limits::check(limits::coordinate, what, point);
}

std::string as_it_is(const std::string& text, const std::string& /*what*/) { return text; }

std::string method_name(const std::string& name, const std::string& what) {
  return std::string(motion::find_method(name, what).name);
}

Field size(Field field) {
  field.kind = Field::Kind::size;
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    scene.film.width = limits::check_whole(limits::pixels, what, value.at(0).get<double>());
    scene.film.height = limits::check_whole(limits::pixels, what, value.at(1).get<double>());
  };
  field.get = [](const Scene& scene) { return ordered_json{scene.film.width, scene.film.height}; };
  return field;
}

Field background(Field field) {
  field.kind = Field::Kind::text;
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    set_background(scene.look, value.get<std::string>(), what);
  };
  field.get = [](const Scene& scene) {
    return scene.look.transparent ? ordered_json("transparent") : to_json(scene.look.background);
  };
  return field;
}

Field shown_features(Field field) {
  field.kind = Field::Kind::texts;
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    scene.overlay.show.clear();
    for (const std::string& name : value.get<Texts>()) {
      scene.overlay.show.insert(feature_of(name, what));
    }
  };
  field.get = [](const Scene& scene) {
    ordered_json names = ordered_json::array();
    for (const Feature feature : scene.overlay.show) names.push_back(name_of(feature));
    return names;
  };
  return field;
}

Field methods_compared(Field field) {
  field.kind = Field::Kind::texts;
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    scene.overlay.compare = compared_methods(value.get<Texts>(), what);
  };
  field.get = [](const Scene& scene) {
    return scene.overlay.compare.empty() ? ordered_json() : ordered_json(scene.overlay.compare);
  };
  return field;
}

}  // namespace

const std::vector<Field>& fields() {
  static const std::vector<Field> all{
      text(
          {"", "title", "TEXT", "title shown in the picture"}, as_it_is,
          [](auto& s) -> auto& { return s.title; }),

      vector(
          {"motion", "omega", "X,Y,Z", "initial angular velocity in body axes, rad/s"},
          limits::check_omega, [](auto& s) -> auto& { return s.motion.omega; }),
      text(
          {"motion", "method", "NAME", "integration method (see twrench methods)"}, method_name,
          [](auto& s) -> auto& { return s.motion.method; }),
      number(
          {"motion", "step", "H", "step size, s; initial step size of adaptive methods"},
          limits::step, [](auto& s) -> auto& { return s.motion.control.step; }),
      number(
          {"motion", "tolerance", "T", "error tolerance per step of adaptive methods"},
          limits::tolerance, [](auto& s) -> auto& { return s.motion.control.tolerance; }),
      number(
          {"motion", "duration", "S", "duration of the motion, s"}, limits::duration,
          [](auto& s) -> auto& { return s.motion.duration; }),

      size({"film", "size", "WxH", "frame size in pixels"}),
      number(
          {"film", "fps", "N", "frames (and output samples) per second"}, limits::fps,
          [](auto& s) -> auto& { return s.film.fps; }),
      number(
          {"film", "speed", "F", "seconds of motion per second of video"}, limits::speed,
          [](auto& s) -> auto& { return s.film.speed; }),

      choice(
          {"look", "theme", "NAME", "theme"}, theme_names(), theme_of,
          [](auto& s) -> auto& { return s.look.theme; }),
      integer(
          {"look", "samples", "N", "MSAA samples per pixel; 1 = analytic edge antialiasing"},
          limits::samples, [](auto& s) -> auto& { return s.look.samples; }),
      integer(
          {"look", "motion_blur", "N", "poses averaged per frame; 1 = no motion blur"},
          limits::motion_blur, [](auto& s) -> auto& { return s.look.motion_blur; }),
      background({"look", "background", "COLOR",
                  "background: #rrggbb, #rgb, black, gray, white or transparent", "the theme's"}),
      text(
          {"look", "color", "COLOR", "body colour: #rrggbb, #rgb, black, gray or white",
           "the theme's"},
          parse_color, [](auto& s) -> auto& { return s.look.color; }),
      number(
          {"look", "metallic", "F", "metalness of the body, 0 (paint) to 1 (metal)", "the theme's"},
          limits::fraction, [](auto& s) -> auto& { return s.look.metallic; }),
      number(
          {"look", "roughness", "R", "surface roughness, 0.05 (mirror) to 1 (chalk)",
           "the theme's"},
          limits::roughness, [](auto& s) -> auto& { return s.look.roughness; }),

      number(
          {"camera", "azimuth", "A", "camera azimuth, from z towards x, rad"}, limits::angle,
          [](auto& s) -> auto& { return s.camera.azimuth; }),
      number(
          {"camera", "elevation", "E", "camera elevation above the horizontal, rad"},
          limits::elevation, [](auto& s) -> auto& { return s.camera.elevation; }),
      number(
          {"camera", "distance", "F", "camera distance; at 1 the body just fits"}, limits::distance,
          [](auto& s) -> auto& { return s.camera.distance; }),
      number(
          {"camera", "orbit", "W",
           "angular speed of the camera around the body, rad per second of video"},
          limits::angle, [](auto& s) -> auto& { return s.camera.orbit; }),
      number(
          {"camera", "field_of_view", "A", "field of view along the shorter side, rad"},
          limits::angle_of_view, [](auto& s) -> auto& { return s.camera.field_of_view; }),

      choice(
          {"overlay", "view", "NAME", "view"}, view_names(), view_of,
          [](auto& s) -> auto& { return s.overlay.view; }),
      shown_features({"overlay", "show", "LIST", "what is shown besides the body"}),
      methods_compared({"overlay", "compare", "M1,M2,...", "show up to four methods side by side",
                        "the motion's method"}),
      vector(
          {"overlay", "trail_point", "X,Y,Z",
           "point that draws the trail, in the axes of the parts, cm", "the farthest point"},
          check_point, [](auto& s) -> auto& { return s.overlay.trail_point; }),
      number(
          {"overlay", "trail_length", "S", "seconds of motion that the trail covers",
           "the time of a 12 rad rotation"},
          limits::trail_length, [](auto& s) -> auto& { return s.overlay.trail_length; }),
      text(
          {"overlay", "font", "NAME", "font of all text: sans, mono or a font file"}, as_it_is,
          [](auto& s) -> auto& { return s.overlay.font; }),
  };
  return all;
}

std::vector<std::string> field_tables() {
  std::vector<std::string> tables;
  for (const Field& field : fields()) {
    const bool known = std::ranges::find(tables, field.table) != tables.end();
    if (!known && !field.table.empty()) tables.push_back(field.table);
  }
  return tables;
}

Eigen::Vector3d to_vector(const ordered_json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

}  // namespace twrench::scene
