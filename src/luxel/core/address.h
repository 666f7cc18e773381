// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace luxel {

// The address of a random number. Numbers are a pure function of their address and no shared state is drawn
// from, so the result does not depend on the order of work, on threads or on hosts.
struct RandomAddress {
  std::uint64_t seed = 0;     // the user's; replicates of a run use different ones
  std::uint32_t step = 0;     // bounce, or any other stage of an iteration
  std::uint32_t element = 0;  // patch side, pixel, ...
  std::uint64_t sample = 0;   // ray of that element in that step
};

// The finalizer of SplitMix64 (Steele, Lea, Flood 2014; constants by Stafford, variant 13): a bijection of 64
// bits whose every output bit depends on every input bit.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9u;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Purposes of random numbers, each with streams of its own: the step of an address. The solvers count their
// steps from 0; all others have numbers (four letters, mostly) that no solver reaches.
enum class RandomPurpose : std::uint32_t {
  solver = 0,           // the first step of a solver, and the pixels of a picture of a solution
  view_candidates = 0,  // of seed 0: points in front of sides
  view_directions = 1,  // of seed 0: eyes and targets
  indoor_light = 2,     // of seed 0: rays that look for the sky
  walks = 0x0c4ec000u,  // random-walk paths of the diagnostics; one stream per bounce follows
  unlit_walks = 0x0c4ed000u,
  refinement = 0x72656669u,      // seeds of the solves on refined meshes
  first_pictures = 0x66697273u,  // seeds of the first pictures of a session
  gather_rays = 0x67617468u,     // rays of the sampled method
  final_gather = 0x67617468u,    // of pictures; has the same streams by accident, and pictures depend on it
  one_way_sides = 0x6f6e6577u,   // of seed 0
  line_probes = 0x70726f62u,     // signs of the error probes of local lines
  sky_box = 0x736b7962u,         // of seed 0
  portals = 0x706f7274u,         // of seed 0
  lightmap_texels = 0x7465786cu,
  traced_sides = 0x70617468u,    // the path-traced reference: sides,
  traced_pixels = 0x76696577u,   // pixels,
  traced_points = 0x706f696eu,   // points
  probes = 0x6c757870u,          // points that measure a solution's light
  sphere_probes = 0x73706870u,   // and what arrives there from all around
  daylight_points = 0x6461796cu  // rays of points that daylight coefficients are found for
};

// Seeds for code that does not use the user's seed, or uses one derived from it.
enum class RandomSeed : std::uint64_t {
  views = 0x76696577u,       // places of views
  luminaires = 0x6c756d69u,  // places of default luminaires
  sun_power = 0x73756e70u,   // shadow rays of the energy balance
  sky_reach = 0x72656163u,   // paths that look for the sky
  lamps = 0x6c616d70u,       // added to the user's: shadow rays
  forecast = 0x666f7265u,    // a key: trial form factors
};
constexpr std::uint64_t seed_of(RandomSeed seed) { return static_cast<std::uint64_t>(seed); }

// Returns the step of an address: the first one of a stream, or the one this many after it.
constexpr std::uint32_t step_of(RandomPurpose stream, std::uint32_t after = 0) {
  return static_cast<std::uint32_t>(stream) + after;
}

// Number n of the SplitMix64 sequence that begins at a key: the key of one of many that belong together.
constexpr std::uint64_t nth_key(std::uint64_t key, std::uint64_t n) {
  return mix64(key + (n + 1) * 0x9e3779b97f4a7c15u);
}

// The key of path i of a batch.
constexpr std::uint64_t path_key(std::uint64_t batch, std::uint64_t i) { return mix64(batch ^ (i + 1)); }

// The stream of one element in one step; then one mix per pair of numbers.
constexpr std::uint64_t stream_key(std::uint64_t seed, std::uint32_t step, std::uint32_t element) {
  return mix64(nth_key(seed, 0) ^ ((static_cast<std::uint64_t>(step) << 32) | element));
}
constexpr std::uint64_t stream_key(std::uint64_t seed, RandomPurpose stream, std::uint32_t element) {
  return stream_key(seed, step_of(stream), element);
}

// Uniform in [0, 1) with 32 bits of the hash rounded to 24: never 1.
constexpr float uniform_float(std::uint32_t bits) {
  return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24f;  // signed: one instruction
}

// Four independent numbers, uniform in [0, 1), for one sample of a stream. About two nanoseconds.
constexpr std::array<float, 4> uniform4(std::uint64_t key, std::uint64_t sample) {
  const auto a = nth_key(key, 2 * sample);
  const auto b = nth_key(key, 2 * sample + 1);
  return {uniform_float(static_cast<std::uint32_t>(a)), uniform_float(static_cast<std::uint32_t>(a >> 32)),
          uniform_float(static_cast<std::uint32_t>(b)), uniform_float(static_cast<std::uint32_t>(b >> 32))};
}

constexpr std::array<float, 4> uniform4(const RandomAddress& at) {
  return uniform4(stream_key(at.seed, at.step, at.element), at.sample);
}

}  // namespace luxel
