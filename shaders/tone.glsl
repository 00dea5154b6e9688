// From linear light to sRGB: the filmic curve of Hejl and Burgess-Dawson (2010), a fit to a film
// stock that includes the display's gamma and needs no power function. It is scaled so that a
// radiance of 2.5 or more is white; otherwise a highlight of 5 would end at 244.
vec3 filmic_srgb(vec3 light) {
  vec3 x = max(light - 0.004, 0.0);
  vec3 above = x * (6.675 * x + 0.5383);
  vec3 below = x * (6.2 * x + 1.7) + 0.06;
  float each = 1.0 / (below.r * below.g * below.b);  // one division for all three
  return above * vec3(below.g * below.b, below.b * below.r, below.r * below.g) * each;
}

// Avoids banding: the background's 2 x 2 pattern, up and down by quarter steps of 8 bits.
float dither(vec2 pixel) {
  vec2 f = fract(0.5 * pixel);  // a quarter on even pixels, three quarters on odd ones
  return (2.0 * f.x + 2.5 * f.y - 4.0 * f.x * f.y - 1.25) / 255.0;
}
