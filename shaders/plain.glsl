// A part of one colour.
vec3 own_diffuse() { return diffuse; }
vec3 own_reflectance() { return reflectance; }
