// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cstdint>

#include "luxel/core/address.h"

namespace luxel {

namespace detail {

inline constexpr int sobol_dimensions = 8;

// XORs of direction numbers, four index bits at a time, each number with its bits reversed.
using SobolTable = std::array<std::array<std::array<std::uint32_t, 16>, 8>, sobol_dimensions>;

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = ((x & 0x0000ffffu) << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

// Primitive polynomials and first direction numbers of Joe and Kuo 2008 (new-joe-kuo-6).
constexpr SobolTable make_sobol_table() {
  struct Polynomial {
    int degree;
    std::uint32_t inner;  // coefficients between the first and the last
    std::array<std::uint32_t, 5> first;
  };
  constexpr std::array<Polynomial, sobol_dimensions> polynomials = {{{0, 0, {}},
                                                                     {1, 0, {1}},
                                                                     {2, 1, {1, 3}},
                                                                     {3, 1, {1, 3, 1}},
                                                                     {3, 2, {1, 1, 1}},
                                                                     {4, 1, {1, 1, 3, 3}},
                                                                     {4, 4, {1, 3, 5, 13}},
                                                                     {5, 2, {1, 1, 5, 5, 17}}}};
  SobolTable table{};
  for (std::size_t d = 0; d < sobol_dimensions; ++d) {
    const auto& p = polynomials[d];
    std::array<std::uint32_t, 32> direction{};
    for (int i = 0; i < 32; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (p.degree == 0) {
        direction[at] = 1u << (31 - i);
      } else if (i < p.degree) {
        direction[at] = p.first[at] << (31 - i);
      } else {
        const auto before = direction[static_cast<std::size_t>(i - p.degree)];
        direction[at] = before ^ (before >> p.degree);
        for (int k = 1; k < p.degree; ++k)
          if ((p.inner >> (p.degree - 1 - k)) & 1u)
            direction[at] ^= direction[static_cast<std::size_t>(i - k)];
      }
    }
    for (std::size_t nibble = 0; nibble < 8; ++nibble)
      for (std::size_t value = 0; value < 16; ++value)
        for (std::size_t bit = 0; bit < 4; ++bit)
          if ((value >> bit) & 1u) table[d][nibble][value] ^= reverse_bits(direction[4 * nibble + bit]);
  }
  return table;
}

inline constexpr SobolTable sobol_table = make_sobol_table();

}  // namespace detail

// Points of the Sobol sequence, scrambled as Owen 1995 does: any 2^k points that begin at a multiple of 2^k
// are spread evenly over the elementary boxes of that size, and each point on its own is uniform. So
// neighbours in the sequence complement each other, and an average over 2^k of them errs by less than one
// over independent numbers: with variance near n^-3 where the integrand is smooth, never much above 1/n.
// Different keys give independent scramblings: replicates. Pairs (0, 1) are the best projections.
//
// Random access: `at` is a pure function of key, index and dimension. Scrambling by hashing (Laine and Karras
// 2011; constants by Vegdahl 2021; Burley 2020). About 5 ns per number.
class OwenSobol {
 public:
  static constexpr int dimensions = detail::sobol_dimensions;

  explicit constexpr OwenSobol(std::uint64_t key) {
    for (std::size_t d = 0; d < dimensions; d += 2) {
      const auto bits = nth_key(key, d);
      seeds_[d] = static_cast<std::uint32_t>(bits);
      seeds_[d + 1] = static_cast<std::uint32_t>(bits >> 32);
    }
  }

  // Uniform in [0, 1). dimension: 0 to 7.
  constexpr float at(std::uint32_t index, int dimension) const {
    return number(raw(index, dimension), seed(dimension));
  }

  // Dimensions 0 to 3.
  constexpr std::array<float, 4> first4(std::uint32_t index) const {
    return {at(index, 0), at(index, 1), at(index, 2), at(index, 3)};
  }

  // The two halves of at(), for callers that need many numbers. `raw` is the same for every key, and raw(i +
  // j) = raw(i) ^ raw(j) where i and j have no bit in common.
  static constexpr std::uint32_t raw(std::uint32_t index, int dimension) {
    assert(dimension >= 0 && dimension < dimensions);
    std::uint32_t x = 0;
    for (std::size_t nibble = 0; nibble < 8; ++nibble)
      x ^= detail::sobol_table[static_cast<std::size_t>(dimension)][nibble][(index >> (4 * nibble)) & 15u];
    return x;
  }
  constexpr std::uint32_t seed(int dimension) const { return seeds_[static_cast<std::size_t>(dimension)]; }
  static constexpr float number(std::uint32_t raw, std::uint32_t seed) {
    return uniform_float(detail::reverse_bits(scrambled(raw, seed)));
  }

 private:
  // Every bit is flipped by a hash of the bits below it, which are the higher digits of the reversed number.
  static constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
  }

  std::array<std::uint32_t, dimensions> seeds_{};
};

}  // namespace luxel
