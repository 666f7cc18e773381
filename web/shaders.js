// SPDX-License-Identifier: Apache-2.0
// The light of each lamp lies in a texture, a layer per lamp. A vertex sums it with the weights of the sliders; a pixel
// applies colour and texture of the surface, then the tone curve or false colours.

export const lightWidth = 2048; // texels, of the light's texture
export const maxLevels = 16; // lines of equal light

export const vertexShader = `
precision highp float;
precision highp int;
precision highp sampler2DArray;
in vec3 position;
in float number;
uniform mat4 projectionMatrix, modelViewMatrix;
uniform sampler2DArray light;
uniform vec3 weights[GROUPS];
uniform int vertices;
uniform float unit;
centroid out vec4 front, back; // narrow triangles are not read beyond their borders
#ifdef COLOURED
in vec3 reflecting, emitting;
centroid out vec3 reflected, emitted;
#endif
#if SETS > 0
in vec2 place0;
out vec2 at0;
#endif
#if SETS > 1
in vec2 place1;
out vec2 at1;
#endif
#if SETS > 2
in vec2 place2;
out vec2 at2;
#endif
vec4 light_at(int place) {
  vec4 sum = vec4(0.0);
  for (int g = 0; g < GROUPS; ++g)
    sum += vec4(weights[g], weights[g].g) * texelFetch(light, ivec3(place % ${lightWidth}, place / ${lightWidth}, g), 0);
  return unit * sum;
}
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  front = light_at(int(number));
  back = light_at(int(number) + vertices);
#ifdef COLOURED
  reflected = reflecting;
  emitted = emitting;
#endif
#if SETS > 0
  at0 = place0;
#endif
#if SETS > 1
  at1 = place1;
#endif
#if SETS > 2
  at2 = place2;
#endif
}`;

// Tone curves are those of image/tone.cpp.
const toning = `vec3 encoded(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
vec3 neutral(vec3 scaled) {
  const float start = 0.76;
  float peak = max(scaled.r, max(scaled.g, scaled.b));
  if (peak <= start) return scaled;
  float top = 1.0 - (1.0 - start) * (1.0 - start) / (peak + 1.0 - 2.0 * start);
  return mix(scaled * (top / peak), vec3(top), 1.0 - 1.0 / (0.15 * (peak - top) + 1.0));
}
vec3 toned(vec3 c) {
  if (curve == 2) return encoded(neutral(tone_scale * max(c, vec3(0.0))));
  float L = tone_scale * dot(c, luminance);
  float burn_out = white > 0.0 ? 1.0 + L / (white * white) : 1.0;
  float factor = curve == 1 ? tone_scale * burn_out / (1.0 + L) : tone_scale;
  return encoded(min(factor * c, vec3(1.0)));
}
`;

// A logarithm to base 2 in two bytes, 1 to 65535 for 2^-32 to 2^32.
const coding = `vec2 bytes_of(float value) {
  float code = floor(clamp((log2(value) + 32.0) * 1024.0, 1.0, 65535.0) + 0.5);
  return vec2(floor(code / 256.0), mod(code, 256.0)) / 255.0;
}
`;

// REFLECTANCE_AT and others: at0, at1 or at2.
export const fragmentShader = `
precision highp float;
precision highp int;
centroid in vec4 front, back;
#ifdef COLOURED
centroid in vec3 reflected, emitted;
#else
const vec3 reflected = vec3(1.0), emitted = vec3(1.0);
#endif
#if SETS > 0
in vec2 at0;
#endif
#if SETS > 1
in vec2 at1;
#endif
#if SETS > 2
in vec2 at2;
#endif
#ifdef REFLECTANCE_AT
uniform sampler2D reflectance_picture;
uniform float reflectance_scale;
#endif
#ifdef EMITTANCE_AT
uniform sampler2D emittance_picture;
uniform float emittance_scale;
#endif
#ifdef CUTOUT_AT
uniform sampler2D cutout_picture;
uniform float threshold;
#endif
layout(location = 0) out vec4 pixel;
uniform vec3 reflectance, emittance;
uniform bool reflects_behind;
uniform int show;   // 0: light, 1: false colours, 2: radiance as codes, 3: measured light as codes
uniform int curve;  // 0: linear, 1: Reinhard, 2: neutral
uniform bool logarithmic, isolines;
uniform float tone_scale, white, low, high;
uniform float levels[${maxLevels}];
uniform int level_count;
uniform vec4 measure;
uniform sampler2D colours;
const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
vec3 in_gamut(vec3 c) {
  float L = dot(c, luminance), least = min(c.r, min(c.g, c.b));
  if (L <= 0.0) return vec3(0.0);
  return least < 0.0 ? mix(vec3(L), c, L / (L - least)) : c;
}
vec3 radiance() {
  vec3 reflects = reflected * reflectance, emits = emitted * emittance;
#ifdef REFLECTANCE_AT
  reflects *= reflectance_scale * texture(reflectance_picture, REFLECTANCE_AT).rgb;
#endif
#ifdef EMITTANCE_AT
  emits *= emittance_scale * texture(emittance_picture, EMITTANCE_AT).rgb;
#endif
  vec3 leaving = gl_FrontFacing ? emits + reflects * front.rgb : reflects_behind ? reflects * back.rgb : vec3(0.0);
  return in_gamut(leaving / 3.14159265359);
}
${toning}float share_of(float value) {
  return logarithmic ? (value > 0.0 ? log(value / low) / log(high / low) : 0.0) : (value - low) / (high - low);
}
vec3 false_colour(float value) {
  float share = share_of(value);
  vec3 colour = texture(colours, vec2((clamp(share, 0.0, 1.0) * 8.0 + 0.5) / 9.0, 0.5)).rgb;
  float width = max(fwidth(share), 1e-6), ink = 0.0;
  if (isolines)
    for (int i = 0; i < level_count; ++i) ink = max(ink, 1.0 - smoothstep(0.5, 1.3, abs(share - levels[i]) / width));
  return mix(colour, dot(colour, luminance) > 0.45 ? vec3(0.0) : vec3(1.0), 0.7 * ink);
}
${coding}void main() {
#ifdef CUTOUT_AT
  if (texture(cutout_picture, CUTOUT_AT).r < threshold) discard;
#endif
  float measured = dot(gl_FrontFacing ? front : back, measure);
  if (show == 1) {
    pixel = vec4(false_colour(measured), 1.0);
    return;
  }
  if (show == 3) {
    pixel = vec4(measured > 0.0 ? bytes_of(measured) : vec2(0.0), 0.0, 1.0);
    return;
  }
  vec3 c = radiance();
  if (show == 0) {
    pixel = vec4(toned(c), 1.0);
    return;
  }
  float L = dot(c, luminance);
  pixel = L > 0.0 ? vec4(bytes_of(L), bytes_of(max(c.r, max(c.g, c.b)))) : vec4(0.0, 0.0, 0.0, 1.0 / 255.0);
}`;

// Openings of luminaires: bodies with a radiance, which surfaces hide but where these lie less than 5 mm before them.
export const bodyVertexShader = `
precision highp float;
in vec3 position, colour;
uniform mat4 projectionMatrix, modelViewMatrix;
uniform vec3 eye;
out vec3 radiance;
void main() {
  vec3 way = eye - position;
  vec4 nearer = projectionMatrix * modelViewMatrix * vec4(position + way * min(0.5, 5e-3 / max(length(way), 1e-6)), 1.0);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z = (nearer.z / nearer.w - 1e-6) * gl_Position.w;  // some steps of the depth buffer, long ones far away
  radiance = colour;
}`;

export const bodyFragmentShader = `
precision highp float;
precision highp int;
in vec3 radiance;
layout(location = 0) out vec4 pixel;
uniform int show, curve;  // as in the surfaces' shader
uniform float tone_scale, white;
const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
${toning}${coding}void main() {
  if (max(radiance.r, max(radiance.g, radiance.b)) <= 0.0) discard;
  pixel = show == 2 ? vec4(bytes_of(dot(radiance, luminance)), bytes_of(max(radiance.r, max(radiance.g, radiance.b))))
                    : vec4(toned(radiance), 1.0);
}`;

// Lines of photometric solids: sRGB codes.
export const wireVertexShader = `
precision highp float;
in vec3 position, colour;
uniform mat4 projectionMatrix, modelViewMatrix;
out vec3 ink;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  ink = colour;
}`;

export const wireFragmentShader = `
precision highp float;
in vec3 ink;
layout(location = 0) out vec4 pixel;
void main() { pixel = vec4(ink, 1.0); }`;

// A triangle over the whole picture, behind all surfaces.
export const skyVertexShader = `
precision highp float;
in vec3 position;
uniform mat4 from_screen;
out vec3 ray;
void main() {
  vec4 near = from_screen * vec4(position.xy, -1.0, 1.0), far = from_screen * vec4(position.xy, 1.0, 1.0);
  ray = far.xyz / far.w - near.xyz / near.w;
  gl_Position = vec4(position.xy, 1.0, 1.0);
}`;

// As render/sky_look.cpp shows a uniform sky. ground: its radiance, relative to that of the sky.
export const skyFragmentShader = `
precision highp float;
precision highp int;
in vec3 ray;
layout(location = 0) out vec4 pixel;
uniform vec3 sky, zenith;
uniform int curve;
uniform float ground, tone_scale, white;
const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
${toning}
void main() {
  float height = dot(normalize(ray), zenith);
  vec3 look = height < 0.0 ? vec3(mix(1.0, ground, min(1.0, -height / 0.06)))
                           : mix(vec3(0.20, 0.40, 0.80), vec3(1.0), pow(1.0 - min(1.0, height), 5.0));
  pixel = vec4(toned(look * sky), 1.0);
}`;
