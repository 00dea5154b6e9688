#include "app/picture_options.h"

#include <fmt/format.h>

#include "app/arguments.h"
#include "scene/names.h"

namespace twrench {
namespace {

void add_film_options(SceneOptions& scene) {
  scene
      .add("--theme", "NAME", "theme: studio, paper or space",
           [](Scene& s, const std::string& text) { s.look.theme = theme_of(text, "--theme"); })
      ->default_str(name_of(Scene().look.theme));
  scene
      .add("--size", "WxH", "frame size in pixels",
           [](Scene& s, const std::string& text) {
             const Eigen::Vector2d size = parse_size(text, "--size");
             s.film.width = limits::check_whole(limits::pixels, "--size", size.x());
             s.film.height = limits::check_whole(limits::pixels, "--size", size.y());
           })
      ->default_str(fmt::format("{}x{}", Scene().film.width, Scene().film.height));
  scene
      .add("--background", "COLOR", "background: #rrggbb, #rgb, black, gray, white or transparent",
           [](Scene& s, const std::string& text) { set_background(s.look, text, "--background"); })
      ->default_str("the theme's");
  scene
      .add("--samples", "N", "MSAA samples per pixel; 1 = analytic edge antialiasing",
           [](Scene& s, const std::string& text) {
             s.look.samples =
                 limits::check_whole(limits::samples, "--samples", parse_number(text, "--samples"));
           })
      ->default_str(std::to_string(Scene().look.samples));
  scene
      .add("--motion-blur", "N", "poses averaged per frame; 1 = no motion blur",
           [](Scene& s, const std::string& text) {
             s.look.motion_blur = limits::check_whole(limits::motion_blur, "--motion-blur",
                                                      parse_number(text, "--motion-blur"));
           })
      ->default_str(std::to_string(Scene().look.motion_blur));
}

void add_material_options(SceneOptions& scene) {
  scene
      .add("--color", "COLOR", "body colour: #rrggbb, #rgb, black, gray or white",
           [](Scene& s, const std::string& text) { s.look.color = parse_color(text, "--color"); })
      ->default_str("the theme's");
  scene
      .add("--metallic", "F", "metalness of the body, 0 (paint) to 1 (metal)",
           [](Scene& s, const std::string& text) {
             s.look.metallic =
                 limits::check(limits::fraction, "--metallic", parse_number(text, "--metallic"));
           })
      ->default_str("the theme's");
  scene
      .add("--roughness", "R", "surface roughness, 0.05 (mirror) to 1 (chalk)",
           [](Scene& s, const std::string& text) {
             s.look.roughness =
                 limits::check(limits::roughness, "--roughness", parse_number(text, "--roughness"));
           })
      ->default_str("the theme's");
}

void add_overlay_options(SceneOptions& scene) {
  scene.add("--title", "TEXT", "title shown in the picture",
            [](Scene& s, const std::string& text) { s.title = text; });
  scene
      .add("--view", "NAME", "view: wrench, momentum, poinsot or quad",
           [](Scene& s, const std::string& text) { s.overlay.view = view_of(text, "--view"); })
      ->default_str(name_of(Scene().overlay.view));
  scene
      .add("--compare", "M1,M2,...", "show up to four methods side by side",
           [](Scene& s, const std::string& text) {
             s.overlay.compare = compared_methods(parse_words(text), "--compare");
           })
      ->default_str("the value of --method");
  // Declared in this order, so that --show adds to --bare.
  scene.add_flag("--bare", "show only the body; --show adds to it",
                 [](Scene& s) { s.overlay.show.clear(); });
  scene.add("--show", "LIST",
            "show also: floor, axes, momentum, omega, trail, plane, labels, hud, components, "
            "sphere, poinsot",
            [](Scene& s, const std::string& text) {
              for (const std::string& word : parse_words(text)) {
                s.overlay.show.insert(feature_of(word, "--show"));
              }
            });
  scene.add("--hide", "LIST", "hide items of the same list", [](Scene& s, const std::string& text) {
    for (const std::string& word : parse_words(text)) {
      s.overlay.show.erase(feature_of(word, "--hide"));
    }
  });
  scene
      .add("--trail-point", "X,Y,Z", "point that draws the trail, in the axes of the parts, cm",
           [](Scene& s, const std::string& text) {
             s.overlay.trail_point = limits::check(limits::coordinate, "--trail-point",
                                                   parse_vector(text, "--trail-point"));
           })
      ->default_str("the farthest point");
  scene
      .add("--trail-length", "S", "seconds of motion that the trail covers",
           [](Scene& s, const std::string& text) {
             s.overlay.trail_length = limits::check(limits::trail_length, "--trail-length",
                                                    parse_number(text, "--trail-length"));
           })
      ->default_str("the time of a 12 rad rotation");
  scene
      .add("--font", "NAME", "font of all text: sans, mono or a font file",
           [](Scene& s, const std::string& text) { s.overlay.font = text; })
      ->default_str(Scene().overlay.font);
}

void add_camera_options(SceneOptions& scene) {
  scene.add_number("--azimuth", "A", "camera azimuth, from z towards x, rad", limits::angle,
                   [](Scene& s) -> double& { return s.camera.azimuth; });
  scene.add_number("--elevation", "E", "camera elevation above the horizontal, rad",
                   limits::elevation, [](Scene& s) -> double& { return s.camera.elevation; });
  scene.add_number("--distance", "F", "camera distance; at 1 the body just fits", limits::distance,
                   [](Scene& s) -> double& { return s.camera.distance; });
  scene.add_number("--orbit", "W",
                   "angular speed of the camera around the body, rad per second of video",
                   limits::angle, [](Scene& s) -> double& { return s.camera.orbit; });
  scene.add_number("--field-of-view", "A", "field of view along the shorter side, rad",
                   limits::angle_of_view,
                   [](Scene& s) -> double& { return s.camera.field_of_view; });
}

}  // namespace

void add_picture_options(SceneOptions& scene) {
  add_film_options(scene);
  add_material_options(scene);
  add_overlay_options(scene);
  add_camera_options(scene);
}

}  // namespace twrench
