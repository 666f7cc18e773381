// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace luxel::scenes {

// A random number in [0, 1) with an address: the same thing at the same place gets the same number whatever
// is built before it. Mixing: splitmix64 (Steele, Lea, Flood 2014).
inline double dice(std::uint64_t what, std::uint64_t which = 0, std::uint64_t property = 0) {
  auto mix = [](std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  };
  return static_cast<double>(mix(mix(mix(what) ^ which) ^ property) >> 11) * 0x1p-53;
}

// In [low, high).
inline double dice_between(double low, double high, std::uint64_t what, std::uint64_t which = 0,
                           std::uint64_t property = 0) {
  return low + (high - low) * dice(what, which, property);
}

}  // namespace luxel::scenes
