// A body with a mark: see marked.glsl.
uniform vec4 mark_from_body[3];  // see MarkFromBody in src/picture/body/mark.h

// With several samples per pixel, a value that is not `centroid` is taken at the pixel's centre, which
// may lie beyond the facet's edge: the value extrapolated there may be on the mark.
centroid out vec3 mark;

void pass_on_mark(vec4 place) {
  mark = vec3(dot(mark_from_body[0], place), dot(mark_from_body[1], place),
              dot(mark_from_body[2], place));
}
