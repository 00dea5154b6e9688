// A part whose vertices have colours.
in vec3 vertex_color;  // linear

vec3 own_diffuse() { return diffuse * vertex_color; }
vec3 own_reflectance() { return mix(vec3(dielectric), base_color * vertex_color, metalness); }
