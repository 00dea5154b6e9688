// The body on the stage: the camera's axes, the body's centre at the origin, its bounding radius 1.

layout(location = 0) in vec3 position;  // body axes, cm
layout(location = 1) in vec3 normal;

uniform mat3 stage_from_body;
uniform mat3 stage_normal_from_body;
uniform mat4 clip_from_stage;

out vec3 stage_position;
out vec3 stage_normal;

void main() {
  stage_position = stage_from_body * position;
  stage_normal = stage_normal_from_body * normal;
  gl_Position = clip_from_stage * vec4(stage_position, 1.0);
}
