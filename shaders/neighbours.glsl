// Shading of a part by its occluders, other parts approximated by capsules.

flat in vec4 neighbour_end[neighbour_count];  // stage; an end of the axis, and the radius
// To the other end; 1 for a cylinder drawn before, else 0.
flat in vec4 neighbour_axis[neighbour_count];
// Squared length of the axis; 1 over that; 1 / radius.
flat in vec3 neighbour_size[neighbour_count];

// The squared distance from `place` to the point at the fraction s of the axis.
float square_to_axis(int i, vec3 place, float s) {
  vec3 to_end = neighbour_end[i].xyz - place;
  float along = dot(neighbour_axis[i].xyz, to_end);
  return max(dot(to_end, to_end) + s * (2.0 * along + s * neighbour_size[i].x), 1e-8);
}

// The occlusion, 0 to 1, of a lobe about `direction` at `place` by capsule i, from the angle by
// which the direction misses it.
float hidden_by(int i, vec3 place, vec3 direction, float width_squared) {
  vec3 axis = neighbour_axis[i].xyz;
  vec3 to_end = neighbour_end[i].xyz - place;
  // The point of the axis closest to the ray: the foot of the common normal of two lines.
  float along = dot(axis, direction);
  float end_ahead = dot(to_end, direction);
  float s = clamp((along * end_ahead - dot(axis, to_end)) /
                      max(neighbour_size[i].x - along * along, 1e-4), 0.0, 1.0);
  float square = square_to_axis(i, place, s);
  float ahead = end_ahead + s * along;
  float aside = sqrt(max(square - ahead * max(ahead, 0.0), 0.0));
  // Behind `place`, the effect decreases with distance.
  float miss = aside - (neighbour_end[i].w + min(ahead, 0.0));
  return 1.0 - smoothstep(0.0, 1.0, 0.5 + 0.5 * miss * inversesqrt(square * width_squared));
}

// The contact shadow: the fraction of light that remains close to where another part begins.
float seam(vec3 place) {
  float left = 1.0;
  for (int i = 0; i < neighbour_count; ++i) {
    vec3 to_end = neighbour_end[i].xyz - place;
    float s = clamp(-dot(neighbour_axis[i].xyz, to_end) * neighbour_size[i].y, 0.0, 1.0);
    float gap = sqrt(square_to_axis(i, place, s)) * neighbour_size[i].z - 1.0;
    left *= 1.0 - 0.45 * exp2(-9.0 * max(gap, 0.0));
  }
  return left;
}

// The fraction of a pixel outside the cylinders that this part touches. Where it enters one, it
// fades over the width of a pixel, so that there is no jagged edge; but not near the cylinder's
// silhouette, where the shrunk cylinder is not behind the fading part, nor over more than two
// pixels, as for a face seen edge-on.
float seam_coverage(vec3 place, vec3 to_eye, float scale) {
  float outside = 1.0;
  for (int i = 0; i < neighbour_count; ++i) {
    vec3 axis = neighbour_axis[i].xyz;
    vec3 to_end = neighbour_end[i].xyz - place;
    float s = -dot(axis, to_end) * neighbour_size[i].y;
    float closeness = inversesqrt(square_to_axis(i, place, s));
    float gap = scale * (1.0 / closeness - neighbour_end[i].w);
    float facing = -closeness * (dot(to_end, to_eye) + s * dot(axis, to_eye));
    float within = 0.5 * scale * neighbour_end[i].w * facing * max(facing, 0.0);
    float seen = smoothstep(0.0, 1.0, 0.8 * within - 0.6);  // from 0.75 to 2 pixels
    float share = clamp(gap / clamp(fwidth(gap), 1e-3, 2.0) + 0.5, 0.0, 1.0);
    bool beside = s > 0.0 && s < 1.0;
    outside *= beside ? mix(1.0, share, seen * neighbour_axis[i].w) : 1.0;
  }
  return outside;
}

float shaded(vec3 place, vec3 direction, float width_squared) {
  float open = 1.0;
  for (int i = 0; i < neighbour_count; ++i) {
    open *= 1.0 - hidden_by(i, place, direction, width_squared);
  }
  return 1.0 - open;
}
