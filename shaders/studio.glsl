// The studio, rectangular lights in a dark room, seen through a lobe about a direction.
//
// The lobe is (1 + r^2)^-2 / pi at the distance r, in units of its width, from its middle on a
// plane across it: with the width alpha this is the GGX distribution, and with the width 1 it is
// the clamped cosine of diffuse light (Heitz et al., "Real-Time Polygonal-Light Shading with
// Linearly Transformed Cosines", SIGGRAPH 2016). Summed over one axis it is (1 + x^2)^(-3/2) / 2,
// whose integral is x / sqrt(1 + x^2) / 2. The light of a rectangle is taken as the product of the
// shares of its two sides, exact for long strips.

// The share of the lobe about `direction` that light i fills, from `place`. The lobe is told by the
// square of its width, which comes late and is needed late.
//
// The direction meets the light's plane at (d.across, d.along) away / d.outward from the point there
// that is next to `place`, which is `away` from it. All is multiplied by `away`, and the shares of
// the two sides are brought over one denominator: roots and divisions are what a pixel waits for.
float light_share(int i, vec3 place, vec3 direction, float width_squared) {
  vec3 across = light_across[i];
  vec3 along = light_along[i];
  vec3 outward = cross(across, along);
  vec3 to_centre = light_centre[i] - place;
  float away = max(dot(to_centre, outward), 0.1);
  float ahead = max(dot(direction, outward), 0.0);  // none where it points away from the light
  vec2 middle = away * vec2(dot(direction, across), dot(direction, along)) -
                ahead * vec2(dot(to_centre, across), dot(to_centre, along));
  vec2 half_size = ahead * light_half_size[i];
  vec2 low = middle - half_size;
  vec2 high = middle + half_size;
  float wide = away * away * width_squared;
  vec2 low_root = sqrt(wide + low * low);
  vec2 high_root = sqrt(wide + high * high);
  vec2 share = high * low_root - low * high_root;
  vec2 whole = high_root * low_root;
  return 0.25 * (share.x * share.y) / (whole.x * whole.y);
}

// What the room itself sends from a direction: a dark ceiling, a brighter floor.
vec3 room(vec3 direction) {
  float height = 0.5 + 0.5 * direction.y;
  return mix(room_below, room_above, height * (2.0 - height));
}

// The light that comes to `place` through the lobe about `direction`.
vec3 arriving(vec3 place, vec3 direction, float width_squared) {
  vec3 sum = room(direction);
  for (int i = 0; i < light_count; ++i) {
    sum += light_radiance[i] * light_share(i, place, direction, width_squared);
  }
  return sum;
}
