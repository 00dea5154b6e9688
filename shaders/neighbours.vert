// The parts near by, the same at every vertex of a part. They go on to the pixels as outputs: a
// uniform is fetched anew for every pixel by llvmpipe, an output that does not vary is not.

uniform vec4 neighbours_from[neighbour_count];  // see neighbours.glsl
uniform vec4 neighbours_to[neighbour_count];

flat out vec4 neighbour_from[neighbour_count];
flat out vec4 neighbour_to[neighbour_count];

void pass_on_neighbours() {
  neighbour_from = neighbours_from;
  neighbour_to = neighbours_to;
}
