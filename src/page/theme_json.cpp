#include "page/theme_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "base/enumeration.h"
#include "picture/body/shader_constants.h"
#include "picture/look/force_style.h"
#include "picture/look/theme.h"

namespace twrench::page {
namespace {

using nlohmann::ordered_json;

ordered_json color_json(const Color& color) { return {color.red, color.green, color.blue}; }

ordered_json backdrop_json(const picture::Backdrop& backdrop) {
  return {{"above", color_json(backdrop.above)},
          {"below", color_json(backdrop.below)},
          {"vignette", backdrop.vignette},
          {"stars", backdrop.stars}};
}

ordered_json floor_json(const std::optional<picture::FloorStyle>& floor) {
  if (!floor) return nullptr;
  return {{"light", color_json(floor->light)},
          {"shadow", floor->shadow},
          {"reflection", floor->reflection},
          {"clouds", floor->clouds}};
}

ordered_json forces_json(const picture::OverlayColors& colors) {
  using enum picture::Force;
  return {{"centrifugal", color_json(color_of(centrifugal, colors))},
          {"coriolis", color_json(color_of(coriolis, colors))},
          {"constraint", color_json(color_of(constraint, colors))}};
}

ordered_json overlay_json(const picture::OverlayColors& colors) {
  ordered_json axis = ordered_json::array(), curve = ordered_json::array();
  for (const Color& color : colors.axis) axis.push_back(color_json(color));
  for (const Color& color : colors.curve) curve.push_back(color_json(color));
  return {{"text", color_json(colors.text)},   {"dim", color_json(colors.dim)},
          {"panel", color_json(colors.panel)}, {"panel_opacity", colors.panel_opacity},
          {"axis", std::move(axis)},           {"momentum", color_json(colors.momentum)},
          {"omega", color_json(colors.omega)}, {"trail", color_json(colors.trail)},
          {"plane", color_json(colors.plane)}, {"curve", std::move(curve)},
          {"forces", forces_json(colors)}};
}

/// The keys are the names of the style sheet's properties.
ordered_json page_json(const picture::ThemeStyle& style) {
  const picture::PageColors& page = style.page;
  return {{"scheme", page.is_light ? "light" : "dark"},
          {"colors",
           {{"ground", color_json(page.ground)},
            {"panel", color_json(page.panel)},
            {"raised", color_json(page.raised)},
            {"line", color_json(page.line)},
            {"control", color_json(page.control)},
            {"text", color_json(style.overlay.text)},
            {"dim", color_json(page.dim)},
            {"accent", color_json(style.overlay.momentum)},
            {"on-accent", color_json(page.on_momentum)},
            {"warn", color_json(page.warning)},
            {"second", color_json(style.overlay.omega)}}}};
}

ordered_json material_json(const scene::Look& look, const PartMaterial& part) {
  const picture::Material material = picture::material(look, part.look, part.has_own_colors);
  const glm::vec3 tint = material.diffuse + material.reflectance;
  // A channel of a picture has eight bits; more digits would only make the page larger.
  const auto rounded = [](float share) { return std::round(1e4 * double(share)) / 1e4; };
  return {{"constants", picture::shader_constants(material, picture::style_of(look.theme).studio)},
          {"metal", material.diffuse == glm::vec3(0)},
          {"rock", material.is_rock},
          {"colored", part.is_mesh},
          {"tint", {rounded(tint.x), rounded(tint.y), rounded(tint.z)}}};
}

ordered_json theme_json(scene::Look look, const Materials& materials, scene::Theme theme) {
  look.theme = theme;
  const picture::ThemeStyle& style = picture::style_of(theme);
  ordered_json kinds = ordered_json::array();
  for (const PartMaterial& part : materials.kinds) kinds.push_back(material_json(look, part));
  return {{"materials", std::move(kinds)},
          {"backdrop", backdrop_json(style.backdrop)},
          {"floor", floor_json(style.floor)},
          {"overlay", overlay_json(style.overlay)},
          {"page", page_json(style)}};
}

}  // namespace

ordered_json themes_json(const scene::Look& look, const Materials& materials) {
  ordered_json themes;
  for (const scene::Theme theme : enumerators<scene::Theme>) {
    themes[std::string(enumerator_name(theme))] = theme_json(look, materials, theme);
  }
  return themes;
}

}  // namespace twrench::page
