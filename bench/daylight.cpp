// SPDX-License-Identifier: Apache-2.0
// The hours of a year times daylight coefficients, against its limits: the same arithmetic on numbers that
// stay in the first cache, and the time in which memory delivers all numbers once.
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "luxel/lighting/hour_products.h"

#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr int pairs = 7;

PackedColumns some_columns(std::size_t patches, std::size_t points) {
  PackedColumns columns(patches, points);
  for (std::size_t p = 0; p < patches; ++p)
    for (std::size_t m = 0; m < points; ++m) columns.at(p, m) = 1e-3f * static_cast<float>((p + m) % 97);
  return columns;
}

Json measure(std::size_t hours, std::size_t patches, std::size_t points) {
  const Context one(1);
  const auto columns = some_columns(patches, points);
  const std::vector<float> sky(hours * patches, 1000.0f);
  float sink = 0.0f;
  const auto product = [&] { sink += columns.times(sky, one).back(); };

  constexpr std::size_t few_hours = 32, few_patches = 64, few_points = PackedColumns::tile;
  const auto small_columns = some_columns(few_patches, few_points);
  const std::vector<float> small_sky(few_hours * few_patches, 1000.0f);
  const auto times = hours * patches * points / (few_hours * few_patches * few_points);
  const auto arithmetic = [&] {
    for (std::size_t i = 0; i < times; ++i) sink += small_columns.times(small_sky, one).back();
  };

  const std::vector<float> numbers(hours * patches + patches * points, 1.0f);
  std::vector<float> copy(numbers.size());
  const auto memory = [&] {
    std::memcpy(copy.data(), numbers.data(), sizeof(float) * numbers.size());
    sink += copy[copy.size() / 2];
  };

  const auto over_arithmetic = paired(pairs, product, arithmetic);
  const auto over_memory = paired(pairs, product, memory);
  const auto taken = seconds(product);
  fmt::print("{:>6} {:>8} {:>7} {:>8.3f} {:>7.2f} ({:.2f} to {:.2f}) {:>8.1f}\n", hours, patches, points,
             taken, over_arithmetic.median, over_arithmetic.low, over_arithmetic.high, over_memory.median);
  if (sink < 0.0f) fmt::print("\n");  // so that nothing is left out
  return {{"hours", hours},
          {"sky_patches", patches},
          {"points", points},
          {"seconds", taken},
          {"over_arithmetic", over_arithmetic.median},
          {"over_arithmetic_low", over_arithmetic.low},
          {"over_arithmetic_high", over_arithmetic.high},
          {"over_memory", over_memory.median}};
}

}  // namespace

Json hours_against_limits(const Settings& settings) {
  fmt::print(
      "\nHours of a year times coefficients, one thread; time over that of the same arithmetic in the first "
      "cache,\nand over that of copying the numbers once\n{:>6} {:>8} {:>7} {:>8} {:>7} {:>15} {:>8}\n",
      "hours", "patches", "points", "s", "over", "arithmetic", "memory");
  auto json = Json::array();
  const std::size_t hours = settings.small ? 440 : 4400, points = settings.small ? 64 : 1024;
  for (const std::size_t patches : {145u, 577u, 2305u}) json.push_back(measure(hours, patches, points));
  return json;
}

}  // namespace luxel::bench
