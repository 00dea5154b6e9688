// A body of revolution looks the same however far it has turned. A stripe of paint through its
// poles, white on one side and black on the other, shows its rotation.
const float mark_half_width = 0.13;  // in radii of the body about its axis
const vec3 white_paint = vec3(0.75);
const vec3 black_paint = vec3(0.015);

vec3 painted(vec3 metal, vec3 normal) {
  // At an outline, facets seen edge-on may change by more than the whole body within a pixel.
  // Without a limit, paint would show far beside the stripe.
  vec2 pixel = clamp(fwidth(across), 1e-4, 0.5 * mark_half_width);
  float inside = clamp((mark_half_width - abs(across.y)) / pixel.y + 0.5, 0.0, 1.0);
  float side = clamp(across.x / pixel.x + 0.5, 0.0, 1.0);
  return mix(metal, mix(black_paint, white_paint, side) * ambient_radiance(normal), inside);
}
