// From linear light to sRGB: the filmic curve of Hejl and Burgess-Dawson (2010), a fit to a film
// stock that has the display's gamma in it, and so needs no power function.
vec3 filmic_srgb(vec3 light) {
  vec3 x = max(light - 0.004, 0.0);
  return (x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06);
}

// A fixed pattern of half a step of 8 bits up and down, against banding: interleaved gradient
// noise (Jimenez, SIGGRAPH 2014).
float dither(vec2 pixel) {
  return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}
