// A body that is not all metal scatters light of its own colour (Lambert).
vec3 scattered(vec3 place, vec3 normal) {
  return diffuse * arriving(place, normal, 1.0) * (1.0 - shaded(place, normal, 1.0));
}
