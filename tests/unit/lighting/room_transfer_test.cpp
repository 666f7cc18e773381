// SPDX-License-Identifier: Apache-2.0
// Interreflection in box rooms against the published factors of CIE 190:2010, and against closed forms.
#include "luxel/lighting/room_transfer.h"

#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "luxel/lighting/ugr_table.h"

namespace luxel {
namespace {

// F_T of CIE 190 in thousandths: by reflectances; by room from floor, walls, ceiling.
// clang-format off
constexpr std::array<std::array<int, 57>, 5> published = {{
    {{220, 422, 646, 199, 376, 571, 187, 351, 531, 174, 322, 488, 167, 307, 466, 160, 290, 443, 187, 351, 531, 158, 295, 439, 142, 265, 389, 124, 230, 335, 115, 211, 307, 105, 190, 279, 115, 211, 307, 94, 175, 247, 83, 155, 215, 71, 133, 183, 105, 190, 279, 83, 153, 216, 71, 133, 183}},
    {{188, 217, 553, 173, 196, 497, 164, 184, 465, 154, 171, 432, 149, 164, 415, 143, 156, 397, 164, 184, 465, 142, 159, 393, 129, 144, 351, 114, 127, 307, 106, 117, 283, 98, 106, 259, 106, 117, 283, 88, 98, 231, 78, 88, 203, 67, 76, 174, 98, 106, 259, 78, 86, 204, 67, 76, 174}},
    {{198, 380, 445, 178, 338, 393, 166, 314, 365, 154, 287, 335, 147, 273, 320, 141, 257, 304, 166, 314, 364, 140, 263, 301, 125, 235, 267, 108, 204, 230, 100, 187, 211, 91, 167, 191, 100, 187, 211, 81, 154, 169, 71, 137, 147, 61, 117, 125, 91, 167, 191, 71, 134, 148, 61, 117, 125}},
    {{172, 198, 386, 157, 179, 346, 148, 167, 324, 138, 155, 301, 133, 147, 288, 128, 140, 276, 148, 167, 324, 126, 143, 272, 114, 129, 244, 100, 113, 212, 93, 104, 196, 85, 94, 179, 93, 104, 196, 76, 87, 158, 67, 78, 140, 58, 67, 120, 85, 94, 179, 68, 77, 140, 58, 67, 120}},
    {{157, 181, 227, 141, 162, 203, 132, 151, 190, 123, 139, 176, 118, 132, 169, 113, 124, 161, 132, 151, 190, 112, 128, 159, 100, 115, 142, 87, 101, 124, 81, 92, 114, 74, 83, 104, 81, 92, 114, 66, 77, 92, 58, 69, 81, 49, 59, 69, 74, 83, 104, 58, 67, 81, 49, 59, 69}}}};
// clang-format on

// The four numbers that CIE 190 has one or more thousandths too low: reflectances, place, thousandths of the
// radiosity.
constexpr std::array<std::array<int, 3>, 4> misprints = {
    {{2, 1, 381}, {2, 20, 365}, {3, 23, 273}, {3, 41, 159}}};

TEST(WallTransfer, has_the_285_factors_of_cie_190) {
  for (std::size_t s = 0; s < 5; ++s)
    for (std::size_t r = 0; r < 19; ++r) {
      const auto transfer = wall_transfer(ugr_rooms[r].across, ugr_rooms[r].along, ugr_reflectances[s]);
      const std::array<double, 3> computed = {transfer.from_floor, transfer.from_wall, transfer.from_ceiling};
      for (std::size_t i = 0; i < 3; ++i) {
        auto expected = published[s][3 * r + i];
        for (const auto& m : misprints)
          if (m[0] == static_cast<int>(s) && m[1] == static_cast<int>(3 * r + i)) expected = m[2];
        EXPECT_NEAR(1000.0 * computed[i], expected, 0.5)
            << name_of(ugr_reflectances[s]) << " room " << r << " from " << i;
      }
    }
}

// Even reflectance: all light that arrives anywhere adds up to 1 / (1 - rho) lumens per lumen, of which the
// first is direct; in a cube each surface is like each other, so light from the walls spreads as the series
// of the wall's factor does.
TEST(WallTransfer, is_the_sum_of_bounces) {
  constexpr double rho = 0.6, opposite = 0.19982489569838746;  // form factor of two sides of a cube
  const auto transfer = wall_transfer(1.0, 1.0, {rho, rho, rho});
  const double from_wall = (1.0 - opposite) / 4.0;
  const std::array<std::array<double, 3>, 3> factors = {{{0.0, 1.0 - opposite, opposite},
                                                         {from_wall, 1.0 - 2.0 * from_wall, from_wall},
                                                         {opposite, 1.0 - opposite, 0.0}}};
  const auto bounces_from = [&](std::size_t start) {
    std::array<double, 3> lumens{};
    lumens[start] = 1.0;
    double on_walls = 0.0;
    for (int bounce = 0; bounce < 200; ++bounce) {
      std::array<double, 3> next{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) next[j] += rho * lumens[i] * factors[i][j];
      lumens = next;
      on_walls += lumens[1];
    }
    return on_walls;
  };
  EXPECT_NEAR(transfer.from_floor, bounces_from(0), 1e-12);
  EXPECT_NEAR(transfer.from_wall, bounces_from(1), 1e-12);
  EXPECT_NEAR(transfer.from_ceiling, bounces_from(2), 1e-12);
}

TEST(WallTransfer, is_zero_without_reflection) {
  const auto transfer = wall_transfer(4.0, 8.0, {0.0, 0.0, 0.0});
  EXPECT_EQ(transfer.from_floor, 0.0);
  EXPECT_EQ(transfer.from_wall, 0.0);
  EXPECT_EQ(transfer.from_ceiling, 0.0);
}

}  // namespace
}  // namespace luxel
