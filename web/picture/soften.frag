// Twice the filter (1 2 1) / 4 across and down, as the film softens the floor's reflection.

uniform sampler2D sharp;

out vec4 color;

void main() {
  const float weights[5] = float[5](1.0, 4.0, 6.0, 4.0, 1.0);
  ivec2 size = textureSize(sharp, 0);
  vec4 sum = vec4(0.0);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      ivec2 at = clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y) - 2, ivec2(0), size - 1);
      sum += weights[x] * weights[y] * texelFetch(sharp, at, 0);
    }
  }
  color = sum / 256.0;
}
