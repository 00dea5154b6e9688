// Metal, or anything else, in a studio of soft boxes: GGX with Smith's shadowing and Schlick's
// Fresnel, in the split-sum form (Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013).

in vec3 stage_position;
in vec3 stage_normal;

uniform vec3 eye;
uniform vec3 diffuse;
uniform vec3 reflectance;
uniform float alpha;
uniform vec3 room_above;
uniform vec3 room_below;

out vec4 color;

// What the room itself sends from a direction: a dark ceiling, a brighter floor.
vec3 room(vec3 direction) {
  float height = 0.5 + 0.5 * direction.y;
  return mix(room_below, room_above, height * (2.0 - height));
}

vec3 arriving(vec3 direction, float sharpness) {
  vec3 sum = room(direction);
  for (int i = 0; i < light_count; ++i) {
    sum += light_radiance[i] * light_share(i, stage_position, direction, sharpness);
  }
  return sum;
}

// The share of even light that is reflected towards the eye: a fit to the integral of GGX, Smith
// and Schlick over the half sphere (Karis, "Physically Based Shading on Mobile", 2014).
vec3 reflected_share(float roughness, float n_v) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
  vec2 scale_bias = vec2(-1.04, 1.04) * a + r.zw;
  return reflectance * scale_bias.x + scale_bias.y;
}

void main() {
  vec3 n = normalize(stage_normal);
  vec3 to_eye = normalize(eye - stage_position);
  float n_v = clamp(dot(n, to_eye), 0.0, 1.0);
  vec3 mirrored = 2.0 * n_v * n - to_eye;

  // Normals that turn within a pixel widen the lobe, or thin bevels would sparkle (Tokuyoshi and
  // Kaplanyan, "Improved Geometric Specular Antialiasing", I3D 2019).
  vec3 turn_x = dFdx(n);
  vec3 turn_y = dFdy(n);
  float variance = min(0.5 * (dot(turn_x, turn_x) + dot(turn_y, turn_y)), 0.18);
  float width = sqrt(alpha * alpha + variance);

  // Reflection doubles the angle of the half vector, hence 2.
  vec3 light = arriving(mirrored, 0.5 / width) * reflected_share(sqrt(alpha), n_v);
  if (diffuse != vec3(0.0)) light += diffuse * arriving(n, 1.0);
  color = vec4(filmic_srgb(light) + dither(gl_FragCoord.xy), 1.0);
}
