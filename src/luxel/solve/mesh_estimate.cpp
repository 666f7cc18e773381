// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/mesh_estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "luxel/patch/refine_patches.h"
#include "luxel/patch/side.h"
#include "luxel/solve/cut_patches.h"
#include "luxel/solve/seen_measure.h"

namespace luxel {
namespace {

// Fraction of the difference that a cut found which counts with the residual of its parts. Measured on
// Cornell boxes under small lamps, against all patches cut once more: the largest 1 % by this sum have 0.77
// of the error, by the difference alone 0.66, by the residual alone 0.76; the sum is 0.7 to 1.9 times too
// small.
constexpr double carried = 0.1;

// Fraction of its squared error that the residual of a patch shows, where nothing is known of its last cut.
// Measured against the exact light at the edges of a shadow: 0.17 to 0.32, on 18 meshes with errors of 0.7 to
// 5 %.
constexpr double shown_by_residual = 0.27;

// Estimates count by how much they exceed this many times the noise around them, as 9 % do where all is
// noise. With 0 times, refinement beside a wall lamp made clusters of tiny patches in smooth light and left
// the edge of the light coarse; with 12 it did not cut all of the edge.
constexpr double noises = 2.0;
constexpr std::size_t noise_reach = 8;  // patches before and after one, whose noise is around it

void copy_row(const std::vector<double>& from, std::size_t patch, std::vector<double>& to, std::size_t part,
              std::size_t bands) {
  std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(patch * bands), bands,
              to.begin() + static_cast<std::ptrdiff_t>(part * bands));
}

// The root of a sum of squares, with its standard error, of which `fraction` is known. The standard deviation
// of a product of two differences of noise σ is σ²; its noise is σ²/2 times a chi-squared variable of one
// degree of freedom, its mean square 3/4 σ⁴.
double sqrt_of_sum(const Contributions& contributions, double fraction) {
  const auto& [squared, noise] = contributions;
  const auto sum = std::accumulate(squared.begin(), squared.end(), 0.0);
  const auto squares = std::inner_product(noise.begin(), noise.end(), noise.begin(), 0.0);
  return std::sqrt((std::max(0.0, sum) + std::sqrt(4.0 / 3.0 * squares)) / fraction);
}

// The seen error of differences that noise may bring below 0, with the sides' importance. Where nearly all
// views have an error of 0 by that, no side is important; then all are by what the noise can hide.
SeenSides seen_sides_of(const PatchSet& patches, const Tracer& tracer, const Answers& answers,
                        const FieldDifference& difference, const Context& context) {
  const auto irradiance = mean_of(answers).irradiance;
  auto seen = seen_sides(patches, tracer, irradiance, difference.squared, context);
  const auto is_none = [](double importance) { return importance == 0.0; };
  if (!std::all_of(seen.importance.begin(), seen.importance.end(), is_none)) return seen;
  auto hidden = difference.squared;
  for (const bool back : {false, true})
    for (std::size_t i = 0; i < hidden.of(back).size(); ++i)
      hidden.of(back)[i] = std::max(hidden.of(back)[i], difference.noise.of(back)[i]);
  seen.importance = seen_sides(patches, tracer, irradiance, hidden, context).importance;
  return seen;
}

}  // namespace

std::vector<double> weights_in_power(const PatchSet& patches, const Answers& answers) {
  const auto light = squared_light(patches, answers);
  std::vector<double> weights(side_count(patches.size()), 0.0);
  for (std::size_t s = 0; light > 0.0 && s < weights.size(); ++s)
    weights[s] = static_cast<double>(patches.area[SideId::at(s).patch()]) / light;
  return weights;
}

std::vector<double> beyond_noise(std::span<const double> squared, std::span<const double> noise) {
  std::vector<double> sum{0.0};  // [patch]: noise of all before it
  for (const auto n : noise) sum.push_back(sum.back() + n);
  std::vector<double> result(squared.begin(), squared.end());
  for (std::size_t p = 0; p < result.size(); ++p) {
    const auto begin = p > noise_reach ? p - noise_reach : 0;
    const auto end = std::min(noise.size(), p + noise_reach + 1);
    result[p] -= noises * (sum[end] - sum[begin]) / static_cast<double>(end - begin);
  }
  return result;
}

void MeshEstimate::note_cut(FieldDifference change, std::span<const std::uint32_t> parent,
                            std::size_t bands) {
  const bool is_first = change_.squared.front.empty();
  for (std::size_t p = 0; !is_first && p < parent.size(); ++p) {
    if (is_part(parent, p)) continue;
    for (const bool back : {false, true}) {
      copy_row(change_.squared.of(back), parent[p], change.squared.of(back), p, bands);
      copy_row(change_.noise.of(back), parent[p], change.noise.of(back), p, bands);
    }
  }
  change_ = std::move(change);
}

void MeshEstimate::look(const PatchSet& patches, const Answers& answers, const Tracer& tracer,
                        ErrorMeasure measure, const Context& context) {
  auto expected = residual_within_patches(patches, answers, context);
  for (const bool back : {false, true})
    for (std::size_t i = 0; i < change_.squared.of(back).size(); ++i) {
      expected.squared.of(back)[i] += carried * change_.squared.of(back)[i];
      expected.noise.of(back)[i] += carried * change_.noise.of(back)[i];
    }
  weights_.clear();
  if (measure == ErrorMeasure::seen)
    weights_ = seen_sides_of(patches, tracer, answers, expected, context).importance;
  if (weights_.empty()) weights_ = weights_in_power(patches, answers);
  expected_ = weighed(expected, weights_, patches.band_count());
}

void MeshEstimate::predict_cut(std::span<const std::uint32_t> parent) {
  auto& squared = expected_.squared;
  std::vector<std::size_t> parts_of(squared.size(), 0);
  for (const auto whole : parent) ++parts_of[whole];
  for (std::size_t p = 0; p < squared.size(); ++p)
    if (parts_of[p] > 1) squared[p] *= left_by_halving;
}

std::vector<std::uint8_t> MeshEstimate::patches_to_cut(double aimed, double max_uncut,
                                                       std::size_t min_count) const {
  const auto& [squared, noise] = expected_;
  std::vector<std::uint32_t> order;
  double left = 0.0;
  for (std::uint32_t p = 0; p < squared.size(); ++p) {
    if (squared[p] <= noise[p]) continue;
    order.push_back(p);
    left += squared[p];
  }
  sort_by_weight(beyond_noise(squared, noise), order);
  const auto enough = max_uncut * left;
  std::size_t count = 0;
  double cut = 0.0;
  std::vector<std::uint8_t> marks(squared.size(), 0);
  for (const auto p : order) {
    if ((left <= enough && count >= min_count) ||
        left + left_by_halving * cut <= aimed * (1.0 - left_by_halving))
      break;
    marks[p] = 1;
    ++count;
    left -= squared[p];
    cut += squared[p];
  }
  return marks;
}

// The estimate is of what halving would remove; left_by_halving of the squared error would remain.
double MeshEstimate::error() const { return sqrt_of_sum(expected_, 1.0 - left_by_halving); }

double mesh_error_of(const PatchSet& patches, const Tracer& tracer, std::array<Solution, 2> halves,
                     ErrorMeasure measure, SmoothOptions smooth, const Context& context) {
  smooth.lights_hidden = false;  // that light is for the eye, and no answer of the solver
  Answers answers;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i].solution = std::move(halves[i]);
    answers[i].smooth = make_smooth_light(patches, answers[i].solution, smooth, context);
  }
  const auto residual = residual_within_patches(patches, answers, context);
  std::vector<double> weights;
  if (measure == ErrorMeasure::seen) {
    auto seen = seen_sides_of(patches, tracer, answers, residual, context);
    if (seen.error > 0.0) return seen.error / std::sqrt(shown_by_residual);
    weights = std::move(seen.importance);
  }
  if (weights.empty()) weights = weights_in_power(patches, answers);
  return sqrt_of_sum(weighed(residual, weights, patches.band_count()), shown_by_residual);
}

}  // namespace luxel
