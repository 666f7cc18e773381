// SPDX-License-Identifier: Apache-2.0
// Every method gives the same light, patch by patch, within the errors that the methods state.
//
// The score of a number for two methods a and b is
//
//     z = max(0, |H_a - H_b| - bound_a - bound_b) / sqrt(error_a² + error_b²)
//
// where an error is a standard error and a bound is the maximum error of a deterministic method:
//
//   dense      bound: its stated error, the errors of its form factors propagated through the room
//   sampled    error: its stated error, from 32 replicates, and 0.1 % for the closed form of direct light
//              (docs/theory.md)
//   reference  error: its stated error, from batches of paths, plus half a path that met the brightest
//              light, as for lines: where no path found light, the spread of the paths is meaningless
//   lines      error: its stated error, multinomial
//   shooting   error: arrivals are a Poisson count of quanta q, so sqrt(q (H + q / A) / A) at most;
//              bound: the unshot light
//   hemicube   It states no error, so two are derived. A pixel of the fraction w looks once into its part of
//              the hemisphere: if grid and edges are uncorrelated, the variance of a row is at most w times
//              that of the radiosity it sees, and w is at most 4 / (pi R²): a hemicube is no worse than
//              pi R² / 4 cosine lines, so its error is that of lines times a constant. And a row is that of
//              points: four of them represent the whole patch, and their error is less than the difference
//              of one of them from all four, there or on average. Bounces beyond the last one continue its
//              light as a geometric series.
//
// A number below a thousandth of the room's mean counts only in the mean square: light found by few rays has
// no normal distribution, and sampled may leave it dark altogether.
//
// Risk. Seeds are fixed. With other random numbers a |z| beyond 7.5 in any of the 300,000 numbers compared
// has a chance below one in a hundred (Student's t for 31 degrees of freedom; less for the rest);
// the root mean square of one pair's scores beyond 2 below 2 in 100,000 where its errors have ten independent
// directions or more.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/classical/classical.h"
#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"

#include "support/agreement_rooms.h"

namespace luxel {
namespace {

constexpr double worst_allowed = 7.5;
constexpr double mean_allowed = 2.0;
constexpr double faint = 1e-3;  // of the room's mean

// One list: [side of the patch][patch][band].
using Numbers = std::vector<double>;

Numbers both_sides(const std::vector<float>& front, const std::vector<float>& back) {
  Numbers all(front.begin(), front.end());
  all.insert(all.end(), back.begin(), back.end());
  return all;
}

struct Answer {
  std::string method;
  Numbers irradiance, error, bound;
  double out_of_balance = 0.0;  // over the power of lamps and sky
  double balance_allowed = 0.0;
};

double power(const std::vector<double>& bands) {
  double sum = 0.0;
  for (const auto watts : bands) sum += watts;
  return sum;
}

// Of lamps and sky.
double light_of(const EnergyBalance& energy) { return power(energy.emitted) + power(energy.from_sky); }

class Room {
 public:
  explicit Room(PatchSet patches) : patches_(std::move(patches)), tracer_(patches_, context_) {}

  const PatchSet& patches() const { return patches_; }

  Answer dense() {
    Solution s;
    const auto report = solve_dense(patches_, tracer_, s, {.factors = {.tolerance = 1e-5}}, context_);
    auto answer = answer_of("dense", s, report.energy, 1e-4);
    answer.bound = both_sides(s.standard_error.front, s.standard_error.back);
    answer.error.assign(answer.bound.size(), 0.0);
    return answer;
  }

  Answer sampled() {
    Solution s;
    const auto report =
        solve_sampled(patches_, tracer_, s,
                      {.error = 0.004, .error_measure = ErrorMeasure::power, .replicates = 32}, context_);
    auto answer = with_stated_errors("sampled", s, report.energy);
    for (std::size_t i = 0; i < answer.error.size(); ++i) {
      answer.error[i] = std::hypot(answer.error[i], 0.001 * answer.irradiance[i]);
    }
    return answer;
  }

  Answer lines() {
    Solution s;
    const auto report = solve_lines(
        patches_, tracer_, s, {.lines = {.lines = lines_each}, .iteration = {.tolerance = 1e-7}}, context_);
    auto answer = with_stated_errors("lines", s, report.energy);
    line_error_ = answer.error;
    return answer;
  }

  Answer shooting() {
    Solution s;
    // Nine in ten of the sky's rays meet nothing, or black backs.
    const std::uint64_t rays = patches_.has_sky() ? 300'000 : 2'000'000;
    const auto report =
        solve_stochastic_jacobi(patches_, tracer_, s, {.rays = rays, .tolerance = 1e-6}, context_);
    auto answer = answer_of("shooting", s, report.energy, 1e-6);
    const auto emitted = light_of(report.energy);
    // Of the second step, which shoots no sky: all steps have the same.
    const auto quantum =
        report.steps[0].unshot_fraction * emitted / static_cast<double>(report.steps[1].rays);
    answer.error.resize(answer.irradiance.size());
    for (std::size_t i = 0; i < answer.irradiance.size(); ++i) {
      const auto area = area_of(i);
      answer.error[i] = std::sqrt(quantum * (answer.irradiance[i] + quantum / area) / area);
      answer.bound[i] = report.unshot_fraction * emitted / area;
    }
    return answer;
  }

  // After lines().
  Answer hemicube() {
    constexpr int resolution = 64;
    constexpr int points = 4;
    Solution one, four;
    std::vector<Numbers> bounces;
    const auto keep = [&](const Solution& light, const Progress&) {
      bounces.push_back(both_sides(light.irradiance.front, light.irradiance.back));
    };
    const JacobiOptions iteration{.tolerance = 1e-3};
    solve_hemicube(patches_, one, {.hemicube = {resolution, 1}, .iteration = iteration}, context_);
    const auto report = solve_hemicube(
        patches_, four, {.hemicube = {resolution, points}, .iteration = iteration}, context_, keep);
    auto answer = answer_of("hemicube", four, report.energy, 0.0);
    const auto coarse = both_sides(one.irradiance.front, one.irradiance.back);
    const auto lines_worth = M_PI * resolution * resolution / 4.0 * points;
    double square = 0.0, area = 0.0;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      const auto change = coarse[i] - answer.irradiance[i];
      square += answer.irradiance[i] > 0.0 ? area_of(i) * change * change : 0.0;
      area += answer.irradiance[i] > 0.0 ? area_of(i) : 0.0;
    }
    const auto last = report.steps.size() - 1;
    const auto decay = report.steps[last].unshot_fraction / report.steps[last - 1].unshot_fraction;
    double allowed = 0.0, light = 0.0;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      answer.error.push_back(line_error_[i] * std::sqrt(lines_each / lines_worth));
      answer.bound[i] = std::max(std::abs(coarse[i] - answer.irradiance[i]), std::sqrt(square / area)) +
                        (bounces[last][i] - bounces[last - 1][i]) / (1.0 - decay);
      allowed += area_of(i) * (answer.bound[i] + 3.0 * answer.error[i]);
      light += area_of(i) * answer.irradiance[i];
    }
    answer.balance_allowed = allowed / light * power(report.energy.absorbed) / light_of(report.energy);
    return answer;
  }

  Answer reference() {
    Solution s;
    PathOptions options;
    options.limits.error = 0.015;
    options.bounces_from = BouncesFrom::patches;
    const auto report = trace_light(patches_, tracer_, s, options, context_);
    EnergyBalance energy{report.emitted, report.from_sky,      report.absorbed,
                         report.escaped, report.lost_at_backs, {}};
    auto answer = with_stated_errors("reference", s, energy);
    double brightest = *std::max_element(s.radiosity.front.begin(), s.radiosity.front.end());
    for (std::size_t b = 0; b < patches_.band_count(); ++b)
      brightest = std::max(brightest, patches_.sky_radiosity(0, b));
    for (auto& error : answer.error)
      error = std::hypot(error, std::sqrt(0.5) * brightest / static_cast<double>(report.paths));
    return answer;
  }

  double area_of(std::size_t i) const {
    return static_cast<double>(patches_.area[i / patches_.band_count() % patches_.size()]);
  }

 private:
  static constexpr std::uint32_t lines_each = 16384;

  Answer answer_of(const char* method, const Solution& s, const EnergyBalance& e,
                   double balance_allowed) const {
    Answer answer;
    answer.method = method;
    answer.irradiance = both_sides(s.irradiance.front, s.irradiance.back);
    answer.bound.assign(answer.irradiance.size(), 0.0);
    const auto went = power(e.absorbed) + power(e.escaped) + power(e.lost_at_backs) + power(e.unshot);
    answer.out_of_balance = went / light_of(e) - 1.0;
    answer.balance_allowed = balance_allowed;
    return answer;
  }

  // The error of a mean is no larger than the root mean square error; four of these are allowed.
  Answer with_stated_errors(const char* method, const Solution& s, const EnergyBalance& energy) const {
    auto answer = answer_of(method, s, energy, 4.0 * s.predicted_error);
    answer.error = both_sides(s.standard_error.front, s.standard_error.back);
    return answer;
  }

  PatchSet patches_;
  Context context_;
  Tracer tracer_;
  Numbers line_error_;
};

struct Verdict {
  double worst = 0.0, root_mean_square = 0.0;
  std::size_t where = 0, numbers = 0;
};

Verdict compare(const Room& room, const Answer& a, const Answer& b) {
  Verdict verdict;
  double difference2 = 0.0, squared_error = 0.0, light = 0.0, area = 0.0;
  for (std::size_t i = 0; i < a.irradiance.size(); ++i) {
    if (a.irradiance[i] == 0.0) continue;
    light += room.area_of(i) * a.irradiance[i];
    area += room.area_of(i);
  }
  for (std::size_t i = 0; i < a.irradiance.size(); ++i) {
    if (a.irradiance[i] == 0.0 && b.irradiance[i] == 0.0) continue;
    ++verdict.numbers;
    const auto off = std::max(0.0, std::abs(a.irradiance[i] - b.irradiance[i]) - a.bound[i] - b.bound[i]);
    const auto variance = a.error[i] * a.error[i] + b.error[i] * b.error[i];
    difference2 += room.area_of(i) * off * off;
    squared_error += room.area_of(i) * variance;
    const auto z = off > 0.0 ? off / std::sqrt(std::max(variance, 1e-300)) : 0.0;
    if (z > verdict.worst && std::max(a.irradiance[i], b.irradiance[i]) > faint * light / area) {
      verdict.worst = z;
      verdict.where = i;
    }
  }
  verdict.root_mean_square =
      difference2 > 0.0 ? std::sqrt(difference2 / std::max(squared_error, 1e-300)) : 0.0;
  return verdict;
}

class Agreement : public testing::TestWithParam<truth::AgreementRoom> {};

TEST_P(Agreement, every_method_gives_the_light_of_every_other_within_their_stated_errors) {
  Room room(GetParam().make());
  ASSERT_GE(room.patches().size(), 40u);
  ASSERT_LE(room.patches().size(), 300u);
  const std::array answers = {room.dense(),   room.lines(),    room.hemicube(),
                              room.sampled(), room.shooting(), room.reference()};
  for (const auto& answer : answers)
    EXPECT_LE(std::abs(answer.out_of_balance), answer.balance_allowed)
        << answer.method << ": what was absorbed, escaped and was lost is not what was emitted";
  for (std::size_t i = 0; i < answers.size(); ++i)
    for (std::size_t j = i + 1; j < answers.size(); ++j) {
      const auto& a = answers[i];
      const auto& b = answers[j];
      const auto verdict = compare(room, a, b);
      const auto pair = fmt::format("{} and {} in {}", a.method, b.method, GetParam().name);
      const auto at = verdict.where;
      EXPECT_GT(verdict.numbers, 0u) << pair;
      EXPECT_LE(verdict.worst, worst_allowed)
          << pair << " are " << verdict.worst << " sigma apart at number " << at << ": " << a.irradiance[at]
          << " and " << b.irradiance[at];
      EXPECT_LE(verdict.root_mean_square, mean_allowed)
          << pair << " are " << verdict.root_mean_square << " sigma apart on average";
    }
}

INSTANTIATE_TEST_SUITE_P(Rooms, Agreement, testing::ValuesIn(truth::agreement_rooms()),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace luxel
