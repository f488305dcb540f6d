// What the preview has drawn of each vertex and pixel. Colours are square roots of linear light: so
// eight bits are as fine where it is dark as sRGB's, and lighting costs one root instead of powers.
#pragma once

namespace ribbon {

inline constexpr const char* cloth_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 normal;
in vec2 thread;
uniform mat4 clip_from_world;
out vec3 world_normal;
out vec2 texture_place;

void main() {
  world_normal = normal;
  texture_place = thread;
  gl_Position = clip_from_world * vec4(position, 1);
})";

inline constexpr const char* cloth_fragment_shader = R"(#version 330 core
in vec3 world_normal;
in vec2 texture_place;
uniform sampler2DArray cloth;  // front, back
uniform vec2 periods;          // of both, along the ribbon
uniform vec3 sun_direction;
uniform vec3 sun;
uniform vec3 sky_above;
uniform vec3 sky_below;
out vec4 color;

void main() {
  vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);
  vec3 light = sun * max(dot(normal, sun_direction), 0.0)
             + mix(sky_below, sky_above, 0.5 + normal.y / 3.0);
  float side = gl_FrontFacing ? 0.0 : 1.0;
  float along = texture_place.x / mix(periods.x, periods.y, side);
  vec3 thread = texture(cloth, vec3(along, texture_place.y, side)).rgb;
  color = vec4(thread * sqrt(light), 1);
})";

// A line as a band about it, as wide as it shall be on the screen and half a pixel more on both
// sides, where it fades. `before` and `after` tell its direction. It is fainter where both its
// faces look away from the eye.
inline constexpr const char* line_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 before;
in vec3 after;
in float side;             // -1, 1
in vec3 face;
in vec3 other_face;
uniform mat4 clip_from_world;
uniform vec3 eye;
uniform vec2 half_size;    // of the picture, pixels
uniform float half_width;  // pixels
uniform float forward;     // metres towards the eye, so that a line in the cloth lies on it
uniform float far_opacity;
noperspective out float across;  // pixels from the middle of the line
out float opacity;

vec4 clip(vec3 point) { return clip_from_world * vec4(point, 1); }
vec2 pixel(vec4 place) { return place.xy / place.w * half_size; }

void main() {
  vec2 way = pixel(clip(after)) - pixel(clip(before));
  vec2 along = way / max(length(way), 1e-6);
  across = side * (half_width + 0.5);
  vec3 to_eye = eye - position;
  vec4 nearer = clip(position + normalize(to_eye) * forward);
  gl_Position = clip(position);
  gl_Position.xy += vec2(-along.y, along.x) * across / half_size * gl_Position.w;
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  opacity = max(dot(face, to_eye), dot(other_face, to_eye)) >= 0.0 ? 1.0 : far_opacity;
})";

inline constexpr const char* line_fragment_shader = R"(#version 330 core
noperspective in float across;
in float opacity;
uniform float half_width;
uniform vec4 ink;
out vec4 color;

void main() { color = ink * (opacity * clamp(half_width + 0.5 - abs(across), 0.0, 1.0)); })";

}  // namespace ribbon
