// Lines, arrows and plain surfaces, projected and lit before they come here.

layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 paint;  // premultiplied
layout(location = 2) in vec3 edge;   // pixels from the middle of a line or dot, and half its width

out vec4 vertex_paint;
out vec3 vertex_edge;

void main() {
  vertex_paint = paint;
  vertex_edge = edge;
  gl_Position = clip;
}
