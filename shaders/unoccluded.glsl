// A part without occluders: it is fully lit.
float contact_shadow(vec3 place) { return 1.0; }
float contact_coverage(vec3 place, vec3 to_eye, float scale) { return 1.0; }
vec3 occluded(vec3 incoming, vec3 place, vec3 direction, float width_squared) { return incoming; }
