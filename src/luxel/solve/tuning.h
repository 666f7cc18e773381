// SPDX-License-Identifier: Apache-2.0
// Every constant chosen for the sampled method, with its derivation or measurement. docs/theory.md and
// docs/performance.md describe the measurements. A grain is the size of a chunk of a loop, 10 us to 1 ms of
// work: the results do not depend on it, apart from the order of sums.
#pragma once

#include <cstddef>
#include <cstdint>

#include "luxel/trace/gather_rays.h"
#include "luxel/trace/gather_sides.h"

namespace luxel::tuning {

// ---- Light that is shot before the first samples, sampled.cpp ----

namespace first_light {

// Unshot power at which the light that the iteration starts from ends, as a fraction of the emitted power.
// The iteration converges from any start; a good one saves sweeps.
constexpr double second_tolerance = 0.01;

}  // namespace first_light

// ---- The first samples, sampling.cpp ----

namespace first_samples {

// Shadow rays, and gather rays, of the first samples at least: some hundredths of a second.
constexpr std::uint64_t min_rays = 1 << 17;
// Shadow rays of each side and replicate among these, at least. Where one of eight tells which part of the
// lamps is seen, all replicates follow it (direct_light.h): with 1, sides that get no more show as bright
// specks.
constexpr std::uint32_t min_shadow_rays = 4;
// Neighbouring receivers whose shadow rays are doubled together: those that share one scrambled sequence.
constexpr std::uint32_t unit_positions = sequence_positions;

}  // namespace first_samples

// ---- Hits, hit_store.cpp ----

namespace hits {

constexpr std::size_t rows_per_job = 4 * GatherRays::max_rows;  // rays of a task: some 100 us

}  // namespace hits

// ---- Sides whose rays count one way, survey_sides.cpp ----

namespace one_way {

constexpr std::uint32_t probes = 4;  // per side; finds 1 - 0.5^4 = 94 % of the sides that are half covered
constexpr float min_height =
    8.0f;  // of a triangle, in lifts of an origin: rounding moves a point by less than one
constexpr float probe_length = 8.0f;      // in lifts, too
constexpr float probe_fraction = 1e-3f;   // of the square root of the area, if that is longer
constexpr std::size_t probe_grain = 256;  // sides per chunk

}  // namespace one_way

// ---- Sides that no light reaches, survey_sides.cpp ----

namespace unreached {

// Receivers that count as reached together. One ray in 8 replicates finds light that comes from 1 % of
// directions with a probability of 8 %; 64 neighbours with 99.5 %.
constexpr std::uint32_t neighbours = 64;
constexpr std::size_t reach_grain = 4096;  // receivers per chunk

}  // namespace unreached

// ---- Rows of the operator, sampled_operator.cpp and sampled_operator_rows.cpp ----

namespace rows {

constexpr std::size_t grain = 1 << 14;  // numbers per chunk of a loop: some 10 us of work

// Elements whose radiosities stay in the second cache without prefetching: 1 MiB of 16 bytes.
constexpr std::size_t cached_elements = 1u << 16;

// Rays traced at a time where hits are streamed: 16 MiB of hits, and as much of their senders.
constexpr std::uint64_t held_rays = std::uint64_t{1} << 22;

// Sides that count one way: neighbours tested together; how many standard deviations their row sum must be
// off 1 (5: one false alarm in three million; a false alarm costs rays, not accuracy); and by how much at
// least, since the control variate corrects row sums anyway.
constexpr std::uint32_t tested_positions = 64;
constexpr double max_deviations = 5.0;
constexpr double min_deviation = 0.02;

}  // namespace rows

// ---- Influences of replicates, replicate_solve.cpp ----

namespace influence {

// Tolerance of influences: the standard deviation of 8 replicates is only good to 27 % (1 / sqrt(2 * 7)).
constexpr double influence_tolerance = 0.05;
// Tolerance of the sum of influences over all sides, in which the noise of single sides cancels. Measured on
// the Cornell box at 5 %, 30 seeds, true spread of the power over the stated one: 1.54 without it, 1.35 with
// 0.05, 1.31 with 0.01, 1.30 with all sides solved to 1e-5.
constexpr double influence_sum_tolerance = 0.01;
constexpr std::size_t influence_memory = 3;  // earlier sweeps in Anderson's acceleration, two vectors each
constexpr std::size_t grain = 16384;         // numbers per chunk

}  // namespace influence

// ---- The spread of replicates, replicate_spread.cpp ----

namespace spread {

constexpr std::size_t block_numbers =
    768;  // of each replicate at a time: 8 replicates fit in the first cache (24 KiB)

}  // namespace spread

// ---- The answer, sampled_light.cpp ----

namespace answer {

constexpr std::size_t grain = 4096;  // receivers per chunk
constexpr std::uint32_t hue_positions =
    64;  // neighbours whose mean colour replaces that of an estimate below 0
// Receivers from which on light is smoothed. Fewer have few windows, so that the estimate of the bias is too
// noisy, and there is little to gain.
constexpr std::size_t min_smoothed_receivers = 4096;

}  // namespace answer

// ---- The seen error, seen_measure.cpp ----

namespace seen {

// Part of the importance that goes by area alone, for light that reaches the views by surfaces that they do
// not see.
constexpr double area_fraction = 0.05;

// Weight of a neighbourhood's density in that of its half, in directions; see pool_units.h. And of the mean
// light of a unit in the importance of the sides that were met there.
constexpr double prior_hits = 1.0;

constexpr std::size_t radiance_grain = 4096;  // receivers per chunk

}  // namespace seen

// ---- Errors of gathered light, ray_allocation.cpp ----

namespace gathered {

// Part of the squared error that is light no ray has found yet, with the same variance everywhere: in
// proportion to area, over rays per area.
constexpr double even_part = 0.05;

}  // namespace gathered

// ---- Units of samples, ray_allocation.cpp ----

namespace units {

// Smallest fraction of the variance that smoothing is taken to leave: light that no ray has found yet looks
// smooth. With 0.02 a furnished hall needed 40 % more rays for the same seen error.
constexpr double min_noise_left = 0.2;

// Processor time of a shadow ray over that of a gather ray with its part of all sweeps. Measured: 0.66 in the
// Cornell box, 0.6 in a furnished hall, 0.78 in the reading room, 0.5 in a living room lit through windows.
constexpr double shadow_ray_cost = 0.6;

}  // namespace units

// ---- Doublings of units, ray_allocation.cpp ----

namespace doublings {

// Fraction of the squared error left by doubling the samples. Independent points leave 0.5; Owen-scrambled
// ones less.
constexpr double left_by_doubling = 0.45;
// Doublings at a time: 16 times the samples by one estimate of the error, which is good to 27 %.
constexpr int max_doublings = 4;

}  // namespace doublings

// ---- The next round, ray_allocation.cpp ----

namespace rounds {

// Fraction of the target squared error that a round aims at: missing it costs another round.
constexpr double aim = 0.8;
// Cost of a round over that of all before it. At least: a run that tests its error often stops at the first
// estimate low by chance. At most: where an error ends the run, after its first answer and later; and where a
// bound of rays or time may end it, so that it ends near it. With 4 for all rounds a kitchen took 610 million
// rays to 2 % and had 1.2 %, since its squared error fell with a power of 1.4 of the cost instead of 0.95;
// with 1 a hall took 115 instead of 83 million, as one more answer was needed.
constexpr double min_growth = 0.5;
constexpr double growth_after_first = 4.0;
constexpr double growth_later = 1.5;
constexpr double growth_to_bound = 1.0;
// Squared error ~ cost^-p. Measured in four scenes: from the first answer to the second 1.4 to 2.0, later
// 1.1 to 3.4. It does not depend on the rounds before, so that a resumed run plans as one that was not
// stopped.
constexpr double first_exponent = 1.9;
constexpr double later_exponent = 1.5;

}  // namespace rounds

// ---- Time left, run_progress.cpp ----

namespace forecast {

// Squared error ~ cost^-p. Measured in the Cornell box, a furnished hall, a kitchen and the reading room: in
// the first half again as many samples after the first answer 2 to 10, 3.3 in most; 1.3 to 2.0 from the first
// answer to the second, to which the next constant is fitted; 1.1 to 3.4 from there to the third.
constexpr double first_exponent = 3.3;
constexpr double second_exponent = 1.3;
constexpr double third_exponent = 2.1;
// Exponent between the first two answers, and its weight in the next one.
constexpr double usual_first = 1.7;
constexpr double weight_of_first = 0.1;
// Later: p = own_part + weight_of_last * (exponent between the last answers), fitted to the same scenes.
constexpr double own_part = 1.15;
constexpr double weight_of_last = 0.24;
constexpr double min_exponent = 1.0, max_exponent = 2.2;
// Ratio of the first error to the error target above which the time estimate waits for the second answer.
constexpr double max_first_error = 10.0;
// Seconds of samples ~ cost^p: small rounds use the processors less well. Measured 0.76 to 0.9; later rounds
// are nearer to 1.
constexpr double sampling_exponent = 0.87;
// Seconds per cost of the second round over those of all before the first answer, which includes more than
// samples. Measured 0.55 to 0.75.
constexpr double second_pace = 0.72;
// Additional seconds of an answer per cost of further samples, over the seconds per cost of sampling them:
// measured 0.07 to 0.19; and the largest value accepted.
constexpr double answer_slope = 0.13, max_answer_slope = 0.5;
constexpr double overdue =
    0.2;  // time left of an answer that takes longer than forecast, over its time so far
constexpr int max_rounds = 100;
// Weight of the newest round in the logarithm of the pace; the rest is the forecast from the rounds before,
// since a single round on a busy machine is unreliable.
constexpr double weight_of_newest = 0.7;
// Logarithm of the predicted squared error over its target: another round has weight 0 up to the first and 1
// from the second on, so that a small change does not add a whole round.
constexpr double surely_reached = -0.03, surely_missed = 0.05;
// The error that the plan expects: its square is too small by this factor (measured 1.1 to 2.6), its weight
// in the logarithm, and the limit of its exponent.
constexpr double plan_excess = 1.25;
constexpr double weight_of_plan = 0.95;
constexpr double max_believed_exponent = 3.3;

}  // namespace forecast

}  // namespace luxel::tuning
