// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// Internal to this module: the shaders of LocalTone, in their order.

// The mean of 2 x 2 pixels; at an odd edge, of those that exist.
inline constexpr std::string_view halve_shader = R"(
uniform sampler2D source;
out vec4 pixel;
void main() {
  ivec2 first = 2 * ivec2(gl_FragCoord.xy), last = textureSize(source, 0) - 1;
  ivec2 other = min(first + 1, last);
  pixel = 0.25 * (texelFetch(source, first, 0) + texelFetch(source, ivec2(other.x, first.y), 0) +
                  texelFetch(source, ivec2(first.x, other.y), 0) + texelFetch(source, other, 0));
}
)";

// Up to four Gaussian blurs at once along a row or a column, one per channel. Weights within the picture are
// normalised to a sum of 1.
inline constexpr std::string_view blur_shader = R"(
uniform sampler2D source;
uniform int down, radius;
uniform vec4 weights[9];
out vec4 pixel;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(source, 0) - 1;
  ivec2 one = down != 0 ? ivec2(0, 1) : ivec2(1, 0);
  vec4 sum = weights[0] * texelFetch(source, at, 0), whole = weights[0];
  for (int i = 1; i <= radius; ++i) {
    ivec2 after = min(at + i * one, last), before = max(at - i * one, ivec2(0));
    vec4 w_after = after == at + i * one ? weights[i] : vec4(0.0);
    vec4 w_before = before == at - i * one ? weights[i] : vec4(0.0);
    sum += w_after * texelFetch(source, after, 0) + w_before * texelFetch(source, before, 0);
    whole += w_after + w_before;
  }
  pixel = sum / whole;
}
)";

// The centre at the largest scale whose surround is like it: equations 5 to 8. sharpness: 2^phi times the
// key.
inline constexpr std::string_view choose_shader = R"(
uniform sampler2D fine, halves, quarters;
uniform float sharpness, epsilon, ratio2;
out vec4 pixel;
vec4 at_scale(sampler2D blurs, float texel) {
  return texture(blurs, gl_FragCoord.xy / (texel * vec2(textureSize(blurs, 0))));
}
void main() {
  vec4 f = texelFetch(fine, ivec2(gl_FragCoord.xy), 0);
  vec2 h = at_scale(halves, 2.0).rg;
  vec3 q = at_scale(quarters, 4.0).rgb;
  float blurs[9] = float[9](f.r, f.g, f.b, f.a, h.r, h.g, q.r, q.g, q.b);
  float chosen = blurs[0], level = sharpness;
  for (int i = 0; i < 8; ++i) {
    if (abs(blurs[i] - blurs[i + 1]) >= epsilon * (level + blurs[i])) break;
    chosen = blurs[i];
    level /= ratio2;
  }
  pixel = vec4(chosen, 0.0, 0.0, 1.0);
}
)";

}  // namespace luxel
