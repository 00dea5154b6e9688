// Lines, arrows and plain surfaces, projected and shaded on the CPU.

layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 paint;  // premultiplied
// Pixels from the centre line of a line or dot, and half its width.
layout(location = 2) in vec3 edge;

uniform float opacity;
uniform float clip_z;  // added, to move everything towards the eye

out vec4 vertex_paint;
out vec3 vertex_edge;

void main() {
  vertex_paint = opacity * paint;
  vertex_edge = edge;
  gl_Position = clip + vec4(0.0, 0.0, clip_z, 0.0);
}
