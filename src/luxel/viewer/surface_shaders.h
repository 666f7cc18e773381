// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// Private to this module. Defines select the paint of a program: LIGHT, LIGHT and LOCAL, LIGHT and INPUT,
// SMOOTH, PATCHES, SIDES, WIRES; none: grey.

inline constexpr std::string_view surface_vertex_shader = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 front_value;
layout(location = 2) in vec3 back_value;
uniform mat4 projection;
uniform vec3 eye;
#if defined(LIGHT) || defined(SMOOTH)
centroid out vec3 front, back;  // narrow triangles are not read beyond their borders
#elif !defined(WIRES)
out vec3 at;
#endif
void main() {
  gl_Position = projection * vec4(place, 1.0);
#if defined(LIGHT) || defined(SMOOTH)
  front = front_value;
  back = back_value;
#elif !defined(WIRES)
  at = place - eye;
#endif
#ifdef WIRES
  gl_Position.z -= 2e-5 * gl_Position.w;
#endif
}
)";

// The tone curves of image/tone.cpp; tests compare the two. Stands before the fragment shaders that show
// radiance. Defines: LOCAL, or INPUT for what the local operator measures.
inline constexpr std::string_view tone_shader = R"(
uniform int curve;  // 0: linear, 1: Reinhard, 2: neutral
uniform float tone_scale, white, brightest;
#ifdef LOCAL
uniform sampler2D around;
uniform ivec2 from;
#endif
vec3 neutral(vec3 scaled) {
  const float start = 0.76;
  float peak = max(scaled.r, max(scaled.g, scaled.b));
  if (peak <= start) return scaled;
  float shown = 1.0 - (1.0 - start) * (1.0 - start) / (peak + 1.0 - 2.0 * start);
  return mix(scaled * (shown / peak), vec3(shown), 1.0 - 1.0 / (0.15 * (peak - shown) + 1.0));
}
vec4 toned(vec3 radiance) {
  float L = tone_scale * dot(radiance, vec3(0.2126, 0.7152, 0.0722));
#ifdef INPUT
  return vec4(min(L, brightest), 0.0, 0.0, 1.0);
#else
#ifdef LOCAL
  float V = texelFetch(around, ivec2(gl_FragCoord.xy) + from, 0).r;
#else
  float V = L;
#endif
  float burn_out = white > 0.0 ? 1.0 + L / (white * white) : 1.0;
  float factor = curve == 1 ? tone_scale * burn_out / (1.0 + V) : tone_scale;
  return vec4(curve == 2 ? neutral(factor * radiance) : min(factor * radiance, vec3(1.0)), 1.0);
#endif
}
)";

// After tone_shader. False colours are those of viewer/colour_map.cpp.
inline constexpr std::string_view surface_fragment_shader = R"(
out vec4 pixel;
#ifdef LIGHT
centroid in vec3 front, back;
void main() { pixel = toned(max(gl_FrontFacing ? front : back, vec3(0.0))); }
#elif defined(SMOOTH) || defined(PATCHES)
uniform float low, high;
uniform int logarithmic, isolines;
uniform sampler2D colours;
vec3 false_colour(float value) {
  float share = (value - low) / (high - low);
  if (logarithmic != 0) share = value > 0.0 ? log(value / low) / log(high / low) : 0.0;
  vec3 colour = texture(colours, vec2((clamp(share, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
#ifdef SMOOTH
  if (isolines > 0) {
    float place = share * float(isolines + 1);
    float line = abs(fract(place + 0.5) - 0.5) / max(fwidth(place), 1e-6);
    float inside = step(0.5, place) * step(place, float(isolines) + 0.5);
    float ink = inside * (1.0 - smoothstep(0.6, 1.4, line));
    float lum = dot(colour, vec3(0.2126, 0.7152, 0.0722));
    colour = mix(colour, lum > 0.2 ? vec3(0.0) : vec3(1.0), 0.85 * ink);
  }
#endif
  return colour;
}
#ifdef SMOOTH
centroid in vec3 front, back;
void main() { pixel = vec4(false_colour(gl_FrontFacing ? front.x : back.x), 1.0); }
#else
uniform sampler2D values;
in vec3 at;
void main() {
  int width = textureSize(values, 0).x;
  vec2 both = texelFetch(values, ivec2(gl_PrimitiveID % width, gl_PrimitiveID / width), 0).rg;
  float value = gl_FrontFacing ? both.x : both.y;
  pixel = vec4(isnan(value) ? vec3(0.2) : false_colour(value), 1.0);
}
#endif
#elif defined(WIRES)
uniform vec3 ink;
void main() { pixel = vec4(ink, 1.0); }
#else
in vec3 at;
void main() {
  vec3 across = cross(dFdx(at), dFdy(at));
  float facing = abs(dot(across, at)) * inversesqrt(dot(across, across) * dot(at, at));
#ifdef SIDES
  vec3 paint = gl_FrontFacing ? vec3(0.10, 0.28, 0.72) : vec3(0.72, 0.09, 0.06);
#else
  vec3 paint = vec3(0.6);
#endif
  pixel = vec4(paint * (0.55 + 0.45 * facing), 1.0);
}
#endif
)";

}  // namespace luxel
