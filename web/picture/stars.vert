// Stars: soft dots at an infinite distance.

layout(location = 0) in vec3 direction;
layout(location = 1) in vec2 look;  // brightness and tint

uniform mat3 camera_rows;  // the rows of camera_from_space as columns
uniform vec4 lens;  // projection: x and y scale, x and y shift
uniform float height;  // of the picture in pixels

out vec4 glow;  // colour, 0 to 1, and the size of the dot in radii

void main() {
  vec3 seen = direction * camera_rows;
  float true_radius = height / 1080.0 * (0.75 + 0.6 * look.x);
  float radius = max(0.8, true_radius);
  gl_PointSize = 2.0 * ceil(3.0 * radius) + 1.0;
  glow = vec4((40.0 + 190.0 * look.x) / 255.0 * min(1.0, true_radius / radius) * vec3(1.0, look.y, 1.0),
              0.5 * gl_PointSize / radius);
  gl_Position = seen.z < 0.0 ? vec4(lens.x * seen.x + lens.z * seen.z, lens.y * seen.y + lens.w * seen.z, 0.0, -seen.z)
                             : vec4(2.0, 2.0, 2.0, 1.0);
}
