// A body that shows by its shape how it turns.
vec3 painted(vec3 metal, vec3 normal) { return metal; }
