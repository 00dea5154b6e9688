// The dust and the craters of a body without air. Replaces matte.glsl. The relief only turns the
// normal: it is far too shallow to change the outline. Its light is a hard sun, the first of the
// studio's lights, because dust is seen as it is in space.

uniform vec3 eye;
uniform mat3 stage_from_body;

// A random number for each cell of a lattice, in integers: they are the same on all machines.
uint hash_of(ivec3 cell) {
  uvec3 c = uvec3(cell);
  uint h = c.x * 0x8da6b343u + c.y * 0xd8163841u + c.z * 0xcb1ab31fu;
  h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12u)) * 0x297a2d39u;
  return h ^ (h >> 15u);
}

float number_of(ivec3 cell) { return float(hash_of(cell) >> 8u) / 16777216.0; }

// The slope of a smooth random height between lattice points: value noise with its derivatives.
vec3 noise_slope(vec3 p) {
  ivec3 i = ivec3(floor(p));
  vec3 f = fract(p);
  vec3 u = f * f * (3.0 - 2.0 * f);
  float a = number_of(i), b = number_of(i + ivec3(1, 0, 0));
  float c = number_of(i + ivec3(0, 1, 0)), d = number_of(i + ivec3(1, 1, 0));
  float e = number_of(i + ivec3(0, 0, 1)), g = number_of(i + ivec3(1, 0, 1));
  float h = number_of(i + ivec3(0, 1, 1)), k = number_of(i + ivec3(1, 1, 1));
  float xy = a - b - c + d, yz = a - c - e + h, zx = a - b - e + g;
  float xyz = b + c + e + k - a - d - g - h;
  return 6.0 * f * (1.0 - f) *
         (vec3(b - a, c - a, e - a) + vec3(xy, yz, zx) * u.yzx + vec3(zx, xy, yz) * u.zxy +
          xyz * u.yzx * u.zxy);
}

// The slope of bowls with a raised rim, at most one in a cell of the lattice.
vec3 crater_slope(vec3 p) {
  ivec3 cell = ivec3(floor(p));
  uint h = hash_of(cell);
  vec3 middle = 0.32 + 0.36 * vec3(h & 255u, (h >> 8u) & 255u, (h >> 16u) & 255u) / 255.0;
  float radius = 0.08 + 0.13 * float(h >> 24u) / 255.0;
  vec3 from_middle = fract(p) - middle;
  float t = length(from_middle) / radius;
  float rim = smoothstep(0.8, 1.05, t);
  float slope = t * (1.0 - rim) - 0.6 * rim * (1.0 - smoothstep(1.05, 1.5, t));
  return slope * from_middle / max(t * radius, 1e-4);
}

// How much is seen of details `frequency` times smaller than the body, which has pixels this large.
float seen(float frequency, float pixel) { return 1.0 - smoothstep(0.12, 0.35, frequency * pixel); }

vec3 scattered(vec3 place, vec3 normal) {
  float radius = inversesqrt(dot(stage_from_body[0], stage_from_body[0]));
  vec3 p = radius * (place * stage_from_body);  // body axes, in radii of the body
  float pixel = length(fwidth(p));
  vec3 slope = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    float frequency = exp2(2.0 + 1.3 * float(i));
    vec3 at = frequency * p + 17.0 * float(i);
    slope += 0.8 * seen(2.0 * frequency, pixel) * crater_slope(at);
    slope += 0.3 * seen(2.0 * frequency, pixel) * noise_slope(2.0 * at);
  }
  slope = radius * (stage_from_body * slope);
  vec3 n = normalize(normal - slope + dot(slope, normal) * normal);

  // Lommel and Seeliger's law of scattering by dust. It keeps the full moon bright up to its edge.
  vec3 sun = normalize(light_centre[0]);
  float from_sun = max(dot(n, sun), 0.0);
  float to_eye = max(dot(n, normalize(eye - place)), 0.1);
  float day = smoothstep(-0.1, 0.2, dot(normal, sun));  // no lit slopes beyond the terminator
  vec3 light = 2.3 * day * from_sun / (from_sun + to_eye) * light_radiance[0] / 9.0;
  return own_diffuse() * (occluded(light, place, sun, 0.05) + 0.12 * ambient_radiance(n));
}
