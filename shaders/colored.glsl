// A part whose vertices have colours.
in vec3 vertex_color;  // linear

vec3 own_diffuse() { return (1.0 - metalness) * vertex_color; }
vec3 own_reflectance() { return mix(vec3(dielectric), vertex_color, metalness); }
