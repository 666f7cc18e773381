// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/solution_light.h"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/student.h"
#include "luxel/render/surface_point.h"
#include "luxel/surface/smooth_irradiance.h"

namespace luxel {
namespace {

void check(const PatchSet& patches, const Solution& solution) {
  const auto values = patches.size() * patches.band_count();
  if (solution.bands != patches.bands || solution.irradiance.front.size() != values ||
      solution.irradiance.back.size() != values)
    throw MismatchError(
        fmt::format("the solution's light is not of these {} patches: solve this scene", patches.size()));
}

// Calls per_side(replicate, side, irradiance by band) for all receivers of the state.
template <typename PerSide>
void for_each_replicate(const PatchSet& patches, const SampleState& samples, const Context& context,
                        const PerSide& per_side) {
  const auto bands = patches.band_count(), groups = patches.group_count();
  context.for_chunks(samples.gathered.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    std::vector<double> irradiance(bands);
    for (auto r = begin; r < end; ++r)
      for (std::size_t s = 0; s < samples.sides.size(); ++s) {
        irradiance.assign(bands, 0.0);
        for (std::size_t i = 0; i < groups * bands; ++i)
          irradiance[i % bands] += static_cast<double>(samples.direct[r][s * groups * bands + i]) +
                                   static_cast<double>(samples.gathered[r][s * groups * bands + i]);
        per_side(r, samples.sides[s], irradiance);
      }
  });
}

// Returns whether the light of all replicates is stored.
bool has_replicates(const PatchSet& patches, const SampleState& samples) {
  const auto values = samples.sides.size() * patches.group_count() * patches.band_count();
  if (samples.gathered.size() < 2 || samples.direct.size() != samples.gathered.size()) return false;
  for (const auto* light : {&samples.direct, &samples.gathered})
    for (const auto& of_replicate : *light)
      if (of_replicate.size() != values) return false;
  return true;
}

}  // namespace

void check_has_lux(const PatchSet& patches, const std::string& file) {
  if (!patches.has_colours())
    throw InputError(file,
                     "its bands are neither red, green and blue nor wavelengths, so that there are no lux");
}

std::vector<double> lux_of_bands(const PatchSet& patches) {
  const auto colours = patches.colours();
  std::vector<double> lux;
  for (std::size_t b = 0; b < colours.bands(); ++b) {
    std::vector<double> one(colours.bands(), 0.0);
    one[b] = 1.0;
    lux.push_back(colours.lumens(one));
  }
  return lux;
}

std::vector<std::vector<float>> replicate_illuminance(const PatchSet& patches, const SampleState& samples,
                                                      const Context& context) {
  if (!has_replicates(patches, samples)) return {};
  const auto lux = lux_of_bands(patches);
  std::vector<std::vector<float>> illuminance(samples.gathered.size(),
                                              std::vector<float>(side_count(patches.size()), 0.0f));
  for_each_replicate(
      patches, samples, context, [&](std::size_t r, SideId side, std::span<const double> irradiance) {
        illuminance[r][side.index()] =
            static_cast<float>(std::inner_product(lux.begin(), lux.end(), irradiance.begin(), 0.0));
      });
  return illuminance;
}

double error_of_replicates(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const auto mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double sum = 0.0;
  for (const auto v : values) sum += (v - mean) * (v - mean);
  return student_widening(n - 1.0) * std::sqrt(sum / (n * (n - 1.0)));
}

const char* name(SolutionErrors errors) {
  switch (errors) {
    case SolutionErrors::not_stated:
      return "none";
    case SolutionErrors::patches:
      return "patches";
    case SolutionErrors::replicates:
      return "replicates";
  }
  return "";
}

SolutionLight::SolutionLight(const PatchSet& patches, const Solution& solution, const SampleState* samples,
                             const Context& context)
    : patches_(patches), solution_(solution), lux_(lux_of_bands(patches)) {
  check(patches, solution);
  smooth_ = make_smooth_light(patches, solution, {}, context);
  if (!solution.standard_error.front.empty()) errors_ = SolutionErrors::patches;
  if (samples == nullptr || !has_replicates(patches, *samples)) return;
  errors_ = SolutionErrors::replicates;
  reflected_lux_.assign(samples->gathered.size(), std::vector<float>(side_count(patches.size()), 0.0f));
  for_each_replicate(
      patches, *samples, context, [&](std::size_t r, SideId side, std::span<const double> irradiance) {
        double reflected = 0.0, transmitted = 0.0;
        for (std::size_t b = 0; b < lux_.size(); ++b) {
          reflected += lux_[b] * static_cast<double>(patches.reflectance(side.patch(), b)) * irradiance[b];
          transmitted +=
              lux_[b] * static_cast<double>(patches.diffuse_transmittance(side.patch(), b)) * irradiance[b];
        }
        reflected_lux_[r][side.index()] += static_cast<float>(reflected);
        if (transmitted > 0.0) reflected_lux_[r][side.opposite().index()] += static_cast<float>(transmitted);
      });
}

double SolutionLight::illuminance(std::span<const double> irradiance) const {
  return std::inner_product(lux_.begin(), lux_.end(), irradiance.begin(), 0.0);
}

double SolutionLight::reflected(const Hit& hit, std::size_t band) const {
  if (!is_reflecting(patches_, hit.patch, hit.back)) return 0.0;
  return smooth_sent_on(patches_, smooth_, hit.side(), {hit.u, hit.v}, band);
}

std::size_t SolutionLight::error_sums() const {
  if (errors_ == SolutionErrors::replicates) return reflected_lux_.size();
  return errors_ == SolutionErrors::patches ? 1 : 0;
}

void SolutionLight::add_error(const Hit& hit, double weight, std::span<double> sums) const {
  if (!hit || !is_reflecting(patches_, hit.patch, hit.back)) return;
  for (std::size_t r = 0; r < reflected_lux_.size(); ++r)
    sums[r] += weight * static_cast<double>(reflected_lux_[r][hit.side().index()]);
  if (errors_ != SolutionErrors::patches) return;
  const auto* of_side = &solution_.standard_error.of(hit.side())[hit.patch * lux_.size()];
  const auto* of_far = &solution_.standard_error.of(hit.side().opposite())[hit.patch * lux_.size()];
  for (std::size_t b = 0; b < lux_.size(); ++b)
    sums[0] +=
        weight * lux_[b] *
        (static_cast<double>(patches_.reflectance(hit.patch, b)) * static_cast<double>(of_side[b]) +
         static_cast<double>(patches_.diffuse_transmittance(hit.patch, b)) * static_cast<double>(of_far[b]));
}

double SolutionLight::error(std::span<const double> sums, double whole) const {
  if (errors_ == SolutionErrors::not_stated || !(whole > 0.0)) return 0.0;
  return (errors_ == SolutionErrors::replicates ? error_of_replicates(sums) : sums[0]) / whole;
}

std::vector<double> SolutionLight::replicates(std::span<const double> sums, double whole) const {
  if (errors_ != SolutionErrors::replicates || !(whole > 0.0)) return {};
  std::vector<double> lux(sums.begin(), sums.end());
  for (auto& value : lux) value /= whole;
  return lux;
}

double SolutionLight::error_degrees_of_freedom() const {
  if (errors_ == SolutionErrors::not_stated) return 0.0;
  return errors_ == SolutionErrors::replicates ? static_cast<double>(reflected_lux_.size() - 1)
                                               : solution_.error_degrees_of_freedom;
}

}  // namespace luxel
