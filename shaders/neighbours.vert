// Passes on the occluders, which are the same at every vertex of a part. They are passed to the
// fragment shader as outputs, because llvmpipe reads a uniform for every pixel, but not a flat
// output.

uniform vec4 neighbours_from[neighbour_count];  // stage; an end of the axis, and the radius
// The other end; 1 for a cylinder drawn before, else 0.
uniform vec4 neighbours_to[neighbour_count];

flat out vec4 neighbour_end[neighbour_count];  // see neighbours.glsl
flat out vec4 neighbour_axis[neighbour_count];
flat out vec3 neighbour_size[neighbour_count];

void pass_on_neighbours() {
  for (int i = 0; i < neighbour_count; ++i) {
    vec3 axis = neighbours_to[i].xyz - neighbours_from[i].xyz;
    float square = dot(axis, axis);
    neighbour_end[i] = neighbours_from[i];
    neighbour_axis[i] = vec4(axis, neighbours_to[i].w);
    neighbour_size[i] = vec3(square, 1.0 / square, 1.0 / neighbours_from[i].w);
  }
}
