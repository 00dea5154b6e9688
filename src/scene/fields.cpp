#include "scene/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/enumeration.h"
#include "scene/fraction.h"
#include "scene/keys.h"
#include "scene/languages.h"
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

ordered_json to_json(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

ordered_json to_json(const SoundFile& sound) {
  return sound.is_given() ? ordered_json(sound.file) : ordered_json();
}

ordered_json to_json(const Color& color) { return to_string(color); }

template <typename Enumeration>
ordered_json to_json(const std::set<Enumeration>& values) {
  ordered_json names = ordered_json::array();
  for (const Enumeration value : values) names.push_back(enumerator_name(value));
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

template <ValueForm::Kind kind>
auto from_json(const ordered_json& value) {
  if constexpr (kind == ValueForm::Kind::vector) {
    return to_vector(value);
  } else if constexpr (kind == ValueForm::Kind::quaternion) {
    return to_quaternion(value);
  } else if constexpr (kind == ValueForm::Kind::size) {
    return value.get<std::array<double, 2>>();
  } else if constexpr (kind == ValueForm::Kind::rate) {
    return value;
  } else if constexpr (kind == ValueForm::Kind::text) {
    return value.get<std::string>();
  } else if constexpr (kind == ValueForm::Kind::texts) {
    return value.get<Texts>();
  } else if constexpr (kind == ValueForm::Kind::vectors) {
    std::vector<Eigen::Vector3d> vectors;
    for (const ordered_json& entry : value) vectors.push_back(to_vector(entry));
    return vectors;
  } else {
    return value.get<double>();
  }
}

/// Converts the value from a file or an option. Throws InvalidArgument about its second argument
/// unless the value has that form.
template <typename Convert>
struct Conversion {
  ValueForm form;  ///< Without its kind.
  Convert convert;
};
template <typename Convert>
Conversion(ValueForm, Convert) -> Conversion<Convert>;

/// Completes a field whose value is what `member` returns a reference to.
template <ValueForm::Kind kind, typename Convert, typename Member>
Field complete(Field field, Conversion<Convert> conversion, Member member) {
  field.form = std::move(conversion.form);
  field.form.kind = kind;
  field.set = [convert = conversion.convert, member](Scene& scene, const ordered_json& value,
                                                     const std::string& what) {
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
  return complete<ValueForm::Kind::text>(
      std::move(field),
      Conversion{{.names = enumerator_names<Enumeration>()}, find_enumerator<Enumeration>}, member);
}

/// Makes the field report an empty array as a value that the scene does not set.
Field or_nothing(Field field) {
  field.get = [get = std::move(field.get)](const Scene& scene) {
    ordered_json value = get(scene);
    return value.empty() ? ordered_json() : value;
  };
  return field;
}

/// Makes the field report a list of all names as a value that the scene does not set.
Field or_all(Field field) {
  const std::size_t all = field.form.names.size();
  field.get = [get = std::move(field.get), all](const Scene& scene) {
    ordered_json value = get(scene);
    return value.size() == all ? ordered_json() : value;
  };
  return field;
}

/// Makes a field with a natural default record that its value was given.
Field natural(Field field, Origin Origins::*origin) {
  field.set = [set = std::move(field.set), origin](Scene& scene, const ordered_json& value,
                                                   const std::string& what) {
    set(scene, value, what);
    scene.origins.*origin = Origin::user;
  };
  return field;
}

/// A scene whose author chose the closed form of a rigid body then needs a method; one that is
/// given is set later.
Field without_closed_form(Field field) {
  field.set = [set = std::move(field.set)](Scene& scene, const ordered_json& value,
                                           const std::string& what) {
    set(scene, value, what);
    const bool is_exact = motion::find_method(scene.motion.method).exact();
    if (is_exact && !scene.motion.is_rigid()) scene.motion.method = "taylor";
  };
  return field;
}

/// The background is stored in two members, Look::transparent and Look::background.
Field background(Field field) {
  field.form = {ValueForm::Kind::text, {}, color_names(), true};
  field.form.names.emplace_back(transparent_name);
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    set_background(scene.look, value.get<std::string>(), what);
  };
  field.get = [](const Scene& scene) {
    return scene.look.transparent ? ordered_json(transparent_name) : to_json(scene.look.background);
  };
  return field;
}

/// The tag determines two members, Scene::language_tag and Scene::language.
Field language(Field field) {
  field.form = {ValueForm::Kind::text};
  field.help += listed(enumerator_names<Language>()) + ", otherwise English";
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    set_language(scene, value.get<std::string>(), what);
  };
  field.get = [](const Scene& scene) { return to_json(scene.language_tag); };
  return field;
}

/// A material is not stored: it is derived from the colour, the metalness and the roughness.
Field material(Field field) {
  field.form = {ValueForm::Kind::text, {}, material_names()};
  field.help += listed(material_names());
  field.set = [](Scene& scene, const ordered_json& value, const std::string& what) {
    set_material(scene.look, find_material(value.get<std::string>(), what));
  };
  field.get = [](const Scene& scene) { return to_json(material_name(scene.look)); };
  return field;
}

/// For a number, and for each number of a vector.
auto within(const limits::Limit& limit) {
  return Conversion{{.limit = limit}, [=](const auto& value, const std::string& what) {
                      return limits::check(limit, what, value);
                    }};
}

auto rate_within(const limits::Limit& limit) {
  return Conversion{{.limit = limit}, [=](const ordered_json& value, const std::string& what) {
                      return limits::check(limit, what,
                                           value.is_string()
                                               ? parse_fraction(value.get<std::string>(), what)
                                               : value.get<double>());
                    }};
}

auto whole_within(const limits::Limit& limit) {
  return Conversion{{.limit = limit}, [=](double value, const std::string& what) {
                      return limits::check_whole(limit, what, value);
                    }};
}

auto whole_pixels() {
  return Conversion{
      {.limit = limits::pixels}, [](const std::array<double, 2>& size, const std::string& what) {
        // Braces guarantee that the width is checked before the height.
        return std::pair<int, int>{limits::check_whole(limits::pixels, what, size[0]),
                                   limits::check_whole(limits::pixels, what, size[1])};
      }};
}

auto angular_velocity() {
  return Conversion{{.limit = limits::coordinate},
                    [](const Eigen::Vector3d& omega, const std::string& what) {
                      return limits::check_omega(what, omega);
                    }};
}

/// The identity is the default, so that a scene that gives it is the same as one that does not.
auto initial_attitude() {
  return Conversion{{.limit = unit_quaternion},
                    [](const Eigen::Vector4d& quaternion,
                       const std::string& what) -> std::optional<Eigen::Quaterniond> {
                      const Eigen::Quaterniond attitude = limits::check_rotation(what, quaternion);
                      if (attitude.vec().isZero(0.0)) return std::nullopt;
                      return attitude;
                    }};
}

/// No wheel is the default, so that a scene that gives a zero one is the same as one without.
auto wheel_momentum() {
  return Conversion{{.limit = limits::angular_momentum},
                    [](const Eigen::Vector3d& momentum,
                       const std::string& what) -> std::optional<Eigen::Vector3d> {
                      if (limits::check_wheel(what, momentum).isZero(0.0)) return std::nullopt;
                      return momentum;
                    }};
}

/// An infinite time is the default: no energy is lost.
auto energy_loss_time() {
  return Conversion{{.limit = limits::energy_loss_time},
                    [](double time, const std::string& what) -> std::optional<double> {
                      if (time == std::numeric_limits<double>::infinity()) return std::nullopt;
                      return limits::check(limits::energy_loss_time, what, time);
                    }};
}

/// Vectors that distinguish the motions shown side by side.
template <typename Check>
auto compared(const limits::Limit& limit, const Check& check) {
  return Conversion{{.limit = limit, .most = limits::max_compared},
                    [check](const std::vector<Eigen::Vector3d>& vectors, const std::string& what) {
                      for (const Eigen::Vector3d& vector : vectors) check(what, vector);
                      if (vectors.size() > limits::max_compared) {
                        throw InvalidArgument(
                            what, fmt::format("has {} vectors, but at most {} motions are drawn "
                                              "side by side",
                                              vectors.size(), limits::max_compared));
                      }
                      return vectors;
                    }};
}

auto any_text() {
  return Conversion{{}, [](const std::string& text, const std::string& /*what*/) { return text; }};
}

/// A path from the current folder.
auto sound_file() {
  return Conversion{{}, [](const std::string& file, const std::string& /*what*/) {
                      return SoundFile{file, file};
                    }};
}

auto color() { return Conversion{{.names = color_names(), .is_color = true}, parse_color}; }

Texts method_names() {
  Texts names;
  for (const motion::Method& method : motion::methods()) names.emplace_back(method.name);
  return names;
}

auto method_name() {
  return Conversion{{.names = method_names()},
                    [](const std::string& name, const std::string& what) {
                      return std::string(motion::find_method(name, what).name);
                    }};
}

auto compared_methods() {
  return Conversion{{.names = method_names(), .most = limits::max_compared},
                    [](const Texts& names, const std::string& what) {
                      for (const std::string& name : names) motion::find_method(name, what);
                      if (names.size() > limits::max_compared) {
                        throw InvalidArgument(
                            what,
                            fmt::format("has {} methods, but at most {} are drawn side by side",
                                        names.size(), limits::max_compared));
                      }
                      return names;
                    }};
}

template <typename Enumeration>
auto set_of() {
  return Conversion{{.names = enumerator_names<Enumeration>()},
                    [](const Texts& names, const std::string& what) {
                      std::set<Enumeration> result;
                      for (const std::string& name : names) {
                        result.insert(find_enumerator<Enumeration>(name, what));
                      }
                      return result;
                    }};
}

}  // namespace

const std::vector<Field>& fields() {
  using enum ValueForm::Kind;
  static const std::vector<Field> all{
      natural(complete<text>(
                  {"", "title", "TEXT", "title, a caption in the picture"}, any_text(),
                  [](auto& s) -> auto& { return s.title; }),
              &Origins::title),
      language({"", "language", "TAG",
                "language of the captions, as a tag of BCP 47, and of the words in the picture"}),

      complete<vector>(
          {"motion", "omega", "X,Y,Z", "initial angular velocity in body axes, rad/s"},
          angular_velocity(), [](auto& s) -> auto& { return s.motion.omega; }),
      complete<quaternion>(
          {"motion", "attitude", "W,X,Y,Z", "initial attitude X(0), space from body: a quaternion",
           "1,0,0,0"},
          initial_attitude(), [](auto& s) -> auto& { return s.motion.attitude; }),
      without_closed_form(complete<vector>(
          {"motion", "wheel", "X,Y,Z",
           "angular momentum of a wheel relative to the body, in body axes, g cm^2/s", "none"},
          wheel_momentum(), [](auto& s) -> auto& { return s.motion.wheel; })),
      without_closed_form(complete<number>(
          {"motion", "energy_loss_time", "S",
           "time constant with which internal friction damps a small wobble about the axis of "
           "greatest moment, s; inf for none",
           "inf"},
          energy_loss_time(), [](auto& s) -> auto& { return s.motion.energy_loss_time; })),
      complete<text>(
          {"motion", "method", "NAME", "integration method"}, method_name(),
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

      complete<size>({"film", "size", "WxH", "frame size in pixels"}, whole_pixels(),
                     [](auto& s) { return std::tie(s.film.width, s.film.height); }),
      natural(complete<rate>(
                  {"film", "fps", "N",
                   "frames (and output samples) per second; may be a fraction, 30000/1001",
                   "60; samples: 60 a radian"},
                  rate_within(limits::fps), [](auto& s) -> auto& { return s.film.fps; }),
              &Origins::fps),
      natural(complete<number>(
                  {"film", "speed", "F",
                   "seconds of motion per second of video; a smaller one is slow motion",
                   "the time of a turn"},
                  within(limits::speed), [](auto& s) -> auto& { return s.film.speed; }),
              &Origins::speed),
      complete<text>(
          {"film", "audio", "FILE",
           "sound file under the video, trimmed to it or followed by silence", "none"},
          sound_file(), [](auto& s) -> auto& { return s.film.audio; }),
      choice<Sound>(
          {"film", "sound", "NAME", "sound that is synthesised"},
          [](auto& s) -> auto& { return s.film.sound; }),
      complete<number>(
          {"film", "text_fade", "S",
           "seconds of video before the end of a shot in which its text fades out",
           "text stays to the end"},
          within(limits::shot_transition), [](auto& s) -> auto& { return s.film.text_fade; }),

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
          color(), [](auto& s) -> auto& { return s.look.color; }),
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
          {"overlay", "show", "LIST", "overlays that are shown"}, set_of<Feature>(),
          [](auto& s) -> auto& { return s.overlay.show; }),
      or_nothing(complete<texts>(
          {"overlay", "stress", "LIST",
           "overlays that are drawn stronger; everything else is dimmer", "nothing"},
          set_of<Feature>(), [](auto& s) -> auto& { return s.overlay.stress; })),
      or_all(complete<texts>(
          {"overlay", "forces", "LIST", "forces that the overlays forces and tip draw", "all"},
          set_of<Force>(), [](auto& s) -> auto& { return s.overlay.forces; })),
      complete<texts>(
          {"overlay", "compare", "M1,M2,...", "show up to four methods side by side",
           "the motion's method"},
          compared_methods(), [](auto& s) -> auto& { return s.overlay.compare; }),
      complete<vectors>(
          {"overlay", "compare_omega", "X,Y,Z;...",
           "show up to four motions side by side: their initial angular velocities, rad/s",
           "the motion's omega"},
          compared(limits::coordinate, limits::check_omega),
          [](auto& s) -> auto& { return s.overlay.compare_omega; }),
      complete<vectors>(
          {"overlay", "compare_wheel", "X,Y,Z;...",
           "show up to four motions side by side: the angular momenta of their wheels, g cm^2/s",
           "the motion's wheel"},
          compared(limits::angular_momentum, limits::check_wheel),
          [](auto& s) -> auto& { return s.overlay.compare_wheel; }),
      complete<vector>(
          {"overlay", "trail_point", "X,Y,Z",
           "point that draws the trail, in the axes of the parts, cm", "the farthest point"},
          within(limits::coordinate), [](auto& s) -> auto& { return s.overlay.trail_point; }),
      complete<number>(
          {"overlay", "trail_length", "S", "seconds of motion that the trail covers",
           "the time of a 12 rad rotation"},
          within(limits::trail_length), [](auto& s) -> auto& { return s.overlay.trail_length; }),
      complete<number>(
          {"overlay", "star_trail", "S",
           "seconds of video that the trail of a star covers when the camera turns",
           "half of a frame"},
          within(limits::star_trail), [](auto& s) -> auto& { return s.overlay.star_trail; }),
      complete<text>(
          {"overlay", "font", "NAME", "font of all text: sans, mono or a font file"}, any_text(),
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

Eigen::Vector4d to_quaternion(const ordered_json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>(),
          value.at(3).get<double>()};
}

Eigen::Vector3d to_vector(const ordered_json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

}  // namespace twrench::scene
