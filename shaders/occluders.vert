// Passes on the occluders, which are the same at every vertex of a part. They are passed to the
// fragment shader as outputs, because llvmpipe reads a uniform for every pixel, but not a flat
// output.

uniform vec4 occluders_from[occluder_count];  // stage; an end of the axis, and the radius
// The other end; 1 for a cylinder drawn before, else 0.
uniform vec4 occluders_to[occluder_count];
uniform vec4 occluder_tints[occluder_count];  // of the light that they reflect

flat out vec4 neighbour_end[occluder_count];  // see occluders.glsl
flat out vec4 neighbour_axis[occluder_count];
flat out vec3 neighbour_size[occluder_count];
flat out vec3 neighbour_tint[occluder_count];

void pass_on_neighbours() {
  for (int i = 0; i < occluder_count; ++i) {
    vec3 axis = occluders_to[i].xyz - occluders_from[i].xyz;
    float square = max(dot(axis, axis), 1e-8);  // a sphere's axis has no length
    neighbour_end[i] = occluders_from[i];
    neighbour_axis[i] = vec4(axis, occluders_to[i].w);
    neighbour_size[i] = vec3(square, 1.0 / square, 1.0 / occluders_from[i].w);
    neighbour_tint[i] = occluder_tints[i].rgb;
  }
}
