// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace luxel {

// Where a random number lives. Nobody draws from shared state: a number is a pure function of its address, so
// the answer cannot depend on the order of work, on threads or on hosts.
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

// The stream of one element in one step; then one mix a pair of numbers.
constexpr std::uint64_t stream_key(std::uint64_t seed, std::uint32_t step, std::uint32_t element) {
  return mix64(mix64(seed + 0x9e3779b97f4a7c15u) ^ ((static_cast<std::uint64_t>(step) << 32) | element));
}

// Uniform in [0, 1) with 32 bits of the hash rounded to 24: never 1.
constexpr float uniform_float(std::uint32_t bits) {
  return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24f;  // signed: one instruction
}

// Four independent numbers, uniform in [0, 1), for one sample of a stream. About two nanoseconds.
constexpr std::array<float, 4> uniform4(std::uint64_t key, std::uint64_t sample) {
  const auto a = mix64(key + (2 * sample + 1) * 0x9e3779b97f4a7c15u);
  const auto b = mix64(key + (2 * sample + 2) * 0x9e3779b97f4a7c15u);
  return {uniform_float(static_cast<std::uint32_t>(a)), uniform_float(static_cast<std::uint32_t>(a >> 32)),
          uniform_float(static_cast<std::uint32_t>(b)), uniform_float(static_cast<std::uint32_t>(b >> 32))};
}

constexpr std::array<float, 4> uniform4(const RandomAddress& at) {
  return uniform4(stream_key(at.seed, at.step, at.element), at.sample);
}

}  // namespace luxel
