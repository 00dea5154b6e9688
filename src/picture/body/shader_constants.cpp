#include "picture/body/shader_constants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace twrench::picture {
namespace {

// The shortest digits that read back as the same float; # keeps the decimal point, without which
// GLSL would read an integer.
std::string glsl(float value) { return fmt::format("{:#}", value); }
std::string glsl(const glm::vec2& v) { return fmt::format("vec2({:#}, {:#})", v.x, v.y); }
std::string glsl(const glm::vec3& v) {
  return fmt::format("vec3({:#}, {:#}, {:#})", v.x, v.y, v.z);
}
std::string glsl(const glm::mat3& m) {
  return fmt::format("mat3({}, {}, {})", glsl(m[0]), glsl(m[1]), glsl(m[2]));
}

template <typename Value>
std::string constant(const char* type, const char* name, const Value& value) {
  return fmt::format("const {} {} = {};\n", type, name, glsl(value));
}

/// A GLSL array with one element per light, as `of` returns it.
template <typename Of>
std::string of_lights(const char* type, const char* name, const Studio& studio, Of of) {
  std::array<std::string, Studio::light_count> values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = glsl(of(studio.lights[i]));
  return fmt::format("const {0} {1}[light_count] = {0}[light_count]({2});\n", type, name,
                     fmt::join(values, ", "));
}

}  // namespace

std::string shader_constants(const Material& material, const Studio& studio) {
  using glm::length, glm::normalize;
  using Light = const AreaLight&;
  const AmbientLight ambient = ambient_light(studio);
  return constant("vec3", "base_color", material.color) +
         constant("vec3", "diffuse", material.diffuse) +
         constant("vec3", "reflectance", material.reflectance) +
         constant("float", "roughness", material.roughness) +
         constant("float", "brushing", material.brushing) +
         constant("float", "metalness", material.metalness) +
         constant("float", "dielectric", static_cast<float>(dielectric_reflectance)) +
         constant("vec3", "room_above", studio.above) +
         constant("vec3", "room_below", studio.below) +
         constant("vec3", "room_behind", studio.behind) +
         constant("vec3", "ambient_mean", ambient.mean) +
         constant("mat3", "ambient_slope", ambient.slope) +
         fmt::format("const int light_count = {};\n", Studio::light_count) +
         of_lights("vec3", "light_centre", studio, [](Light l) { return l.centre; }) +
         of_lights("vec3", "light_across", studio, [](Light l) { return normalize(l.across); }) +
         of_lights("vec3", "light_along", studio, [](Light l) { return normalize(l.along); }) +
         of_lights("vec2", "light_half_size", studio,
                   [](Light l) { return glm::vec2(length(l.across), length(l.along)); }) +
         of_lights("vec3", "light_radiance", studio, [](Light l) { return l.radiance; });
}

}  // namespace twrench::picture
