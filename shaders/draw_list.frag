// Lines and dots end in a ramp one pixel wide, so that thin ones do not flicker as they move.

in vec4 vertex_paint;
in vec3 vertex_edge;

out vec4 color;

void main() {
  color = vertex_paint * clamp(vertex_edge.z + 0.5 - length(vertex_edge.xy), 0.0, 1.0);
}
