// What other parts near by, taken for capsules, hide of the light that comes to a part.

flat in vec4 neighbour_from[neighbour_count];  // stage; an end of the axis, and the radius
flat in vec4 neighbour_to[neighbour_count];    // the other end; 1 for a cylinder drawn before, else 0

// How much of a lobe of that width about `direction` capsule i hides from `place`: 0 to 1, by how
// far the direction misses it, seen as an angle.
float hidden_by(int i, vec3 place, vec3 direction, float width) {
  vec3 axis = neighbour_to[i].xyz - neighbour_from[i].xyz;
  vec3 to_end = neighbour_from[i].xyz - place;
  // The point of the axis that the ray passes nearest: the feet of the common normal of two lines.
  float along = dot(axis, direction);
  float s = (along * dot(to_end, direction) - dot(axis, to_end)) /
            max(dot(axis, axis) - along * along, 1e-4);
  vec3 to_axis = to_end + clamp(s, 0.0, 1.0) * axis;
  float closeness = inversesqrt(dot(to_axis, to_axis));
  float ahead = dot(to_axis, direction);
  // Of what lies behind, the farther the less.
  float miss = closeness * (length(to_axis - max(ahead, 0.0) * direction) - neighbour_from[i].w -
                            min(ahead, 0.0));
  return 1.0 - smoothstep(-width, width, miss);
}

// What is left of the light close to where another part begins: there it comes by way of two
// surfaces.
float seam(vec3 place) {
  float left = 1.0;
  for (int i = 0; i < neighbour_count; ++i) {
    vec3 axis = neighbour_to[i].xyz - neighbour_from[i].xyz;
    vec3 to_end = neighbour_from[i].xyz - place;
    float s = clamp(-dot(axis, to_end) / dot(axis, axis), 0.0, 1.0);
    float gap = length(to_end + s * axis) / neighbour_from[i].w - 1.0;
    left *= 1.0 - 0.45 * exp2(-9.0 * max(gap, 0.0));
  }
  return left;
}

// How much of a pixel lies outside the cylinders that this part meets: where it enters one, it
// fades over the width of a pixel, and there is no jagged edge. Not towards the cylinder's outline:
// there, drawn in, it does not lie behind what fades.
float seam_coverage(vec3 place, vec3 to_eye) {
  float outside = 1.0;
  for (int i = 0; i < neighbour_count; ++i) {
    vec3 axis = neighbour_to[i].xyz - neighbour_from[i].xyz;
    vec3 to_end = neighbour_from[i].xyz - place;
    float s = -dot(axis, to_end) / dot(axis, axis);
    vec3 from_axis = -(to_end + s * axis);
    float gap = length(from_axis) - neighbour_from[i].w;
    float seen = smoothstep(0.2, 0.4, dot(normalize(from_axis), to_eye));
    float share = clamp(gap / max(fwidth(gap), 1e-6) + 0.5, 0.0, 1.0);
    bool beside = s > 0.0 && s < 1.0;
    outside *= beside ? mix(1.0, share, seen * neighbour_to[i].w) : 1.0;
  }
  return outside;
}

float shaded(vec3 place, vec3 direction, float width) {
  float open = 1.0;
  for (int i = 0; i < neighbour_count; ++i) {
    open *= 1.0 - hidden_by(i, place, direction, width);
  }
  return 1.0 - open;
}
