// A part without occluders: it is fully lit.
float seam(vec3 place) { return 1.0; }
float seam_coverage(vec3 place, vec3 to_eye, float scale) { return 1.0; }
float shaded(vec3 place, vec3 direction, float width_squared) { return 0.0; }
