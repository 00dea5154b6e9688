// The body in stage coordinates: the camera's axes, with the body's centre at the origin and its
// bounding radius scaled to 1.

layout(location = 0) in vec3 position;  // body axes, cm
layout(location = 1) in vec3 normal;
layout(location = 2) in float offset;  // half pixels along the normal on the screen

uniform mat3 stage_from_body;
uniform mat3 stage_normal_from_body;
uniform mat4 clip_from_stage;
uniform vec3 picture;  // half its size in pixels, and the pixels of an offset of 1
uniform vec3 eye;
// Depth offset towards the eye in pixels, over a part that this one touches.
uniform float part_lift;
uniform float part_radius;  // stage; radius of curvature near the silhouette
uniform vec3 side_axis;  // stage, unit vector: of the cylinder whose side this is; else 0

out vec3 stage_position;
out vec3 stage_normal;
flat out vec3 stage_eye;  // cheaper per pixel than a uniform
out float coverage;  // 1 on the body, falling to 0 across an edge quad
flat out vec4 bulge;  // offset from a facet to the exact surface, see body.frag
flat out float scale;  // pixels per unit length

void main() {
  stage_position = stage_from_body * position;
  stage_normal = stage_normal_from_body * normal;
  coverage = 1.0 - max(offset, 0.0);
  vec4 place = clip_from_stage * vec4(stage_position, 1.0);
  vec4 onward = clip_from_stage * vec4(stage_normal, 0.0);
  vec2 across = (onward.xy * place.w - place.xy * onward.w) * picture.xy;  // pixels, any length
  across *= inversesqrt(max(dot(across, across), 1e-12));
  place.xy += offset * picture.z * place.w * across / picture.xy;
  gl_Position = place;

  stage_eye = eye;
  vec3 towards_eye = eye - stage_position;
  vec3 to_eye = normalize(towards_eye);
  float pixel = 2.0 * picture.z * place.w / (clip_from_stage[1][1] * picture.y);  // stage
  scale = 1.0 / max(pixel, 1e-6);
  vec4 lifted = clip_from_stage * vec4(stage_position + part_lift * pixel * to_eye, 1.0);
  gl_Position.z = lifted.z * place.w / lifted.w;

  vec3 n = normalize(stage_normal);
  vec3 across_axis = towards_eye - dot(side_axis, towards_eye) * side_axis;
  bulge = vec4(across_axis, dot(side_axis, side_axis) * part_radius) *
          inversesqrt(max(dot(across_axis, across_axis), 1e-6));

  // Shrunk by s pixels, it shows the surface there, where on a circle of radius r the cosine
  // between normal and line of sight is sqrt(2 s / r).
  float radius = part_radius * clip_from_stage[1][1] * picture.y / place.w;
  float facing = sqrt(max(-2.0 * offset * picture.z / max(radius, 1.0), 0.0));
  stage_normal = n;
  if (offset * picture.z != 0.0) {
    stage_normal = normalize(n + max(facing - dot(n, to_eye), 0.0) * to_eye);
  }
  pass_on_neighbours();
}
