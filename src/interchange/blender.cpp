#include "interchange/blender.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/words.h"
#include "interchange/track.h"

namespace twrench::interchange {
namespace {

// Blender's limits of RenderSettings.fps_base and of Scene.frame_end.
constexpr double slowest_rate = 1e-6;  // frames per second
constexpr double most_frames = 1'048'574;

// The name comes after the second line, up to which Python looks for the coding of the file.
constexpr const char* script_head =
    R"(# Written by {generator} as an animation for Blender 3.4 or later.
#
# It is the rotation of {name}.
#
# Run it with "blender SCENE.blend -P THIS_FILE.py", or open it in Blender's Scripting workspace. It
# animates the object that OBJECT names. If there is none, it makes an empty with three arrows; make it the
# parent of objects that shall turn. The axes of the object are those of the body, and the axes of the world
# are those of space. It replaces earlier keys of the object's quaternion, the frame rate of the scene and its
# range of frames, and changes nothing else.
#
# A second of the animation is {speed} s of the motion. Between the keys, Blender's rotation is nowhere more
# than {max_angle} rad from {source}.

import bpy

OBJECT = "twrench"
FPS, FPS_BASE = {fps}, {base}  # FPS frames in FPS_BASE seconds
LAST_FRAME = {last}
KEYS = [  # the frame, and the quaternion w, x, y, z that turns the axes of space to those of the body
)";

constexpr const char* script_end = R"(]


def curves():
    """Return the curves of the object's animation, which Blender keeps in a slot since 4.4."""
    animation = body.animation_data
    if animation is None or animation.action is None:
        return []
    slot = getattr(animation, "action_slot", None)
    if slot is None:
        return animation.action.fcurves
    return animation.action.layers[0].strips[0].channelbag(slot).fcurves


def curves_of_rotation():
    return [curve for curve in curves() if curve.data_path == "rotation_quaternion"]


body = bpy.data.objects.get(OBJECT)
if body is None:
    body = bpy.data.objects.new(OBJECT, None)
    body.empty_display_type = "ARROWS"
    bpy.context.scene.collection.objects.link(body)
body.rotation_mode = "QUATERNION"
for curve in curves_of_rotation():
    curves().remove(curve)

# One key makes the curves of the four components, and the others are added to them at once.
body.keyframe_insert("rotation_quaternion", frame=KEYS[0][0])
for curve in curves_of_rotation():
    points = curve.keyframe_points
    points.add(len(KEYS) - 1)
    points.foreach_set("co", [number for key in KEYS for number in (key[0], key[1 + curve.array_index])])
    for point in points:
        point.interpolation = "LINEAR"
    curve.update()

scene = bpy.context.scene
scene.render.fps, scene.render.fps_base = FPS, FPS_BASE
scene.frame_start, scene.frame_end = 0, LAST_FRAME
scene.frame_set(0)
)";

void require_frames(const scene::Scene& scene, double last) {
  const double rate = scene.film.fps;
  if (rate < slowest_rate) {
    throw InvalidArgument(scene.name,
                          fmt::format("its frame rate is {} per second, but Blender's is at least "
                                      "{}",
                                      rate, slowest_rate),
                          "choose a higher frame rate: " + argument("fps"));
  }
  if (last <= most_frames) return;
  throw InvalidArgument(
      scene.name,
      fmt::format("it has {:.0f} frames, but Blender has at most {}", last, most_frames),
      fmt::format("choose a greater {}, or a smaller {} or {}", argument("speed"), argument("fps"),
                  argument("duration")));
}

std::string script_source(const scene::Scene& scene) {
  if (scene.motion.recording) return "the recorded motion";
  return "the exact motion";
}

}  // namespace

// Keys are exact in frames, Blender's unit of time, because the time of the animation is theirs.
void write_blender_script(const scene::Scene& scene, const AnimationOptions& options,
                          const std::string& generator,
                          const std::function<void(std::string_view)>& write) {
  const double rate = scene.film.fps;
  const double last = scene.motion.duration / options.speed * rate;
  require_frames(scene, last);
  const PlayedMotion played(scene::free_body(scene), options.speed / rate, last,
                            scene.motion.control.stop, scene.motion.recording);
  const Track track = attitude_track(played, last, options.max_angle, "frames");
  const double whole_rate = std::ceil(rate);
  const std::string name =
      nlohmann::json(scene.name).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  write(fmt::format(fmt::runtime(script_head), fmt::arg("generator", generator),
                    fmt::arg("name", name), fmt::arg("speed", options.speed),
                    fmt::arg("max_angle", options.max_angle),
                    fmt::arg("source", script_source(scene)), fmt::arg("fps", whole_rate),
                    fmt::arg("base", whole_rate / rate), fmt::arg("last", std::lround(last))));
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    const float* const q = &track.rotations[4 * i];
    write(fmt::format("    ({}, {}, {}, {}, {}),\n", track.times[i], q[3], q[0], q[1], q[2]));
  }
  write(script_end);
}

}  // namespace twrench::interchange
