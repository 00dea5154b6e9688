// The area-light integral: incoming radiance of the studio, rectangular lights in a dark room,
// weighted by a lobe about a direction.
//
// The lobe is (1 + r^2)^-2 / pi at distance r from its centre, in units of its width, on a plane
// perpendicular to it: with the width alpha this is the GGX distribution, and with the width 1 the
// clamped cosine of diffuse light (Heitz et al., "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines", SIGGRAPH 2016). Integrated over one axis it is (1 + x^2)^(-3/2) / 2, whose
// integral is x / sqrt(1 + x^2) / 2. The integral over a rectangle is approximated by the product
// of the integrals over its two sides, which is exact for long strips.

// The fraction of the lobe about `direction` that light i covers, from `place`. The lobe is given
// by its squared width, which is available late and needed late. Along `stretch` it is wider: its
// squared width is then larger by the square of that vector's component.
//
// The direction meets the light's plane at (d.across, d.along) away / d.outward from the foot of
// the perpendicular from `place`, whose length is `away`. Everything is multiplied by `away`, and
// the fractions of the two sides have a common denominator, because square roots and divisions
// dominate the cost of a pixel.
float area_light_integral(int i, vec3 place, vec3 direction, float width_squared, vec3 stretch) {
  vec3 across_light = light_across[i];
  vec3 along = light_along[i];
  vec3 outward = cross(across_light, along);
  vec3 to_centre = light_centre[i] - place;
  float away = max(dot(to_centre, outward), 0.1);
  float ahead = max(dot(direction, outward), 0.0);  // none if it points away from the light
  vec2 middle = away * vec2(dot(direction, across_light), dot(direction, along)) -
                ahead * vec2(dot(to_centre, across_light), dot(to_centre, along));
  vec2 half_size = ahead * light_half_size[i];
  vec2 low = middle - half_size;
  vec2 high = middle + half_size;
  vec2 stretched = vec2(dot(stretch, across_light), dot(stretch, along));
  vec2 wide = away * away * (width_squared + stretched * stretched);
  vec2 low_root = sqrt(wide + low * low);
  vec2 high_root = sqrt(wide + high * high);
  vec2 share = high * low_root - low * high_root;
  vec2 whole = high_root * low_root;
  return 0.25 * (share.x * share.y) / (whole.x * whole.y);
}

// The radiance of the room itself from a direction: a dark ceiling, a brighter floor, and a light
// within 60 degrees of the direction away from the camera.
vec3 room(vec3 direction) {
  float height = 0.5 + 0.5 * direction.y;
  float behind = max(-2.0 * direction.z - 1.0, 0.0);
  return mix(room_below, room_above, height * (2.0 - height)) + behind * behind * room_behind;
}

// The incoming radiance at `place`, weighted by the lobe about `direction`.
vec3 incoming_radiance(vec3 place, vec3 direction, float width_squared, vec3 stretch) {
  vec3 sum = room(direction);
  for (int i = 0; i < light_count; ++i) {
    sum += light_radiance[i] * area_light_integral(i, place, direction, width_squared, stretch);
  }
  return sum;
}

// The radiance of the whole studio, so blurred that it varies linearly with the direction. Some
// arrives from all sides.
vec3 ambient_radiance(vec3 direction) {
  return max(ambient_mean + ambient_slope * direction, 0.3 * ambient_mean);
}
