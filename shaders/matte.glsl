// The diffuse (Lambertian) term of a body that is not entirely metal.
vec3 scattered(vec3 place, vec3 normal) {
  return own_diffuse() *
         occluded(incoming_radiance(place, normal, 1.0, vec3(0.0)), place, normal, 1.0);
}
