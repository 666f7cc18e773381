// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/triangle_pairs.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/address.h"

namespace luxel {
namespace {

using NumberPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Small ones, and a hundredth as large as all the space that they are in. Every fifth coordinate is rounded
// to a tenth, so that many boxes only touch.
std::vector<Bounds> boxes_in_a_cube(std::uint32_t count) {
  std::vector<Bounds> boxes(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto place = uniform4({.seed = 7, .element = i});
    const auto size = uniform4({.seed = 7, .element = i, .sample = 1});
    Vec3 low(place[0], place[1], place[2]);
    if (place[3] < 0.2f) low = glm::round(low * 10.0f) * 0.1f;
    const float scale = i % 100 == 0 ? 0.5f : 0.02f;
    boxes[i].add(low);
    boxes[i].add(low + scale * Vec3(size[0], size[1], size[2]));
  }
  return boxes;
}

NumberPairs by_trying_all(const std::vector<Bounds>& boxes) {
  NumberPairs pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      const auto low = glm::max(boxes[i].low, boxes[j].low);
      const auto high = glm::min(boxes[i].high, boxes[j].high);
      if (low.x <= high.x && low.y <= high.y && low.z <= high.z) pairs.emplace_back(i, j);
    }
  return pairs;
}

NumberPairs of_part(const OverlappingPairs& pairs, std::size_t part) {
  NumberPairs result;
  pairs.for_pairs(part, [&](std::uint32_t i, std::uint32_t j) { result.emplace_back(i, j); });
  return result;
}

TEST(OverlappingPairs, are_those_that_trying_all_of_them_finds) {
  const Context context(2);
  for (const std::uint32_t count : {0u, 1u, 2u, 5u, 9u, 100u, 20'000u}) {
    const auto boxes = boxes_in_a_cube(count);
    const OverlappingPairs pairs(boxes, context);
    NumberPairs found;
    for (std::size_t part = 0; part < pairs.parts(); ++part) {
      const auto some = of_part(pairs, part);
      found.insert(found.end(), some.begin(), some.end());
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, by_trying_all(boxes)) << count << " boxes";
  }
}

TEST(OverlappingPairs, parts_are_the_same_for_any_number_of_threads) {
  const auto boxes = boxes_in_a_cube(30'000);
  const Context one(1), five(5);
  const OverlappingPairs a(boxes, one);
  const OverlappingPairs b(boxes, five);
  EXPECT_GT(a.parts(), 4u);
  ASSERT_EQ(a.parts(), b.parts());
  for (std::size_t part = 0; part < a.parts(); ++part) EXPECT_EQ(of_part(a, part), of_part(b, part));
}

}  // namespace
}  // namespace luxel
