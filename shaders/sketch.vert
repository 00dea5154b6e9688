// Lines, arrows and plain surfaces, projected and shaded on the CPU.

layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 paint;  // premultiplied
// Pixels from the centre line of a line or dot, and half its width.
layout(location = 2) in vec3 edge;

out vec4 vertex_paint;
out vec3 vertex_edge;

void main() {
  vertex_paint = paint;
  vertex_edge = edge;
  gl_Position = clip;
}
