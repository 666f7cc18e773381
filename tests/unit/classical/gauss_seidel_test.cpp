// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/gauss_seidel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "luxel/core/address.h"

namespace luxel {
namespace {

constexpr std::size_t rows = 60;
constexpr std::size_t bands = 2;
constexpr std::uint32_t block = 4;  // rows

// A matrix, and one sink behind its rows.
class Dense final : public TransportOperator {
 public:
  Dense() : matrix_(rows * (rows + 1)) {
    for (std::size_t i = 0; i < rows; ++i) {
      auto* row = &matrix_[i * (rows + 1)];
      double sum = 0.0;
      for (std::size_t j = 0; j <= rows; ++j)
        sum += row[j] = i == j ? 0.0 : uniform4({1, 0, static_cast<std::uint32_t>(i), j})[0];
      for (std::size_t j = 0; j <= rows; ++j) row[j] /= sum;
    }
    for (std::uint32_t i = 0; i <= rows; i += block) begins_.push_back(i);
  }
  double at(std::size_t i, std::size_t j) const { return matrix_[i * (rows + 1) + j]; }
  std::size_t size() const override { return rows; }
  std::size_t bands() const override { return luxel::bands; }
  std::span<const std::uint32_t> row_begins() const override { return begins_; }
  void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
             std::size_t end, const Context&) const override {
    for (auto i = begin; i < end; ++i)
      for (std::size_t b = 0; b < luxel::bands; ++b) {
        double sum = 0.0;
        for (std::size_t j = 0; j <= rows; ++j)
          sum += at(i, j) * static_cast<double>(radiosity[j * luxel::bands + b]);
        irradiance[i * luxel::bands + b] = static_cast<float>(sum);
      }
  }

 private:
  std::vector<double> matrix_;
  std::vector<std::uint32_t> begins_;
};

struct Room {
  Dense transport;
  std::vector<float> direct, reflectance;

  explicit Room(float most) {
    for (std::size_t i = 0; i < rows * bands; ++i) {
      const auto u = uniform4({2, 0, static_cast<std::uint32_t>(i), 0});
      direct.push_back(i / bands < 5 ? u[0] : 0.0f);
      reflectance.push_back(most * (0.5f + 0.5f * u[1]));
    }
  }

  // B of (1 - rho F) B = rho D, by elimination.
  std::vector<double> truth(std::size_t band) const {
    std::vector<double> a(rows * rows), x(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      const double rho = reflectance[i * bands + band];
      for (std::size_t j = 0; j < rows; ++j)
        a[i * rows + j] = (i == j ? 1.0 : 0.0) - rho * transport.at(i, j);
      x[i] = rho * static_cast<double>(direct[i * bands + band]);
    }
    for (std::size_t k = 0; k < rows; ++k)  // no pivoting: the matrix is diagonally dominant
      for (auto i = k + 1; i < rows; ++i) {
        const auto factor = a[i * rows + k] / a[k * rows + k];
        for (auto j = k; j < rows; ++j) a[i * rows + j] -= factor * a[k * rows + j];
        x[i] -= factor * x[k];
      }
    for (auto k = rows; k-- > 0;) {
      for (auto j = k + 1; j < rows; ++j) x[k] -= a[k * rows + j] * x[j];
      x[k] /= a[k * rows + k];
    }
    return x;
  }
};

struct Solved {
  GaussSeidelReport report;
  std::vector<float> radiosity = std::vector<float>((rows + 1) * bands, 0.0f);
  std::vector<float> irradiance = std::vector<float>(rows * bands, 0.0f);
};
Solved solve(const Room& room, const GaussSeidelOptions& options, int threads = 2, float start = 0.0f) {
  Solved s;
  std::fill_n(s.radiosity.begin(), rows * bands, start);
  s.report = gauss_seidel(room.transport, {room.direct, room.reflectance, s.radiosity, s.irradiance}, options,
                          Context(threads));
  return s;
}

// Sum of |B - truth| over the sum of truth.
double distance(const Room& room, const Solved& s) {
  double wrong = 0.0;
  double whole = 0.0;
  for (std::size_t b = 0; b < bands; ++b) {
    const auto truth = room.truth(b);
    for (std::size_t i = 0; i < rows; ++i) {
      wrong += std::abs(static_cast<double>(s.radiosity[i * bands + b]) - truth[i]);
      whole += truth[i];
    }
  }
  return wrong / whole;
}

TEST(GaussSeidel, solves_what_elimination_solves_with_any_number_of_parts) {
  for (const float most : {0.3f, 0.8f, 0.99f}) {
    const Room room(most);
    for (const std::size_t parts : {1u, 2u, 8u, 1000u}) {
      const auto solved = solve(room, {.parts = parts});
      EXPECT_TRUE(solved.report.converged);
      // The requested distance is estimated from the changes.
      EXPECT_LT(distance(room, solved), 5e-6) << most << ", " << parts << " parts";
    }
  }
}

TEST(GaussSeidel, irradiance_is_what_the_radiosity_reflects) {
  const Room room(0.8f);
  const auto solved = solve(room, {});
  for (std::size_t i = 0; i < rows * bands; ++i)
    EXPECT_NEAR(room.reflectance[i] * solved.irradiance[i], solved.radiosity[i], 1e-5f * solved.radiosity[i]);
}

TEST(GaussSeidel, says_how_far_it_may_be_from_the_truth) {
  const Room room(0.9f);
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const auto solved = solve(room, {.tolerance = tolerance});
    EXPECT_TRUE(solved.report.converged);
    EXPECT_LE(solved.report.distance, tolerance);
    EXPECT_LT(distance(room, solved), 2.0 * tolerance);
    EXPECT_FALSE(solved.report.change.empty());
  }
}

// Noise of rows is independent, so its sum is a small part of its magnitude, and the reflected rest of the
// sum converges last.
TEST(GaussSeidel, goes_on_until_the_sums_over_rows_stand_where_that_is_asked_for) {
  Room room(0.95f);
  for (std::size_t i = 0; i < rows * bands; ++i) {
    const auto u = uniform4({3, 0, static_cast<std::uint32_t>(i), 0});
    room.direct[i] = u[0] - 0.5f + 0.02f;
  }
  const auto sum_error = [&](const Solved& s) {
    double wrong = 0.0;
    double whole = 0.0;
    for (std::size_t b = 0; b < bands; ++b) {
      const auto truth = room.truth(b);
      double of_band = 0.0;
      double true_sum = 0.0;
      for (std::size_t i = 0; i < rows; ++i) {
        of_band += static_cast<double>(s.radiosity[i * bands + b]);
        true_sum += truth[i];
      }
      wrong += std::abs(of_band - true_sum);
      whole += std::abs(true_sum);
    }
    return wrong / whole;
  };
  const GaussSeidelOptions of_rows{.tolerance = 0.2, .parts = 1, .memory = 1};
  auto of_sums = of_rows;
  of_sums.sum_tolerance = 0.01;
  const auto loose = solve(room, of_rows);
  const auto tight = solve(room, of_sums);
  EXPECT_EQ(loose.report.sum_distance, 0.0) << "not judged";
  EXPECT_TRUE(tight.report.converged);
  EXPECT_LE(tight.report.sum_distance, 0.01);
  EXPECT_LT(sum_error(tight), 0.02);
  EXPECT_GT(sum_error(loose), 0.05);
  EXPECT_EQ(tight.radiosity, solve(room, of_sums, 5).radiosity);
}

TEST(GaussSeidel, ends_after_as_many_sweeps_as_it_may) {
  const auto solved = solve(Room(0.99f), {.max_sweeps = 3});
  EXPECT_EQ(solved.report.change.size(), 3u);
  EXPECT_FALSE(solved.report.converged);
}

TEST(GaussSeidel, finds_the_same_from_wherever_it_starts_and_sooner_from_near) {
  const Room room(0.8f);
  const auto from_dark = solve(room, {});
  EXPECT_LT(distance(room, solve(room, {}, 2, 7.0f)), 2e-6);
  auto again = from_dark;
  again.report = gauss_seidel(
      room.transport, {room.direct, room.reflectance, again.radiosity, again.irradiance}, {}, Context(2));
  EXPECT_LT(again.report.change.size(), from_dark.report.change.size());
}

TEST(GaussSeidel, newest_radiosities_take_fewer_sweeps_than_last_sweeps) {
  const Room room(0.95f);
  GaussSeidelOptions jacobi{.parts = 1};
  GaussSeidelOptions parts{.parts = 15};
  EXPECT_LE(solve(room, parts).report.change.size(), solve(room, jacobi).report.change.size());
}

TEST(GaussSeidel, leaves_what_stands_behind_the_rows_alone_though_it_shines) {
  const Room room(0.5f);
  Solved s;
  s.radiosity[rows * bands] = 3.0f;
  gauss_seidel(room.transport, {room.direct, room.reflectance, s.radiosity, s.irradiance}, {}, Context(2));
  EXPECT_EQ(s.radiosity[rows * bands], 3.0f);
  EXPECT_GT(s.radiosity[(rows - 1) * bands], solve(room, {}).radiosity[(rows - 1) * bands]);
}

TEST(GaussSeidel, of_the_dark_is_dark_at_once) {
  Room room(0.5f);
  std::fill(room.direct.begin(), room.direct.end(), 0.0f);
  const auto solved = solve(room, {});
  EXPECT_TRUE(solved.report.converged);
  EXPECT_LE(solved.report.change.size(), 2u);
  EXPECT_EQ(*std::max_element(solved.radiosity.begin(), solved.radiosity.end()), 0.0f);
}

TEST(GaussSeidel, gives_the_same_bits_on_any_number_of_threads) {
  const Room room(0.9f);
  const auto one = solve(room, {}, 1);
  for (const int threads : {2, 5}) {
    const auto solved = solve(room, {}, threads);
    EXPECT_EQ(solved.radiosity, one.radiosity);
    EXPECT_EQ(solved.irradiance, one.irradiance);
    EXPECT_EQ(solved.report.change, one.report.change);
  }
}

}  // namespace
}  // namespace luxel
