// A part whose vertices have colours.
layout(location = 3) in vec3 color;  // linear

out vec3 vertex_color;

void pass_on_color() { vertex_color = color; }
