#include "scene/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/enumeration.h"
#include "scene/limits.h"
#include "scene/materials.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;
using Texts = std::vector<std::string>;

template <typename Value>
ordered_json to_json(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return enumerator_name(value);
  } else {
    return value;
  }
}

ordered_json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json to_json(const Color& color) { return to_string(color); }

ordered_json to_json(const std::set<Feature>& features) {
  ordered_json names = ordered_json::array();
  for (const Feature feature : features) names.push_back(enumerator_name(feature));
  return names;
}

ordered_json to_json(const Texts& names) {
  return names.empty() ? ordered_json() : ordered_json(names);
}

ordered_json to_json(const std::vector<Eigen::Vector3d>& vectors) {
  ordered_json values = vectors.empty() ? ordered_json() : ordered_json::array();
  for (const Eigen::Vector3d& v : vectors) values.push_back(to_json(v));
  return values;
}

template <typename Value>
ordered_json to_json(const std::optional<Value>& value) {
  return value ? to_json(*value) : ordered_json();
}

template <Field::Kind kind>
auto from_json(const ordered_json& value) {
  if constexpr (kind == Field::Kind::vector) {
    return to_vector(value);
  } else if constexpr (kind == Field::Kind::size) {
    return value.get<std::array<double, 2>>();
  } else if constexpr (kind == Field::Kind::text) {
    return value.get<std::string>();
  } else if constexpr (kind == Field::Kind::texts) {
    return value.get<Texts>();
  } else if constexpr (kind == Field::Kind::vectors) {
    std::vector<Eigen::Vector3d> vectors;
    for (const ordered_json& entry : value) vectors.push_back(to_vector(entry));
    return vectors;
  } else {
    return value.get<double>();
  }
}

/// Completes a field whose value is what `member` returns a reference to. `convert` returns the
/// value for what a file or an option gives, and throws InvalidArgument about its second argument.
template <Field::Kind kind, typename Convert, typename Member>
Field complete(Field field, Convert convert, Member member) {
  field.kind = kind;
  field.set = [=](Scene& scene, const ordered_json& value, const std::string& what) {
    member(scene) = convert(from_json<kind>(value), what);
  };
  field.get = [=](const Scene& scene) { return to_json(member(scene)); };
  return field;
}

std::string listed(const Texts& names) {
  return fmt::format(": {} or {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// The value is an enumerator, given by its name.
template <typename Enumeration, typename Member>
Field choice(Field field, Member member) {
  field.help += listed(enumerator_names<Enumeration>());
  return complete<Field::Kind::text>(std::move(field), find_enumerator<Enumeration>, member);
}

/// Makes a field whose value is an empty array one that the scene leaves to its default.
Field or_nothing(Field field) {
  field.get = [get = std::move(field.get)](const Scene& scene) {
    ordered_json value = get(scene);
    return value.empty() ? ordered_json() : value;
  };
  return field;
}

/// Makes a field whose default is natural record that it was given.
Field natural(Field field, Origin Origins::*origin) {
  field.set = [set = std::move(field.set), origin](Scene& scene, const ordered_json& value,
                                                   const std::string& what) {
    set(scene, value, what);
    scene.origins.*origin = Origin::user;
  };
  return field;
}

/// Two members hold the background, of which only the colour has a value of its own.
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

/// A material is not a value of its own: it is what the colour, the metalness and the roughness
/// make.
Field material(Field field) {
  field.kind = Field::Kind::text;
  field.help += listed(material_names());
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    set_material(scene.look, find_material(value.get<std::string>(), what));
  };
  field.get = [](const Scene& scene) { return to_json(material_name(scene.look)); };
  return field;
}

/// For a number, and for each number of a vector.
auto within(const limits::Limit& limit) {
  return
      [=](const auto& value, const std::string& what) { return limits::check(limit, what, value); };
}

auto whole_within(const limits::Limit& limit) {
  return [=](double value, const std::string& what) {
    return limits::check_whole(limit, what, value);
  };
}

std::pair<int, int> whole_pixels(const std::array<double, 2>& size, const std::string& what) {
  const auto check = whole_within(limits::pixels);
  return {check(size[0], what), check(size[1], what)};
}

Eigen::Vector3d angular_velocity(const Eigen::Vector3d& omega, const std::string& what) {
  return limits::check_omega(what, omega);
}

std::vector<Eigen::Vector3d> compared_velocities(const std::vector<Eigen::Vector3d>& velocities,
                                                 const std::string& what) {
  for (const Eigen::Vector3d& omega : velocities) limits::check_omega(what, omega);
  if (velocities.size() > limits::max_compared) {
    throw InvalidArgument(what,
                          fmt::format("has {} velocities, but at most {} are drawn side by side",
                                      velocities.size(), limits::max_compared));
  }
  return velocities;
}

std::string as_it_is(const std::string& text, const std::string& /*what*/) { return text; }

std::string method_name(const std::string& name, const std::string& what) {
  return std::string(motion::find_method(name, what).name);
}

Texts compared_methods(const Texts& names, const std::string& what) {
  for (const std::string& name : names) motion::find_method(name, what);
  if (names.size() > limits::max_compared) {
    throw InvalidArgument(what, fmt::format("has {} methods, but at most {} are drawn side by side",
                                            names.size(), limits::max_compared));
  }
  return names;
}

std::set<Feature> features(const Texts& names, const std::string& what) {
  std::set<Feature> result;
  for (const std::string& name : names) result.insert(find_enumerator<Feature>(name, what));
  return result;
}

}  // namespace

const std::vector<Field>& fields() {
  using enum Field::Kind;
  static const std::vector<Field> all{
      natural(complete<text>(
                  {"", "title", "TEXT", "title shown in the picture"}, as_it_is,
                  [](auto& s) -> auto& { return s.title; }),
              &Origins::title),

      complete<vector>(
          {"motion", "omega", "X,Y,Z", "initial angular velocity in body axes, rad/s"},
          angular_velocity, [](auto& s) -> auto& { return s.motion.omega; }),
      complete<text>(
          {"motion", "method", "NAME", "integration method"}, method_name,
          [](auto& s) -> auto& { return s.motion.method; }),
      natural(complete<number>(
                  {"motion", "step", "H", "step size, s; initial step size of adaptive methods",
                   "the time of a 0.01 rad rotation"},
                  within(limits::step), [](auto& s) -> auto& { return s.motion.control.step; }),
              &Origins::step),
      complete<number>(
          {"motion", "tolerance", "T", "error tolerance per step of adaptive methods"},
          within(limits::tolerance), [](auto& s) -> auto& { return s.motion.control.tolerance; }),
      natural(
          complete<number>(
              {"motion", "duration", "S", "duration of the motion, s", "three flips, or 16 turns"},
              within(limits::duration), [](auto& s) -> auto& { return s.motion.duration; }),
          &Origins::duration),

      complete<size>({"film", "size", "WxH", "frame size in pixels"}, whole_pixels,
                     [](auto& s) { return std::tie(s.film.width, s.film.height); }),
      natural(complete<number>(
                  {"film", "fps", "N", "frames (and output samples) per second",
                   "60; samples: 60 a radian"},
                  within(limits::fps), [](auto& s) -> auto& { return s.film.fps; }),
              &Origins::fps),
      natural(complete<number>(
                  {"film", "speed", "F",
                   "seconds of motion per second of video; a smaller one is slow motion",
                   "the time of a turn"},
                  within(limits::speed), [](auto& s) -> auto& { return s.film.speed; }),
              &Origins::speed),

      choice<Theme>(
          {"look", "theme", "NAME", "theme"}, [](auto& s) -> auto& { return s.look.theme; }),
      complete<integer>(
          {"look", "samples", "N", "MSAA samples per pixel; 1 = analytic edge antialiasing"},
          whole_within(limits::samples), [](auto& s) -> auto& { return s.look.samples; }),
      complete<integer>(
          {"look", "motion_blur", "N", "poses averaged per frame, at least; 1 = no motion blur"},
          whole_within(limits::motion_blur), [](auto& s) -> auto& { return s.look.motion_blur; }),
      background({"look", "background", "COLOR",
                  "background: #rrggbb, #rgb, black, gray, white, or transparent for overlays",
                  "the theme's"}),
      material({"look", "material", "NAME", "material, which sets colour, metalness and roughness",
                "the theme's"}),
      complete<text>(
          {"look", "color", "COLOR", "body colour: #rrggbb, #rgb, black, gray or white",
           "the theme's"},
          parse_color, [](auto& s) -> auto& { return s.look.color; }),
      complete<number>(
          {"look", "metallic", "F", "metalness of the body, 0 (paint) to 1 (metal)", "the theme's"},
          within(limits::fraction), [](auto& s) -> auto& { return s.look.metallic; }),
      complete<number>(
          {"look", "roughness", "R", "surface roughness, 0.05 (mirror) to 1 (chalk)",
           "the theme's"},
          within(limits::roughness), [](auto& s) -> auto& { return s.look.roughness; }),

      complete<number>(
          {"camera", "azimuth", "A", "camera azimuth, from z towards x, rad"},
          within(limits::angle), [](auto& s) -> auto& { return s.camera.azimuth; }),
      complete<number>(
          {"camera", "elevation", "E", "camera elevation above the horizontal, rad"},
          within(limits::elevation), [](auto& s) -> auto& { return s.camera.elevation; }),
      complete<number>(
          {"camera", "distance", "F", "camera distance; at 1 the body just fits"},
          within(limits::distance), [](auto& s) -> auto& { return s.camera.distance; }),
      complete<number>(
          {"camera", "orbit", "W",
           "angular speed of the camera around the body, rad per second of video"},
          within(limits::angle), [](auto& s) -> auto& { return s.camera.orbit; }),
      complete<number>(
          {"camera", "field_of_view", "A", "field of view along the shorter side, rad"},
          within(limits::angle_of_view), [](auto& s) -> auto& { return s.camera.field_of_view; }),
      choice<Frame>(
          {"camera", "frame", "NAME", "frame in which the camera stands and forces are shown"},
          [](auto& s) -> auto& { return s.camera.frame; }),

      choice<View>(
          {"overlay", "view", "NAME", "view"}, [](auto& s) -> auto& { return s.overlay.view; }),
      complete<texts>(
          {"overlay", "show", "LIST", "what is shown besides the body"}, features,
          [](auto& s) -> auto& { return s.overlay.show; }),
      or_nothing(complete<texts>(
          {"overlay", "stress", "LIST", "what is drawn stronger, everything else dimmer",
           "nothing"},
          features, [](auto& s) -> auto& { return s.overlay.stress; })),
      complete<texts>(
          {"overlay", "compare", "M1,M2,...", "show up to four methods side by side",
           "the motion's method"},
          compared_methods, [](auto& s) -> auto& { return s.overlay.compare; }),
      complete<vectors>(
          {"overlay", "compare_omega", "X,Y,Z;...",
           "show up to four motions side by side: their initial angular velocities, rad/s",
           "the motion's omega"},
          compared_velocities, [](auto& s) -> auto& { return s.overlay.compare_omega; }),
      complete<vector>(
          {"overlay", "trail_point", "X,Y,Z",
           "point that draws the trail, in the axes of the parts, cm", "the farthest point"},
          within(limits::coordinate), [](auto& s) -> auto& { return s.overlay.trail_point; }),
      complete<number>(
          {"overlay", "trail_length", "S", "seconds of motion that the trail covers",
           "the time of a 12 rad rotation"},
          within(limits::trail_length), [](auto& s) -> auto& { return s.overlay.trail_length; }),
      complete<text>(
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
