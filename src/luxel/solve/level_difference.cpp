// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/level_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "luxel/core/barycentric.h"
#include "luxel/patch/side.h"
#include "luxel/solve/curved_faces.h"

namespace luxel {
namespace {

using Pair = std::array<double, 2>;  // of both solutions

// The mean of squared differences over a patch side, and of the noise in it.
struct Sum {
  double squared = 0.0, noise = 0.0;
  void add(double weight, const Pair& d) {
    const auto half = 0.5 * (d[0] - d[1]);
    squared += weight * d[0] * d[1];
    noise += weight * half * half;
  }
};

// differences(patch, back, band): the sum for a patch side.
template <typename Differences>
FieldDifference summed(const PatchSet& patches, const Context& context, const Differences& differences) {
  constexpr std::size_t chunk = 4096;
  const auto bands = patches.band_count();
  FieldDifference result;
  for (const bool back : {false, true}) {
    auto& squared = result.squared.of(back);
    auto& noise = result.noise.of(back);
    squared.assign(patches.size() * bands, 0.0);
    noise.assign(patches.size() * bands, 0.0);
    context.for_chunks(patches.size(), chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto p = begin; p < end; ++p) {
        if (back && !patches.material_of(p).two_sided) continue;
        for (std::size_t b = 0; b < bands; ++b) {
          const auto sum = differences(p, back, b);
          squared[p * bands + b] = sum.squared;
          noise[p * bands + b] = sum.noise;
        }
      }
    });
  }
  return result;
}

double mean_at(const Answer& answer, std::size_t patch, bool back, std::size_t band) {
  const auto& s = answer.solution;
  return static_cast<double>(s.irradiance.of(back)[patch * s.bands.size() + band]);
}

double field_at(const Answer& answer, std::size_t patch, const Vec3d& weights, bool back, std::size_t band) {
  const auto& light = answer.smooth.irradiance.of(back);
  const auto bands = answer.solution.bands.size();
  const auto& corners = answer.smooth.corners[patch];
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
    sum += weights[k] * static_cast<double>(light[corners[static_cast<std::size_t>(k)] * bands + band]);
  return sum;
}

// The field within the face of a patch alone, at the centroid of the patch.
double field_within_face(const FaceCorners& corners, const Answer& answer, std::size_t patch, bool back,
                         std::size_t band) {
  double field = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0.0, count = 0.0;
    corners.for_patches_at(patch, k, [&](std::size_t p) {
      sum += mean_at(answer, p, back, band);
      ++count;
    });
    field += sum / count / 3.0;
  }
  return field;
}

Sum sum_of(const Pair& d) {
  Sum sum;
  sum.add(1.0, d);
  return sum;
}

// Compares the squares of the means of both answers, which are squared + noise. By the products alone the
// choice would fall on those that noise makes negative.
Sum smaller(const Sum& a, const Sum& b) { return b.squared + b.noise < a.squared + a.noise ? b : a; }

}  // namespace

Solution mean_of(const Answers& answers) {
  auto mean = answers[0].solution;
  const auto combine = [&](FrontAndBack<float> Solution::*values, const auto& of_both) {
    for (const bool back : {false, true}) {
      auto& to = (mean.*values).of(back);
      const auto& from = (answers[1].solution.*values).of(back);
      std::transform(to.begin(), to.end(), from.begin(), to.begin(), of_both);
    }
  };
  const auto half_sum = [](float a, float b) { return 0.5f * (a + b); };
  combine(&Solution::irradiance, half_sum);
  combine(&Solution::radiosity, half_sum);
  combine(&Solution::standard_error, [](float a, float b) { return 0.5f * std::hypot(a, b); });
  for (const auto error : {&Solution::seen_error, &Solution::predicted_error})
    mean.*error = 0.5 * std::hypot(answers[0].solution.*error, answers[1].solution.*error);
  return mean;
}

Contributions weighed(const FieldDifference& difference, std::span<const double> weights, std::size_t bands) {
  const auto patches = weights.size() / 2;
  Contributions sum{std::vector<double>(patches, 0.0), std::vector<double>(patches, 0.0)};
  for (std::size_t p = 0; p < patches; ++p)
    for (const bool back : {false, true})
      for (auto i = p * bands; i < (p + 1) * bands; ++i) {
        const auto weight = weights[SideId(p, back).index()];
        sum.squared[p] += weight * difference.squared.of(back)[i];
        sum.noise[p] += weight * difference.noise.of(back)[i];
      }
  return sum;
}

FieldDifference difference_of_levels(const PatchSet& wholes, const Answers& coarse, const PatchSet& parts,
                                     const Answers& fine, std::span<const std::uint32_t> parent,
                                     const Context& context) {
  assert(parent.size() == parts.size());
  const CurvedFaces faces(wholes, coarse[0].smooth);
  return summed(parts, context, [&](std::size_t p, bool back, std::size_t b) {
    const auto weights = barycentric(wholes.points(parent[p]), parts.centroid(p));
    Pair d, within;
    for (std::size_t i = 0; i < 2; ++i) {
      d[i] = mean_at(fine[i], p, back, b) - field_at(coarse[i], parent[p], weights, back, b);
      within[i] = mean_at(fine[i], p, back, b) - mean_at(coarse[i], parent[p], back, b);
    }
    return faces.has(parent[p]) ? smaller(sum_of(d), sum_of(within)) : sum_of(d);
  });
}

FieldDifference variation_within_wholes(const PatchSet& wholes, const Answers& coarse, const PatchSet& parts,
                                        const Answers& fine, std::span<const std::uint32_t> parent,
                                        const Context& context) {
  std::vector<std::size_t> begin(wholes.size() + 1, 0);  // [whole]: its first part
  for (const auto whole : parent) ++begin[whole + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  const CurvedFaces faces(wholes, coarse[0].smooth);
  return summed(wholes, context, [&](std::size_t whole, bool back, std::size_t b) {
    const auto fraction = [&](std::size_t part) {
      return static_cast<double>(parts.area[part]) / static_cast<double>(wholes.area[whole]);
    };
    // field(part): of both answers, at the centroid of the part.
    const auto variation_from = [&](const auto& field) {
      std::vector<Pair> differences;
      Pair mean{};
      for (auto part = begin[whole]; part < begin[whole + 1]; ++part) {
        auto& d = differences.emplace_back(field(part));
        for (std::size_t i = 0; i < 2; ++i) {
          d[i] = mean_at(fine[i], part, back, b) - d[i];
          mean[i] += fraction(part) * d[i];
        }
      }
      Sum sum;
      for (std::size_t k = 0; k < differences.size(); ++k)
        sum.add(fraction(begin[whole] + k), {differences[k][0] - mean[0], differences[k][1] - mean[1]});
      return sum;
    };
    const auto sum = variation_from([&](std::size_t part) {
      const auto weights = barycentric(wholes.points(whole), parts.centroid(part));
      return Pair{field_at(coarse[0], whole, weights, back, b), field_at(coarse[1], whole, weights, back, b)};
    });
    return faces.has(whole) ? smaller(sum, variation_from([](std::size_t) { return Pair{}; })) : sum;
  });
}

FieldDifference residual_within_patches(const PatchSet& patches, const Answers& answers,
                                        const Context& context) {
  const CurvedFaces faces(patches, answers[0].smooth);
  const FaceCorners corners(faces, answers[0].smooth);
  return summed(patches, context, [&](std::size_t p, bool back, std::size_t b) {
    Pair d, within{};
    for (std::size_t i = 0; i < 2; ++i) {
      d[i] = field_at(answers[i], p, Vec3d(1.0 / 3.0), back, b) - mean_at(answers[i], p, back, b);
      if (faces.has(p))
        within[i] = field_within_face(corners, answers[i], p, back, b) - mean_at(answers[i], p, back, b);
    }
    return faces.has(p) ? smaller(sum_of(d), sum_of(within)) : sum_of(d);
  });
}

Solution light_of_wholes(const PatchSet& wholes, const PatchSet& parts, const Solution& light,
                         std::span<const std::uint32_t> parent) {
  assert(parent.size() == parts.size());
  const auto bands = wholes.band_count();
  const auto mean = [&](const std::vector<float>& values) {
    std::vector<float> result(wholes.size() * bands, 0.0f);
    std::vector<double> area(wholes.size(), 0.0);
    for (std::size_t p = 0; p < parts.size(); ++p) area[parent[p]] += static_cast<double>(parts.area[p]);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const auto fraction = static_cast<float>(static_cast<double>(parts.area[p]) / area[parent[p]]);
      for (std::size_t b = 0; b < bands; ++b)
        result[parent[p] * bands + b] += fraction * values[p * bands + b];
    }
    return result;
  };
  Solution result;
  result.bands = light.bands;
  result.irradiance.front = mean(light.irradiance.front);
  result.irradiance.back = mean(light.irradiance.back);
  result.provenance.scene_fingerprint = light.provenance.scene_fingerprint;
  return result;
}

double squared_light(const PatchSet& patches, const Answers& answers) {
  const auto bands = patches.band_count();
  double sum = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < bands; ++b)
      for (const bool back : {false, true})
        sum += static_cast<double>(patches.area[p]) * mean_at(answers[0], p, back, b) *
               mean_at(answers[1], p, back, b);
  return sum;
}

}  // namespace luxel
