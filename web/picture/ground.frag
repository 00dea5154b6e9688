// What is behind the body: the theme's gradient (src/picture/look/background.cpp) and the floor with
// its pool of light, the body's shadow and its reflection (src/draw/floor.cpp).

const int most_balls = 64;

in vec2 place;

uniform vec3 above;  // the gradient's colours, sRGB, 0 to 255
uniform vec3 below;
uniform float vignette;
uniform vec2 picture;  // its size in pixels
uniform vec4 inner;  // 1 where another picture adjoins: left, right, bottom, top
uniform float floor_share;  // how much there is of the floor, 0 to 1
uniform vec3 floor_light;
uniform vec3 floor_style;  // shadow, reflection, clouds
uniform mat3 floor_from_place;
uniform vec4 right_and_height;  // the camera's right along the floor; the floor's height in radii
uniform vec4 balls[most_balls];  // in radii, relative to the floor's middle; a radius
uniform int ball_count;
uniform sampler2D reflection;

out vec4 color;

float dithered(vec2 pixel) {
  vec2 f = fract(0.5 * floor(pixel));
  return -0.375 + f.x + 1.5 * f.y - 3.0 * f.x * f.y;
}

vec3 gradient(vec2 at) {
  float depth = smoothstep(0.15, 0.85, 0.5 - 0.5 * at.y - 0.10 * at.x * at.x);
  vec3 shade = mix(above, below, depth);
  return shade - vignette * at.x * at.x * shade.g;
}

float falloff(float distance_squared) {
  float share = 1.0 / (1.0 + distance_squared);
  return share * share;
}

float fade(vec2 at) {
  vec4 way = smoothstep(vec4(0.0), vec4(0.15), 0.5 + 0.5 * vec4(at.x, -at.x, at.y, -at.y));
  vec4 shown = mix(vec4(1.0), way, inner);
  return shown.x * shown.y * shown.z * shown.w;
}

// Clouds in the polish: waves of several lengths in all directions.
float clouds(vec2 at) {
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    float frequency = 7.0 + 2.5 * float(i);
    float angle = 2.4 * float(i);
    sum += sin(frequency * (cos(angle) * at.x + sin(angle) * at.y) + angle);
  }
  return clamp(0.5 + sum / 8.0, 0.0, 1.0);
}

// The fraction of the light from above that the balls leave.
float open_sky(vec2 at) {
  float open = 1.0;
  for (int i = 0; i < most_balls; ++i) {
    if (i >= ball_count) break;
    vec4 ball = balls[i];
    if (ball.y <= 0.0) continue;
    vec2 across = at - ball.xz;
    float squared = dot(across, across) + max(ball.y * ball.y, ball.w * ball.w);
    float cosine = ball.y * ball.y / squared;
    open *= max(1.0 - 5.0 * cosine * cosine * (1.0 - sqrt(1.0 - ball.w * ball.w / squared)), 0.0);
  }
  return open;
}

void main() {
  vec3 shade = gradient(place);
  vec3 on_floor = floor_from_place * vec3(place, 1.0);
  if (floor_share > 0.0 && on_floor.z > 0.0) {
    vec2 at = on_floor.xy / on_floor.z;
    vec2 right = right_and_height.xy;
    vec2 from_eye = vec2(dot(right, at), dot(vec2(right.y, -right.x) / 2.0, at)) / 0.7;
    float shown = floor_share * fade(place);
    shade += falloff(dot(from_eye, from_eye)) * shown * floor_light;
    float near = falloff(dot(at, at) / (1.3 * 1.3));
    float left = 1.0;
    if (floor_style.z > 0.0) left -= floor_style.z * near * clouds(at);
    float shadow = 1.0 - left * (1.0 - floor_style.x * (1.0 - open_sky(at)));
    vec4 mirrored = floor_style.y * near * texture(reflection, 0.5 + 0.5 * place);
    mirrored.a += (1.0 - mirrored.a) * shadow;
    mirrored *= shown;
    shade = 255.0 * mirrored.rgb + (1.0 - mirrored.a) * shade;
  }
  vec2 pixel = vec2(gl_FragCoord.x, picture.y - gl_FragCoord.y);
  color = vec4((shade + dithered(pixel)) / 255.0, 1.0);
}
