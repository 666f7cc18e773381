// SPDX-License-Identifier: Apache-2.0
// Four ways to a form factor, and the tests' own fifth, in rooms with shadows: each must agree with the exact
// one within the error it states.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/classical/hemicube.h"
#include "luxel/classical/local_lines.h"
#include "luxel/form_factors/form_factor.h"
#include "luxel/patch/side.h"

#include "support/chi_square.h"
#include "support/known_rooms.h"

namespace luxel::truth {
namespace {

// Some rows of a room by exact integrals, to 5e-5 each.
struct Rows {
  KnownRoom room;
  std::vector<ConvexPolygon> screens;
  std::vector<SideId> sides;
  std::vector<std::vector<FormFactor>> exact;  // [entry of sides][side]
};

Rows make_rows(KnownRoom room, std::vector<ConvexPolygon> screens) {
  const Context context;
  Rows rows{std::move(room), std::move(screens), {}, {}};
  const auto& patches = rows.room.patches;
  const Tracer tracer(patches, context);
  const FormFactors factors(patches, tracer);
  for (std::size_t p = 3; p < patches.size(); p += 1 + patches.size() / 3) {
    rows.sides.emplace_back(p, false);
    auto& row = rows.exact.emplace_back();
    for (std::size_t to = 0; to < side_count(patches.size()); ++to)
      row.push_back(factors.between(SideId(p, false), SideId::at(to), 5e-5));
  }
  return rows;
}

const std::vector<Rows>& all_rows() {
  static const std::vector<Rows> rows = [] {
    std::vector<Rows> some;
    some.push_back(make_rows(luminous_ceiling(), {}));
    some.push_back(make_rows(open_plates(), {}));
    some.push_back(make_rows(hung_plate(), hung_plate_screens()));
    some.push_back(make_rows(l_shaped(), l_room_screens()));
    return some;
  }();
  return rows;
}

double sum_of(const std::vector<FormFactor>& row) {
  return std::accumulate(row.begin(), row.end(), 0.0,
                         [](double sum, const FormFactor& factor) { return sum + factor.value; });
}

TEST(FormFactorTruth, rows_of_closed_rooms_sum_to_one_within_their_errors) {
  for (const auto& rows : all_rows())
    for (const auto& row : rows.exact) {
      double error = 0.0;
      for (const auto& factor : row) error += factor.error;
      EXPECT_LT(error, rows.screens.empty() ? 1e-9 : 2e-3);
      if (rows.room.name == "open_plates")
        EXPECT_LT(sum_of(row), 0.5);
      else
        EXPECT_NEAR(sum_of(row), 1.0, error) << rows.room.name;
    }
}

// The tests' own factors come from other cuts of other integrals, good to 1e-6 of the receiver.
TEST(FormFactorTruth, exact_factors_are_those_the_tests_know) {
  const Context context;
  for (const auto& rows : all_rows()) {
    if (rows.room.name == "l_shaped") continue;  // checked by row sums: the tests' own factors take long
    const auto known = form_factors(rows.room.patches, rows.screens, context);
    const auto sides = side_count(rows.room.patches.size());
    int exact = 0, integrated = 0;
    for (std::size_t k = 0; k < rows.sides.size(); ++k)
      for (std::size_t to = 0; to < sides; ++to) {
        const auto& factor = rows.exact[k][to];
        (factor.exact ? exact : integrated) += 1;
        EXPECT_NEAR(factor.value, known[rows.sides[k].index() * sides + to], factor.error + 2e-6)
            << rows.room.name << ", side " << rows.sides[k].index() << " to " << to;
      }
    EXPECT_EQ(integrated > 0, !rows.screens.empty()) << rows.room.name;
    EXPECT_GT(exact, 100);
  }
}

// Lines miss a factor by their standard error, so that the sum of squares is a chi-square. Factors of few
// lines are pooled. Risk: one in a million per row, twelve rows.
TEST(FormFactorTruth, lines_count_the_exact_factors) {
  const Context context;
  constexpr std::uint32_t lines = 40'000;
  constexpr double few = 20.0;
  for (const auto& rows : all_rows()) {
    const Tracer tracer(rows.room.patches, context);
    for (std::size_t k = 0; k < rows.sides.size(); ++k) {
      LineCounts counts;
      count_local_lines(rows.room.patches, tracer, rows.sides[k], {lines, 5}, counts);
      std::map<std::size_t, double> met;
      for (const auto& entry : counts.entries) met[entry.side.index()] = entry.lines;
      double square = 0.0, cells = 0.0, pooled = 0.0, pooled_met = 0.0;
      const auto compare = [&](double expected, double count) {
        square += (count - expected) * (count - expected) / expected;
        cells += 1.0;
      };
      const auto add = [&](double expected, double count) {
        if (expected >= few) return compare(expected, count);
        pooled += expected;
        pooled_met += count;
      };
      for (std::size_t to = 0; to < rows.exact[k].size(); ++to) add(lines * rows.exact[k][to].value, met[to]);
      add(lines * (1.0 - sum_of(rows.exact[k])), counts.escaped);
      if (pooled >= few) compare(pooled, pooled_met);
      EXPECT_LT(square, statistics::chi_square_limit(cells))
          << rows.room.name << ", side " << rows.sides[k].index() << ", cells " << cells;
    }
  }
}

// Misplaced fraction of a row: half the sum of the differences. With few pixels from one point it is large;
// with many from many points, one per cent.
TEST(FormFactorTruth, hemicubes_come_near_with_pixels_and_points) {
  for (const auto& rows : all_rows()) {
    Hemicube coarse(rows.room.patches, {.resolution = 32});
    Hemicube fine(rows.room.patches, {.resolution = 256, .points = 16});
    for (std::size_t k = 0; k < rows.sides.size(); ++k) {
      const auto misplaced = [&](Hemicube& hemicube) {
        FormFactorRow row;
        hemicube.row(rows.sides[k], row);
        std::map<std::size_t, double> met;
        for (const auto& entry : row.entries) met[entry.side.index()] = static_cast<double>(entry.factor);
        auto sum = std::fabs(row.escaped - (1.0 - sum_of(rows.exact[k])));
        for (std::size_t to = 0; to < rows.exact[k].size(); ++to)
          sum += std::fabs(met[to] - rows.exact[k][to].value);
        return 0.5 * sum;
      };
      const auto good = misplaced(fine);
      EXPECT_LT(good, 0.012) << rows.room.name << ", side " << rows.sides[k].index();
      EXPECT_LT(good, 0.5 * misplaced(coarse)) << rows.room.name << ", side " << rows.sides[k].index();
    }
  }
}

}  // namespace
}  // namespace luxel::truth
