// Shading of a part by its occluders, other parts approximated by capsules.

flat in vec4 neighbour_end[occluder_count];  // stage; an end of the axis, and the radius
// Vector to the other end; 1 for a cylinder drawn before, else 0.
flat in vec4 neighbour_axis[occluder_count];
// Squared length of the axis; 1 over that; 1 / radius.
flat in vec3 neighbour_size[occluder_count];
flat in vec3 neighbour_tint[occluder_count];  // of the light that it reflects

// The squared distance from `place` to the point at the fraction s of the axis.
float square_to_axis(int i, vec3 place, float s) {
  vec3 to_end = neighbour_end[i].xyz - place;
  float along = dot(neighbour_axis[i].xyz, to_end);
  return max(dot(to_end, to_end) + s * (2.0 * along + s * neighbour_size[i].x), 1e-8);
}

// Returns the light from `direction` at `place`, given the light `incoming` without capsule i. To
// the degree that the capsule hides the lobe, it shows the room's light reflected once more.
vec3 behind(int i, vec3 incoming, vec3 place, vec3 direction, float width_squared) {
  vec3 axis = neighbour_axis[i].xyz;
  vec3 to_end = neighbour_end[i].xyz - place;
  float radius = neighbour_end[i].w;
  // The point of the axis closest to the ray: the foot of the common normal of two lines. A ray
  // that leads away from the axis is closest to it at its start.
  float along = dot(axis, direction);
  float foot = -dot(axis, to_end) * neighbour_size[i].y;
  float approach = max(dot(to_end + foot * axis, direction), 0.0);
  float s = clamp(foot + along * approach / (1.2 * neighbour_size[i].x - along * along), 0.0, 1.0);
  float square = square_to_axis(i, place, s);
  float ahead = dot(to_end, direction) + s * along;
  float aside_squared = max(square - ahead * max(ahead, 0.0), 0.0);
  float aside = sqrt(aside_squared);
  // Behind `place`, the effect decreases with distance.
  float miss = aside - (radius + min(ahead, 0.0));
  float hidden = 1.0 - smoothstep(0.0, 1.0, 0.5 + 0.5 * miss * inversesqrt(square * width_squared));
  // The normal where the ray enters the capsule (length `radius`) or passes it (length `aside`).
  float depth = ahead - sqrt(max(radius * radius - aside_squared, 0.0));
  vec3 normal = depth * direction - (to_end + s * axis);
  vec3 tint = is_of_one_material ? reflectance : neighbour_tint[i];
  return mix(incoming, tint * ambient_radiance(normal / max(aside, radius)), hidden);
}

// The contact shadow: the fraction of light that remains close to where another part begins.
float contact_shadow(vec3 place) {
  float left = 1.0;
  for (int i = 0; i < occluder_count; ++i) {
    vec3 to_end = neighbour_end[i].xyz - place;
    float s = clamp(-dot(neighbour_axis[i].xyz, to_end) * neighbour_size[i].y, 0.0, 1.0);
    float gap = sqrt(square_to_axis(i, place, s)) * neighbour_size[i].z - 1.0;
    left *= 1.0 - 0.12 * exp2(-9.0 * max(gap, 0.0));
  }
  return left;
}

// The fraction of a pixel outside the cylinders that this part touches. Where the part enters one,
// it fades over the width of a pixel, which avoids a jagged edge. It does not fade near the
// cylinder's silhouette, where the shrunk cylinder is not behind the fading part, nor over more
// than two pixels, as for a face seen edge-on.
float contact_coverage(vec3 place, vec3 to_eye, float scale) {
  float outside = 1.0;
  for (int i = 0; i < occluder_count; ++i) {
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

// Returns the light from `direction` at `place`; `incoming` is the light without occluders.
vec3 occluded(vec3 incoming, vec3 place, vec3 direction, float width_squared) {
  for (int i = 0; i < occluder_count; ++i) {
    incoming = behind(i, incoming, place, direction, width_squared);
  }
  return incoming;
}
