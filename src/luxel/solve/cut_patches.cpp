// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/cut_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "luxel/solve/seen_measure.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

// Above these fractions a patch is cut before the first solve: of the whole area; and of what the views of a
// place see, by an equilateral triangle on its longest edge, which has 1.7 times the area of a half square.
constexpr double large_in_scene = 5e-4, large_in_views = 1e-3;
constexpr double parts = 4.0;  // made of a marked patch; neighbours are cut too, other patches are not

// Returns the area of an equilateral triangle on the longest edge, m². By this measure a needle is as large
// as a compact patch of its length.
double equilateral_area(const std::array<Vec3, 3>& points) {
  float longest = 0.0f;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, glm::distance(points[(k + 1) % 3], points[k]));
  return std::sqrt(3.0) / 4.0 * static_cast<double>(longest * longest);
}

// [patch]: the fraction of what the views see that such a triangle takes up. density: [patch], 1/m².
std::vector<double> sizes_in_views(const PatchSet& patches, std::span<const double> density) {
  std::vector<double> size(patches.size());
  for (std::size_t p = 0; p < size.size(); ++p) size[p] = density[p] * equilateral_area(patches.points(p));
  return size;
}

std::vector<double> of_parts(std::span<const double> of_wholes, std::span<const std::uint32_t> parent) {
  std::vector<double> result;
  for (const auto p : parent) result.push_back(of_wholes[p]);
  return result;
}

RefinedPatches uncut(const PatchSet& patches) {
  RefinedPatches result{patches, std::vector<std::uint32_t>(patches.size())};
  std::iota(result.parent.begin(), result.parent.end(), 0u);
  return result;
}

}  // namespace

void sort_by_weight(std::span<const double> weight, std::vector<std::uint32_t>& patches) {
  std::sort(patches.begin(), patches.end(), [&](std::uint32_t a, std::uint32_t b) {
    return weight[a] != weight[b] ? weight[a] > weight[b] : a < b;
  });
}

std::vector<std::uint8_t> larger_than(double limit, std::span<const double> size) {
  std::vector<std::uint8_t> marks(size.size());
  std::transform(size.begin(), size.end(), marks.begin(), [&](double s) { return s > limit ? 1 : 0; });
  return marks;
}

std::optional<RefinedPatches> cut_within_limit(const PatchSet& patches,
                                               std::span<const std::uint8_t> is_marked,
                                               std::span<const double> weight, std::size_t max_patches,
                                               const Context& context) {
  const auto size = patches.size();
  std::vector<std::uint32_t> order;
  for (std::uint32_t p = 0; p < size; ++p)
    if (is_marked[p] != 0) order.push_back(p);
  sort_by_weight(weight, order);
  const auto room = max_patches > size ? max_patches - size : 0;
  auto count = std::min(order.size(), static_cast<std::size_t>(static_cast<double>(room) / (parts - 1.0)));
  for (; count > 0; count = count * 3 / 4) {
    std::vector<std::uint8_t> chosen(size, 0);
    for (std::size_t i = 0; i < count; ++i) chosen[order[i]] = 1;
    auto refined = refine_patches(patches, chosen, context);
    if (refined.patches.size() <= max_patches) return refined;
  }
  return std::nullopt;
}

RefinedPatches cut_large_patches(PatchSet& patches, ErrorMeasure measure, std::size_t max_patches,
                                 const Context& context) {
  std::vector<double> density;
  if (measure == ErrorMeasure::seen) density = seen_densities(patches, Tracer(patches, context), context);
  density.resize(patches.size(), 0.0);
  for (;;) {
    const auto size = sizes_in_views(patches, density);
    const auto marks = larger_than(parts * large_in_views, size);
    auto refined = cut_within_limit(patches, marks, size, max_patches, context);
    if (!refined || refined->patches.size() == patches.size()) break;
    density = of_parts(density, refined->parent);
    patches = std::move(refined->patches);
  }
  auto size = sizes_in_views(patches, density);
  auto marks = larger_than(large_in_views, size);
  const auto whole = std::accumulate(patches.area.begin(), patches.area.end(), 0.0);
  for (std::size_t p = 0; p < size.size(); ++p) {
    const auto in_scene = static_cast<double>(patches.area[p]) / whole;
    if (in_scene > large_in_scene) marks[p] = 1;
    size[p] = std::max(size[p], in_scene);
  }
  auto refined = cut_within_limit(patches, marks, size, max_patches, context);
  return refined ? std::move(*refined) : uncut(patches);
}

}  // namespace luxel
