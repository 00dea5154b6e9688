// Metal brushed away from a cylinder's axis: fine scratches along its side and, on its caps, from
// the centre to the rim. They depend only on the angle about the axis and therefore show how the
// part turns.

const float scratches_of_quarter = 61.0;
const float scratch_step = 17.0 / 244.0;  // 17 / (scratches in a turn): they repeat after a turn

centroid in vec2 across;  // position across the cylinder's axis, in its radii; 0 in other shapes
in vec3 around;  // stage; perpendicular to the axis and to `across`

// Returns the height of the scratches, -0.5 to 0.5, at this angle. The position on a square
// replaces an arc tangent. The squares of integers times a fraction, modulo one, serve as random
// numbers.
float scratch() {
  float share = across.x / max(abs(across.x) + abs(across.y), 1e-6);
  float quarters = across.y < 0.0 ? 3.0 + share : 1.0 - share;
  float place = quarters * scratches_of_quarter;
  float number = floor(place);
  vec2 height = fract(vec2(number * number, (number + 1.0) * (number + 1.0)) * scratch_step);
  float seen = clamp(1.5 - fwidth(place), 0.0, 1.0);  // none where they are finer than a pixel
  return seen * (mix(height.x, height.y, smoothstep(0.0, 1.0, place - number)) - 0.5);
}
