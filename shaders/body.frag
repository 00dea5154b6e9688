// Metal or dielectric under softboxes: GGX with Smith's shadowing and Schlick's Fresnel, in the
// split-sum form (Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013).

in vec3 stage_position;
in vec3 stage_normal;
flat in vec3 stage_eye;
in float coverage;
flat in vec4 bulge;
flat in float scale;
flat in float most_variance;

out vec4 color;

// The environment BRDF, the fraction of uniform incoming radiance that is reflected towards the
// eye: a fit to the integral of GGX, Smith and Schlick over the hemisphere (Karis, "Physically
// Based Shading on Mobile", 2014).
vec3 environment_brdf(float n_v) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
  vec2 scale_bias = vec2(-1.04, 1.04) * a + r.zw;
  return own_reflectance() * scale_bias.x + scale_bias.y;
}

void main() {
  vec3 towards_eye = stage_eye - stage_position;
  // Between the vertices of a facet the interpolated normal is shorter than 1. In a cylinder of
  // radius 1 it is the position across the axis, as deep as the facet; the visible surface is where
  // its length is 1 again, t further towards the eye. Other surfaces stay where they are.
  // In triangles much narrower than a pixel, the interpolated normal may be far longer than at any
  // vertex.
  float square = dot(stage_normal, stage_normal);
  vec3 inside = stage_normal * inversesqrt(max(0.9 * square, 1.0));
  float along = dot(inside, bulge.xyz);
  float t = sqrt(max(along * along + 1.0 - square, 0.0)) - along;
  vec3 n = inside + t * bulge.xyz;
  vec3 brushed = around * inversesqrt(max(dot(around, around), 1e-12));
  n += 0.3 * brushing * scratch() * brushed;
  vec3 place = stage_position + t * bulge.w * towards_eye;
  vec3 to_eye = normalize(towards_eye);
  // Limited near grazing angles: the last half pixel of a silhouette, where the mirrored direction
  // varies rapidly, would flicker.
  float facing = dot(n, to_eye);
  float lifted = max(facing, 0.15);
  // 1 / sqrt(1 + x) to first order, where x is the small amount by which the squared length grows.
  float length_back = 1.0 - 0.5 * (lifted * lifted - facing * facing);
  n = (n + (lifted - facing) * to_eye) * length_back;
  float n_v = lifted * length_back;
  vec3 mirrored = 2.0 * n_v * n - to_eye;

  // Normals that vary within a pixel widen the lobe; otherwise thin bevels would sparkle (Tokuyoshi
  // and Kaplanyan, "Improved Geometric Specular Antialiasing", I3D 2019).
  vec3 turn_x = dFdx(n);
  vec3 turn_y = dFdy(n);
  float alpha = roughness * roughness;
  float variance = min(0.5 * (dot(turn_x, turn_x) + dot(turn_y, turn_y)), most_variance);
  // Reflection doubles the angle of the half vector, hence the factor.
  float width_squared = 4.0 * (alpha * alpha + variance);

  // The scratches scatter light perpendicular to themselves: a slope of the surface in that
  // direction turns the mirrored direction by this.
  vec3 stretch = 2.0 * brushing * (n_v * brushed + dot(brushed, to_eye) * n);
  vec3 incoming = incoming_radiance(place, mirrored, width_squared, stretch);
  vec3 reflected = occluded(incoming, place, mirrored, width_squared);
  vec3 light = painted(reflected * environment_brdf(n_v) + scattered(place, n), n);
  light *= contact_shadow(place);
  vec3 srgb = filmic_srgb(light) + dither(gl_FragCoord.xy);
  color = coverage * contact_coverage(place, to_eye, scale) * vec4(srgb, 1.0);
}
