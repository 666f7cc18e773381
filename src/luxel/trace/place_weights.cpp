// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/place_weights.h"

#include <algorithm>

namespace luxel {
namespace {

constexpr int iterations =
    6;  // equal to 5 % for two rooms of 30 and 1,000 views; more iterations favour hidden corners
constexpr float all_outside = 2.0f;  // half of the directions in the open: entirely outside

bool sees(const Tracer& tracer, const Vec3& from, const Vec3& to) {
  const auto line = to - from;
  const auto distance = glm::length(line);
  return !(distance > 0.0f) || !tracer.occluded({from, line / distance}, distance);
}

}  // namespace

std::vector<float> place_weights(std::span<const Panorama> looks, const Tracer& tracer,
                                 const Context& context) {
  const auto n = looks.size();
  std::vector<float> open(n);
  for (std::size_t v = 0; v < n; ++v) open[v] = static_cast<float>(looks[v].escaped_fraction());
  std::vector<float> together(n * n);
  context.for_chunks(n, 8, [&](std::size_t begin, std::size_t end, int) {
    for (auto v = begin; v < end; ++v)
      for (std::size_t w = 0; w <= v; ++w) {
        const auto outside = std::min(1.0f, all_outside * std::min(open[v], open[w]));
        together[v * n + w] = sees(tracer, looks[v].eye, looks[w].eye) ? 1.0f : outside;
      }
  });
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t w = 0; w < v; ++w) together[w * n + v] = together[v * n + w];
  std::vector<float> weight(n, 1.0f);
  std::vector<float> next(n);
  for (int i = 0; i < iterations; ++i) {
    context.for_chunks(n, 64, [&](std::size_t begin, std::size_t end, int) {
      for (auto v = begin; v < end; ++v) {
        float sum = 0.0f;
        for (std::size_t w = 0; w < n; ++w) sum += together[v * n + w] * weight[w];
        next[v] = weight[v] / sum;
      }
    });
    weight.swap(next);
  }
  return weight;
}

}  // namespace luxel
