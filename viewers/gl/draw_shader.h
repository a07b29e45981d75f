#pragma once
// The shaders of the window: one fragment shader a Shading::Kind and one for plain colours, made from one text by a
// line in front of it that defines KIND. Software OpenGL computes both sides of every branch, so there is none in what
// draws letters and panels.

namespace glint::view {

inline constexpr const char* k_vertex_shader = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 coordinate;
layout(location = 2) in vec4 color;
uniform mat4 projection;
out vec2 at;
out vec4 tint;
void main() {
  at = coordinate;
  tint = color;
  gl_Position = projection * vec4(position, 0.0, 1.0);
}
)";

// `range` is (lo, hi, logarithmic, 0). Zero density is underflow, never the lowest colour. What is not a number or
// infinite shows as a checker that no map contains.
inline constexpr const char* k_fragment_shader = R"(
in vec2 at;
in vec4 tint;
uniform vec4 range;
uniform sampler2D values;
uniform sampler2D map;
layout(location = 0) out vec4 result;

const vec3 under = vec3(11.0, 11.0, 11.0) / 255.0;
const vec3 over = vec3(255.0, 77.0, 240.0) / 255.0;

vec3 mapped(float x) {
  return texture(map, vec2((x * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

vec3 density_color(float d) {
  if (range.z > 0.5) {
    if (!(d > 0.0)) return under;
    float x = log(d / range.x) / log(range.y / range.x);
    return x < 0.0 ? under : x > 1.0 ? over : mapped(x);
  }
  float x = (d - range.x) / (range.y - range.x);
  return x < 0.0 ? under : x > 1.0 ? over : mapped(x);
}

vec3 difference_color(float d) {
  float x = clamp(d / range.y, -1.0, 1.0);
  if (range.z > 0.5) {
    float m = abs(d);
    float y = m <= range.x ? 0.0 : clamp(log(m / range.x) / log(range.y / range.x), 0.0, 1.0);
    x = sign(d) * y;
  }
  return mapped(0.5 + 0.5 * x);
}

void main() {
#if KIND == 4
  result = tint;
}
#else
  vec4 value = texture(values, at);
#if KIND == 0
  result = tint * value;
#elif KIND == 1
  result = vec4(tint.rgb, tint.a * value.r);
#else
  if (isnan(value.r) || isinf(value.r)) {
    ivec2 square = ivec2(gl_FragCoord.xy) / 4;
    result = vec4(((square.x + square.y) & 1) == 0 ? vec3(1.0, 0.0, 0.0) : vec3(20.0 / 255.0), tint.a);
  } else {
#if KIND == 2
    result = vec4(density_color(value.r), tint.a);
#else
    result = vec4(difference_color(value.r), tint.a);
#endif
  }
#endif
}
#endif
)";

}  // namespace glint::view
