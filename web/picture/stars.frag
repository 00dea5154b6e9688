in vec4 glow;

out vec4 color;

void main() {
  vec2 away = (2.0 * gl_PointCoord - 1.0) * glow.w;
  color = vec4(glow.rgb * exp(-dot(away, away)), 0.0);
}
