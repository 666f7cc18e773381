// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/error.h"
#include "luxel/patch/side.h"
#include "luxel/scene/band_colours.h"

namespace luxel {
namespace {

constexpr double max_mean_z2 = 1.5;
constexpr double min_within = 0.9;
constexpr double max_bias = 0.5;         // of the expected RMS
constexpr double max_bias_errors = 5.0;  // alternative limit, in standard errors, where there are few places
constexpr double max_z2 = 36.0;
constexpr double floor_fraction = 0.01;  // of the mean light

// The same place in two solutions: [band]; errors may be empty.
struct Pair {
  std::span<const float> a, b, error_a, error_b;
};

class Sums {
 public:
  void add(std::size_t index, double weight, const Pair& pair) {
    const auto bands = pair.a.size();
    const auto per_band = 1.0 / static_cast<double>(bands);
    Difference place{index};
    double variance = 0.0;
    double together = 0.0;
    for (std::size_t i = 0; i < bands; ++i) {
      const auto a = static_cast<double>(pair.a[i]);
      const auto b = static_cast<double>(pair.b[i]);
      const auto squared_error = square_of(pair.error_a, i) + square_of(pair.error_b, i);
      ++result_.numbers;
      light_ += weight * a;
      squared_light_ += weight * a * a;
      bias_ += weight * (b - a);
      squared_bias_ += weight * (b - a) * (b - a);
      place.a += per_band * a;
      place.b += per_band * b;
      variance += squared_error;
      if (!(squared_error > 0.0)) continue;
      const auto z2 = (b - a) * (b - a) / squared_error;
      ++result_.scored;
      squared_error_ += weight * squared_error;
      together += std::sqrt(squared_error);
      z2_ += std::min(z2, max_z2);
      if (z2 > max_z2) ++result_.outliers;
      within_ += z2 < 1.96 * 1.96 ? 1.0 : 0.0;
    }
    bias_squared_error_ += weight * weight * together * together;
    place.error = per_band * std::sqrt(variance * static_cast<double>(bands));  // bands share their rays
    if (place.a != place.b) result_.largest.push_back(place);
  }

  Comparison result(std::size_t places) {
    auto& r = result_;
    r.relative_rms = ratio(std::sqrt(squared_bias_), std::sqrt(squared_light_));
    r.expected_rms = ratio(std::sqrt(squared_error_), std::sqrt(squared_light_));
    r.mean_bias = ratio(bias_, light_);
    r.bias_error = ratio(std::sqrt(bias_squared_error_), light_);
    r.mean_z2 = ratio(z2_, static_cast<double>(r.scored));
    r.within = ratio(within_, static_cast<double>(r.scored));
    const auto count = std::min(places, r.largest.size());
    std::partial_sort(r.largest.begin(), r.largest.begin() + static_cast<std::ptrdiff_t>(count),
                      r.largest.end(), [](const Difference& x, const Difference& y) {
                        const auto dx = std::fabs(x.b - x.a);
                        const auto dy = std::fabs(y.b - y.a);
                        return dx != dy ? dx > dy : x.index < y.index;
                      });
    r.largest.resize(count);
    return std::move(r);
  }

 private:
  static double square_of(std::span<const float> errors, std::size_t i) {
    return errors.empty() ? 0.0 : static_cast<double>(errors[i]) * static_cast<double>(errors[i]);
  }
  // The ratio of two numbers; defined where the second is 0, since a dark A has no ratio to B.
  static double ratio(double x, double y) {
    if (y != 0.0) return x / y;
    return x == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  }

  Comparison result_;
  double light_ = 0.0, squared_light_ = 0.0, bias_ = 0.0, squared_bias_ = 0.0, squared_error_ = 0.0,
         z2_ = 0.0, within_ = 0.0;
  double bias_squared_error_ =
      0.0;  // bands share their rays: errors of bands are added, squared errors of places are
};

std::span<const float> at(const std::vector<float>& values, std::size_t patch, std::size_t bands) {
  return values.empty() ? std::span<const float>() : std::span(values).subspan(patch * bands, bands);
}
std::span<const float> at(const Image& image, std::size_t pixel) {
  return std::span(&image.pixels[pixel].x, 3);
}

// Converts irradiance to linear sRGB. Bands share their rays, so the error of a colour is at most the sum of
// theirs.
Baked in_plain_colour(const Baked& baked, const std::string& bands_of_both) {
  if (!baked.patches.has_colours() || baked.solution.bands != baked.patches.bands)
    throw MismatchError(fmt::format("the solutions have different bands, {}", bands_of_both));
  const auto colours = baked.patches.colours();
  const auto bands = colours.bands();
  auto plain = baked;
  plain.solution.bands = {"red", "green", "blue"};
  const auto convert = [&](std::vector<float>& values, bool are_errors) {
    std::vector<float> converted;
    for (std::size_t i = 0; i < values.size(); i += bands) {
      Vec3d sum(0.0);
      for (std::size_t b = 0; b < bands; ++b)
        sum += static_cast<double>(values[i + b]) * (are_errors ? glm::abs(colours.of(b)) : colours.of(b));
      for (int k = 0; k < 3; ++k) converted.push_back(static_cast<float>(sum[k]));
    }
    values = std::move(converted);
  };
  for (auto* light : {&plain.solution.irradiance.front, &plain.solution.irradiance.back})
    convert(*light, false);
  for (auto* error : {&plain.solution.standard_error.front, &plain.solution.standard_error.back})
    convert(*error, true);
  return plain;
}

bool have_different_bands(const Baked& a, const Baked& b) { return a.solution.bands != b.solution.bands; }

std::pair<Baked, Baked> in_plain_colour(const Baked& a, const Baked& b) {
  const auto both =
      fmt::format("{} and {}", fmt::join(a.solution.bands, " "), fmt::join(b.solution.bands, " "));
  return {in_plain_colour(a, both), in_plain_colour(b, both)};
}

void check_same_patches(const Baked& a, const Baked& b) {
  if (a.patches.size() != b.patches.size())
    throw MismatchError(
        fmt::format("the solutions are of different meshes, one of {} patches and one of {}: only solutions "
                    "of the same mesh can be compared",
                    a.patches.size(), b.patches.size()));
  if (a.patches.corners != b.patches.corners || a.patches.vertices != b.patches.vertices ||
      a.patches.origin != b.patches.origin)
    throw MismatchError(
        fmt::format("the solutions are of different meshes, though both have {} patches: only solutions of "
                    "the same mesh can be compared",
                    a.patches.size()));
}

void check_same_size(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw MismatchError(fmt::format("the pictures are of different sizes, {} x {} and {} x {} pixels",
                                    a.width, a.height, b.width, b.height));
}

double mean(std::span<const float> bands) {
  double sum = 0.0;
  for (const auto x : bands) sum += static_cast<double>(x);
  return sum / static_cast<double>(bands.size());
}

// pair(index): both values of places [0, count).
template <typename PairOf>
std::vector<float> signed_fractions(std::size_t count, const PairOf& pair) {
  double light = 0.0;
  double lit = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    if (const auto a = mean(pair(i).a); a > 0.0) {
      light += a;
      lit += 1.0;
    }
  const auto floor = lit > 0.0 ? floor_fraction * light / lit : 1.0;
  std::vector<float> fractions(count, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = mean(pair(i).a);
    const auto b = mean(pair(i).b);
    if (a != 0.0 || b != 0.0) fractions[i] = static_cast<float>((b - a) / std::max(a, floor));
  }
  return fractions;
}

bool states_every_error(const Solution& s) {
  return !s.standard_error.front.empty() || !s.standard_error.back.empty();
}

// Places are compared with their errors where both solutions state errors.
Pair side_pair(const Baked& a, const Baked& b, SideId side) {
  const auto bands = a.solution.bands.size();
  const auto of = [&](const SideValues& values) { return at(values.of(side), side.patch(), bands); };
  const auto& x = a.solution;
  const auto& y = b.solution;
  Pair pair{of(x.irradiance), of(y.irradiance), {}, {}};
  if (states_every_error(x) && states_every_error(y)) {
    pair.error_a = of(x.standard_error);
    pair.error_b = of(y.standard_error);
  }
  return pair;
}

}  // namespace

std::optional<bool> Comparison::agrees() const {
  if (!(expected_rms > 0.0)) return std::nullopt;
  const auto bias = std::max(max_bias * expected_rms, max_bias_errors * bias_error);
  if (std::fabs(mean_bias) > bias) return false;
  if (scored > 0) return mean_z2 <= max_mean_z2 && within >= min_within;
  return relative_rms * relative_rms <= max_mean_z2 * expected_rms * expected_rms;
}

Comparison compare_solutions(const Baked& a, const Baked& b, std::size_t places) {
  check_same_patches(a, b);
  if (have_different_bands(a, b)) {
    const auto [plain_a, plain_b] = in_plain_colour(a, b);
    return compare_solutions(plain_a, plain_b, places);
  }
  Sums sums;
  for (std::size_t i = 0; i < side_count(a.patches.size()); ++i) {
    const auto side = SideId::at(i);
    sums.add(i, static_cast<double>(a.patches.area[side.patch()]), side_pair(a, b, side));
  }
  auto result = sums.result(places);
  if (!states_every_error(a.solution) || !states_every_error(b.solution))
    if (a.solution.predicted_error > 0.0 && b.solution.predicted_error > 0.0)
      result.expected_rms = std::hypot(a.solution.predicted_error, b.solution.predicted_error);
  return result;
}

Comparison compare_pictures(const Image& a, const Image& b, const Image* error_a, const Image* error_b,
                            std::size_t places) {
  for (const auto* other : {&b, error_a, error_b})
    if (other) check_same_size(a, *other);
  Sums sums;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    sums.add(i, 1.0,
             {at(a, i), at(b, i), error_a ? at(*error_a, i) : std::span<const float>(),
              error_b ? at(*error_b, i) : std::span<const float>()});
  return sums.result(places);
}

std::vector<float> relative_differences(const Baked& a, const Baked& b) {
  check_same_patches(a, b);
  if (have_different_bands(a, b)) {
    const auto [plain_a, plain_b] = in_plain_colour(a, b);
    return relative_differences(plain_a, plain_b);
  }
  return signed_fractions(side_count(a.patches.size()),
                          [&](std::size_t i) { return side_pair(a, b, SideId::at(i)); });
}

std::vector<float> relative_differences(const Image& a, const Image& b) {
  check_same_size(a, b);
  return signed_fractions(a.pixels.size(), [&](std::size_t i) { return Pair{at(a, i), at(b, i), {}, {}}; });
}

}  // namespace luxel
