// The diffuse (Lambertian) term of a body that is not entirely metal.
vec3 scattered(vec3 place, vec3 normal) {
  return diffuse * arriving(place, normal, 1.0) * (1.0 - shaded(place, normal, 1.0));
}
