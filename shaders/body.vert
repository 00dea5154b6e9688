// The body in stage coordinates: the camera's axes, with the body's centre at the origin and its
// bounding radius scaled to 1.

layout(location = 0) in vec3 position;  // body axes, cm
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 shift;  // see Shift in silhouette.h
// For edge quads: transparency, and a depth offset towards the eye in pixels. Otherwise 0.
layout(location = 4) in vec2 fade;

uniform mat3 stage_from_body;
uniform mat3 stage_normal_from_body;
uniform mat4 clip_from_stage;
uniform vec3 picture;  // half its size in pixels, and the pixels of an offset of 1
uniform vec3 eye;
// Depth offset towards the eye in pixels, over a part that this one touches.
uniform float part_lift;
uniform float part_is_solid;  // 0 for foil on another part, else 1
// Radii of curvature in the stage: near the silhouette; the same if the outline is round, else 0;
// of a cylinder's rims, else 0.
uniform vec3 part_radii;
// The position across the axis of a shape of revolution in its radii, from body axes; else 0.
uniform vec4 across_from_body[2];
uniform vec3 side_axis;  // stage, unit vector: of the cylinder whose side this is; else 0

out vec3 stage_position;
out vec3 stage_normal;
flat out vec3 stage_eye;  // cheaper per pixel than a uniform
out float coverage;  // 1 on the body, falling to 0 across an edge quad
flat out vec4 bulge;  // offset from a facet to the exact surface, see body.frag
flat out float scale;  // pixels per unit length
flat out float most_variance;  // of the normal within a pixel
// See brush.glsl.
centroid out vec2 across;
out vec3 around;

void main() {
  stage_position = stage_from_body * position;
  stage_normal = stage_normal_from_body * normal;
  float offset = shift.w;
  coverage = 1.0 - fade.x;
  vec4 place = clip_from_stage * vec4(stage_position, 1.0);
  vec4 onward = clip_from_stage * vec4(stage_normal_from_body * shift.xyz, 0.0);
  vec2 outward = (onward.xy * place.w - place.xy * onward.w) * picture.xy;  // pixels, any length
  outward *= max(length(shift.xyz), 1.0) * inversesqrt(max(dot(outward, outward), 1e-12));
  stage_eye = eye;
  vec3 towards_eye = eye - stage_position;
  vec3 to_eye = normalize(towards_eye);
  vec3 n = normalize(stage_normal);
  // On a round shape, the vertices of the silhouette are moved to the outline: on a circle of
  // radius r a point with the cosine c between normal and line of sight lies r c^2 / 2 inside.
  vec3 radii = part_radii * clip_from_stage[1][1] * picture.y / place.w;  // pixels
  float cosine = dot(n, to_eye);
  // Foil fades where it is seen almost edge-on. A print would be lines of dots there.
  coverage *= max(part_is_solid, smoothstep(0.02, 0.1, cosine));
  float inside = abs(offset) < 1.0 ? 0.0 : min(0.5 * radii.y * cosine * cosine, 1.0);
  place.xy += (offset + 2.0 * inside) * picture.z * place.w * outward / picture.xy;
  gl_Position = place;

  float pixel = 2.0 * picture.z * place.w / (clip_from_stage[1][1] * picture.y);  // stage
  scale = 1.0 / max(pixel, 1e-6);
  vec4 lifted = clip_from_stage * vec4(stage_position + (part_lift + fade.y) * pixel * to_eye, 1.0);
  gl_Position.z = lifted.z * place.w / lifted.w;

  vec3 across_axis = towards_eye - dot(side_axis, towards_eye) * side_axis;
  bulge = vec4(across_axis, dot(side_axis, side_axis) * part_radii.x) *
          inversesqrt(max(dot(across_axis, across_axis), 1e-6));
  // The strips at a cylinder's outline may be much narrower than a pixel, so the curvature limits
  // the variance, not the normals at their ends.
  float turn = bulge.w > 0.0 ? pixel / (0.15 * part_radii.x) : 1.0;
  most_variance = min(0.5 * turn * turn, 0.25);

  across = vec2(dot(across_from_body[0], vec4(position, 1.0)),
                dot(across_from_body[1], vec4(position, 1.0)));
  around = stage_normal_from_body *
           (across.x * across_from_body[1].xyz - across.y * across_from_body[0].xyz);
  vec3 radial = stage_normal_from_body *
                (across.x * across_from_body[0].xyz + across.y * across_from_body[1].xyz);
  radial *= inversesqrt(max(dot(radial, radial), 1e-12));
  vec3 end_normal = stage_normal_from_body *
                    cross(across_from_body[0].xyz, across_from_body[1].xyz);
  end_normal *= sign(dot(end_normal, n)) * inversesqrt(max(dot(end_normal, end_normal), 1e-12));

  // A surface shrunk by s pixels shows the points s pixels inside the outline, where on a circle of
  // radius r the cosine between normal and line of sight is sqrt(2 s / r). A rim curves so sharply
  // that its outermost part, narrower than a pixel, would glitter. The whole edge quad therefore
  // shows what is inside it. If the whole rim appears narrower than that, the end face is inside
  // it. The strips of a cylinder's side turn by up to 2 sqrt(0.3 / r).
  bool on_rim = part_radii.z > 0.0 && (abs(dot(n, radial)) < 0.99 ||
                                       cosine < -sqrt(0.35 / max(radii.x, 1.0)));
  float within = on_rim ? abs(offset) : max(-offset, 0.0);
  float radius = on_rim ? radii.z : radii.x;
  float facing = sqrt(min(2.0 * within * picture.z / max(radius, 1.0), 0.8));
  float end_cosine = dot(end_normal, to_eye);
  float side_cosine = dot(radial, to_eye);
  stage_normal = n;
  if (on_rim && end_cosine > 0.0 && end_cosine <= facing) {
    stage_normal = end_normal;
  } else if (offset * picture.z != 0.0) {
    stage_normal = normalize(n + max(facing - cosine, 0.0) * to_eye);
  }
  // At the outline of the side, a rim that appears as narrow as a pixel shows the side; otherwise
  // it would be a line of dots.
  if (on_rim && picture.z > 0.0 && end_cosine < 0.0 && side_cosine > 0.0) {
    float seen_width = radii.z * (1.0 + end_cosine * inversesqrt(end_cosine * end_cosine +
                                                                 side_cosine * side_cosine));
    stage_normal = normalize(mix(radial, stage_normal, smoothstep(1.0, 2.0, seen_width)));
  }
  pass_on_color();
  pass_on_mark(vec4(position, 1.0));
  pass_on_neighbours();
}
