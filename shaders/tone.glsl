// From linear light to sRGB: the filmic curve of Hejl and Burgess-Dawson (2010), a fit to a film
// stock that includes the display's gamma and needs no power function. It is scaled so that
// highlights roll off: a radiance of 2.5 ends at 243, one of 5 at 251, and only one of 8 is white.
vec3 filmic_srgb(vec3 light) {
  vec3 x = max(1.1 * light - 0.0044, 0.0);
  vec3 above = x * (6.324 * x + 0.51);
  vec3 below = x * (6.2 * x + 1.7) + 0.06;
  float each = 1.0 / (below.r * below.g * below.b);  // one division for all three
  return above * vec3(below.g * below.b, below.b * below.r, below.r * below.g) * each;
}

// Avoids banding: the background's 2 x 2 pattern, up and down by quarter steps of 8 bits.
float dither(vec2 pixel) {
  vec2 f = fract(0.5 * pixel);  // a quarter on even pixels, three quarters on odd ones
  return (2.0 * f.x + 2.5 * f.y - 4.0 * f.x * f.y - 1.25) / 255.0;
}
