// A metal has no diffuse term.
vec3 scattered(vec3 place, vec3 normal) { return vec3(0.0); }
