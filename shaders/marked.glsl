// A body that would look the same at several attitudes has paint that shows how it has turned, white
// on one side and black on the other: see MarkFromBody in src/picture/body/mark.h.
const vec3 white_paint = vec3(0.75);
const vec3 black_paint = vec3(0.015);

centroid in vec3 mark;

vec3 painted(vec3 metal, vec3 normal) {
  vec3 distances = vec3(mark.x, mark.z + mark.y, mark.z - mark.y);
  // At an outline, facets seen edge-on may change by more than the whole body within a pixel.
  // Without a limit, paint would show far beside the mark.
  vec3 covered = clamp(distances / clamp(fwidth(distances), 1e-4, 0.065) + 0.5, 0.0, 1.0);
  vec3 paint = mix(black_paint, white_paint, covered.x);
  return mix(metal, paint * ambient_radiance(normal), covered.y * covered.z);
}
