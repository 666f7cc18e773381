// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/apply_spectra.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/import/name_list.h"
#include "luxel/import/read_spectra.h"
#include "luxel/scene/colour_spectra.h"
#include "luxel/scene/observer.h"

namespace luxel {
namespace {

using Quantity = MeasuredSpectrum::Quantity;

// The visible wavelengths of all spectra, ascending.
std::vector<double> seen_wavelengths(const std::vector<MeasuredSpectrum>& spectra) {
  std::vector<double> all;
  for (const auto& measured : spectra)
    for (const auto& sample : measured.spectrum.samples())
      if (sample.wavelength >= first_visible && sample.wavelength <= last_visible)
        all.push_back(sample.wavelength);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<double> even_steps(double first, double last, std::size_t steps) {
  std::vector<double> result;
  for (std::size_t i = 0; i < steps; ++i)
    result.push_back(first + (last - first) * static_cast<double>(i) / static_cast<double>(steps));
  return result;
}

std::vector<double> with_gaps_filled(const std::vector<double>& wavelengths) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < wavelengths.size(); ++i) {
    const auto steps = std::ceil((wavelengths[i + 1] - wavelengths[i]) / max_band_step);
    const auto part = even_steps(wavelengths[i], wavelengths[i + 1], static_cast<std::size_t>(steps));
    result.insert(result.end(), part.begin(), part.end());
  }
  result.push_back(wavelengths.back());
  return result;
}

void choose_wavelengths(const LoadOptions& options, const std::vector<MeasuredSpectrum>& spectra,
                        Scene& scene) {
  const auto source = options.spectra.string();
  const auto seen = seen_wavelengths(spectra);
  if (seen.empty() || seen.front() > spectra_begin || seen.back() < spectra_end)
    throw InputError(source,
                     fmt::format("expected wavelengths that reach from {:g} to {:g} nm or beyond, as "
                                 "colours need them, found {}",
                                 spectra_begin, spectra_end,
                                 seen.empty() ? "none that an eye sees"
                                              : fmt::format("{} to {} nm", seen.front(), seen.back())));
  if (options.bands > 0) {
    scene.wavelengths = even_steps(seen.front(), seen.back(), static_cast<std::size_t>(options.bands) - 1);
    scene.wavelengths.push_back(seen.back());
    scene.averages_spectra = true;
    return;
  }
  scene.wavelengths = with_gaps_filled(seen);
  if (scene.wavelengths.size() > static_cast<std::size_t>(max_bands))
    throw with_hints(
        InputError(source, fmt::format("the spectra have {} different wavelengths, more than {}: choose "
                                       "fewer bands at even steps",
                                       scene.wavelengths.size(), max_bands)),
        {{Setting::bands, "41"}});
}

Material& material_of(const MeasuredSpectrum& measured, const std::string& source, Scene& scene) {
  for (auto& material : scene.materials)
    if (material.name == measured.material) return material;
  std::vector<std::string> names;
  for (const auto& material : scene.materials) names.push_back(material.name);
  throw InputError(source, measured.line,
                   fmt::format("expected a material of {}, which has {}, found '{}'", scene.source,
                               name_list(names), measured.material));
}

Spectrum times(double factor, const Spectrum& spectrum) {
  auto samples = spectrum.samples();
  for (auto& sample : samples) sample.value *= factor;
  return Spectrum(std::move(samples));
}

}  // namespace

void apply_spectra(const LoadOptions& options, Scene& scene, const Context& context) {
  const auto source = options.spectra.string();
  const auto spectra = read_spectra(options.spectra);
  choose_wavelengths(options, spectra, scene);
  std::vector<std::string> too_bright;
  for (const auto& measured : spectra) {
    if (measured.quantity == Quantity::sky) {
      if (scene.sky != Vec3(0.0f))
        throw with_hints(
            InputError(source, measured.line, "the sky is given twice: leave one of the two away"),
            {{Setting::sky, "0"}});
      scene.sky_spectrum = measured.spectrum;
      continue;
    }
    auto& material = material_of(measured, source, scene);
    if (measured.quantity == Quantity::radiance) {
      material.emittance_spectrum = times(static_cast<double>(pi), measured.spectrum);
      material.opaque = material.opaque || material.is_lamp();
      continue;
    }
    auto samples = measured.spectrum.samples();
    const auto most = static_cast<double>(options.max_reflectance);
    bool is_capped = false;
    for (auto& sample : samples) {
      is_capped = is_capped || sample.value > most;
      sample.value = std::min(sample.value, most);
    }
    if (is_capped) too_bright.push_back(material.name);
    material.reflectance_spectrum = Spectrum(std::move(samples));
  }
  if (!too_bright.empty())
    context.warn(fmt::format("{}: the reflectance of {} is lowered to {}", source, name_list(too_bright),
                             options.max_reflectance));
}

}  // namespace luxel
