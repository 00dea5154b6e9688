#include "scene/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/color.h"
#include "base/enumeration.h"
#include "body/dimensions.h"
#include "mesh/mesh_file.h"
#include "recording/conventions/convention.h"
#include "scene/dimensions.h"
#include "scene/materials.h"
#include "scene/scene.h"

namespace twrench::scene {
namespace {

/// "tube_radius" as words: "tube radius".
std::string words_of(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

Key dimension_key(const body::Dimension& dimension) {
  using enum ValueForm::Kind;
  const bool is_vector = dimension.values.size() > 1;
  Key key{.name = dimension.key,
          .help = words_of(dimension.key) + (is_vector ? " along x, y and z, cm" : ", cm"),
          .form = {is_vector ? vector : number, limit_of(dimension)},
          .is_required = !dimension.may_be_zero};
  if (dimension.greater != nullptr) key.help += "; less than the " + dimension.greater_key;
  if (dimension.may_be_zero) key.value = 0;
  return key;
}

std::vector<Key> dimension_keys(body::Shape shape) {
  std::vector<Key> keys;
  for (const body::Dimension& dimension : body::dimensions(shape)) {
    keys.push_back(dimension_key(dimension));
  }
  return keys;
}

ValueForm form_of(const recording::Field& field) {
  switch (field.form) {
    case recording::FieldForm::flag:
      return {ValueForm::Kind::flag};
    case recording::FieldForm::rotation:
      return {ValueForm::Kind::quaternion, unit_quaternion};
    case recording::FieldForm::text:
    case recording::FieldForm::unasked:
      break;
  }
  return {ValueForm::Kind::text, {}, field.words};
}

Key convention_key(const recording::Field& field) {
  // After a colon, the help lists the words, which are the names of the form.
  const std::size_t end = field.words.empty() ? std::string::npos : field.help.rfind(": ");
  return {.name = field.name,
          .help = "of the recording: " + field.help.substr(0, end),
          .form = form_of(field),
          .otherwise = field.otherwise};
}

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  std::ranges::transform(shape_keys(), std::back_inserter(names), &ShapeKeys::shape);
  return names;
}

}  // namespace

const std::vector<Key>& mesh_keys() {
  using enum ValueForm::Kind;
  static const std::vector<Key> all{
      {.name = "file",
       .help =
           "path of an OBJ, STL, PLY, glTF, COLLADA or 3MF file, from the folder of the scene file",
       .form = {text},
       .is_required = true},
      {.name = "unit",
       .help = "unit of the file",
       .form = {text, {}, mesh::unit_names()},
       .otherwise =
           "metres for glTF, that of the file for COLLADA and 3MF; other formats need it or scale"},
      {.name = "scale",
       .help = "centimetres per unit of the file",
       .form = {number, limits::mesh_scale},
       .instead_of = "unit"},
      {.name = "weld",
       .help = "vertices no farther apart than this are joined, cm",
       .form = {number, limits::length_or_none},
       .value = 0},
      {.name = "shell",
       .help = "thickness of a thin wall along the surface, cm",
       .form = {number, limits::length},
       .otherwise = "a solid"},
      {.name = "crease",
       .help = "largest angle between triangles that are drawn as one smooth surface, rad",
       .form = {number, limits::crease},
       .value = PartLook().crease_angle},
  };
  return all;
}

const std::vector<ShapeKeys>& shape_keys() {
  static const std::vector<ShapeKeys> all = [] {
    std::vector<ShapeKeys> keys;
    for (const body::Shape& shape : body::all_shapes()) {
      const bool is_mesh = std::holds_alternative<body::Mesh>(shape);
      keys.push_back({body::shape_name(shape), is_mesh ? mesh_keys() : dimension_keys(shape)});
      if (std::holds_alternative<body::Ellipsoid>(shape)) {
        keys.push_back({"sphere",
                        {{.name = "radius",
                          .help = "radius, cm",
                          .form = {ValueForm::Kind::number, limits::length},
                          .is_required = true}}});
      }
    }
    return keys;
  }();
  return all;
}

const std::vector<Key>& part_keys() {
  using enum ValueForm::Kind;
  static const std::vector<Key> all{
      {.name = "name",
       .help = "name of the part; parts with the same name belong together",
       .form = {text}},
      {.name = "shape", .help = "shape", .form = {text, {}, shape_names()}, .is_required = true},
      {.name = "density", .help = "density, g/cm^3", .form = {number, limits::density}},
      {.name = "mass",
       .help = "mass, g, instead of the density",
       .form = {number, limits::mass},
       .instead_of = "density"},
      {.name = "position",
       .help = "position of the shape's own origin, cm",
       .form = {vector, limits::coordinate},
       .value = {0, 0, 0}},
      {.name = "axis",
       .help = "direction of the shape's own z axis, of any length but zero",
       .form = {vector, limits::coordinate},
       .value = {0, 0, 1}},
      {.name = "rotation",
       .help = "rotation of the shape as axis times angle, rad, instead of axis",
       .form = {vector, limits::coordinate},
       .instead_of = "axis"},
      {.name = "material",
       .help = "material, which sets colour, metalness and roughness",
       .form = {text, {}, material_names()},
       .otherwise = "that of [look]"},
      {.name = "color",
       .help = "colour: #rrggbb, #rgb, black, gray or white",
       .form = {text, {}, color_names(), true},
       .otherwise = "that of the material or of [look]"},
      {.name = "metallic",
       .help = "metalness, 0 (paint) to 1 (metal)",
       .form = {number, limits::fraction},
       .otherwise = "that of the material or of [look]"},
      {.name = "roughness",
       .help = "surface roughness, 0.05 (mirror) to 1 (chalk)",
       .form = {number, limits::roughness},
       .otherwise = "that of the material or of [look]"},
  };
  return all;
}

const std::vector<Key>& body_keys() {
  using enum ValueForm::Kind;
  static const std::vector<Key> all{
      {.name = "moments",
       .help = "principal moments of inertia about the body's axes, g cm^2",
       .form = {vector, limits::moment}},
      {.name = "inertia",
       .help = "inertia matrix about the centre of mass, g cm^2, by rows; its products of inertia "
               "are the entries of the matrix: Ixy is minus the integral of x y dm",
       .form = {vectors, limits::matrix_entry, {}, false, 3, 3},
       .instead_of = "moments"},
      {.name = "shape",
       .help = "solid with this inertia that is drawn, along the principal axes",
       .form = {text, {}, enumerator_names<Equimomental>()},
       .value = enumerator_name(Body().drawn_as)},
  };
  return all;
}

const std::vector<Key>& shot_keys() {
  using enum ValueForm::Kind;
  static const std::vector<Key> all{
      {.name = "length",
       .help = "duration of the shot, s of video",
       .form = {number, limits::shot_length},
       .is_required = true},
      {.name = "caption", .help = "text at the bottom of the picture", .form = {text}, .value = ""},
      {.name = "fade",
       .help = "time at the start of the shot in which the previous one fades into it, s of video",
       .form = {number, limits::shot_transition},
       .value = 0},
      {.name = "move",
       .help = "time at the start of the shot in which the camera comes from the previous shot's "
               "place, s of video",
       .form = {number, limits::shot_transition},
       .value = 0},
      {.name = "speed",
       .help = "seconds of motion per second of video: a number, or pairs of a time in the shot, "
               "s, and the speed then",
       .form = {number, limits::shot_speed},
       .otherwise = "that of [film]"},
      {.name = "narration",
       .help = "path of a sound file that starts with the shot, from the folder of the scene file",
       .form = {text},
       .otherwise = "none"},
      {.name = "start",
       .help =
           "time of the motion at the start of the shot, s, or \"match\": the time at which the "
           "body is seen most nearly as the previous shot ended",
       .form = {number, limits::shot_start},
       .otherwise = "the end of the previous shot of the same motion, or 0"},
  };
  return all;
}

const std::vector<Key>& recording_keys() {
  static const std::vector<Key> all = [] {
    using enum ValueForm::Kind;
    std::vector<Key> keys{
        {.name = recording_file_key,
         .help =
             "path of a file of times and attitudes, rates or both, from the folder of the scene "
             "file: the recorded motion that the scene shows",
         .form = {text}},
        {.name = "from",
         .help = "leave out the rows of the recording before this time, s since the first row",
         .form = {number, limits::coordinate},
         .otherwise = "the first row"},
        {.name = "to",
         .help = "leave out the rows of the recording after this time, s since the first row",
         .form = {number, limits::coordinate},
         .otherwise = "the last row"},
        {.name = "smooth",
         .help = "whether to show the smoothest motion within the noise of the recording",
         .form = {flag},
         .value = false}};
    for (const recording::Field& field : recording::convention_fields()) {
      if (field.form != recording::FieldForm::unasked) keys.push_back(convention_key(field));
    }
    return keys;
  }();
  return all;
}

const Key& key_named(const std::vector<Key>& keys, std::string_view name) {
  const auto found = std::ranges::find(keys, name, &Key::name);
  if (found == keys.end()) throw std::out_of_range(fmt::format("no key {} is declared", name));
  return *found;
}

}  // namespace twrench::scene
