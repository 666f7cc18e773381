// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/photometry/planes.h"
#include "luxel/photometry/read_eulumdat.h"
#include "luxel/photometry/read_ies.h"
#include "luxel/photometry/read_photometry.h"

namespace luxel {
namespace {

// Files with few angles are consistent to 2.5 % (eleven files of eulumdat-ugr).
constexpr double max_flux_difference = 0.05;

// Header and integral may be at odds; neither is changed.
void compare_fluxes(PhotometrySource& source) {
  const auto& result = source.result;
  const auto flux = result.intensity.linear_flux();
  const auto warn = [&](const std::string& sentence) {
    source.result.warnings.push_back(fmt::format("{}: {}", source.file, sentence));
  };
  if (result.intensity.maximum() == 0.0) return warn("all intensities are 0: the luminaire emits no light");
  if (result.header_flux > 0.0) {
    if (std::abs(flux / result.header_flux - 1.0) > max_flux_difference)
      warn(
          fmt::format("the header states a flux of {:.5g} lm, the intensities integrate to {:.5g} lm and are "
                      "used unchanged",
                      result.header_flux, flux));
    return;
  }
  const auto* lamp = result.lamp();
  if (lamp && lamp->flux > 0.0 && flux > (1.0 + max_flux_difference) * lamp->flux)
    warn(fmt::format(
        "the lamps have {:.5g} lm, the intensities integrate to {:.5g} lm, an efficiency of {:.2f}, and are "
        "used unchanged",
        lamp->flux, flux, flux / lamp->flux));
}

}  // namespace

Photometry read_photometry(std::string_view bytes, const std::string& file,
                           const PhotometryOptions& options) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw InputError(file, "expected text of one byte per character, found UTF-16; save it as UTF-8");
  PhotometrySource source{file, split_lines(bytes), {}};
  source.result.file = file;
  if (is_eulumdat(source.lines))
    read_eulumdat(source, options);
  else if (is_ies(source.lines))
    read_ies(source);
  else
    throw InputError(file,
                     "expected an IES LM-63 file (with a line TILT=) or a EULUMDAT file (with numbers in "
                     "lines 2 to 6), found neither");
  if (options.lamp_set < 1 || options.lamp_set > std::max<std::size_t>(1, source.result.lamps.size()))
    throw InputError(file, fmt::format("there is no lamp set {}, the file has {}", options.lamp_set,
                                       source.result.lamps.size()));
  if (!(std::abs(options.rotate) <= 1e6))
    throw InputError(fmt::format("expected a turn in degrees, found {:g}", options.rotate));
  if (options.rotate != 0.0) {
    try {
      if (const auto warning = turn_luminaire(source.result, options.rotate); !warning.empty())
        source.result.warnings.push_back(fmt::format("{}: {}", file, warning));
    } catch (const InputError& error) {
      throw InputError(file, error.what());
    }
  }
  compare_fluxes(source);
  return std::move(source.result);
}

Photometry load_photometry(const std::string& file, const PhotometryOptions& options) {
  return read_photometry(read_file(file, max_file_bytes), file, options);
}

}  // namespace luxel
