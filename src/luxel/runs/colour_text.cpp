// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/colour_text.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "luxel/image/image.h"
#include "luxel/runs/option_set.h"
#include "luxel/scene/colour_spectra.h"

namespace luxel {
namespace {

std::optional<std::vector<float>> hexadecimal(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return {};
  std::vector<float> colour;
  for (std::size_t i = 1; i < 7; i += 2) {
    int code = 0;
    const auto* const end = text.data() + i + 2;
    if (std::from_chars(text.data() + i, end, code, 16).ptr != end) return {};
    colour.push_back(srgb_decode(static_cast<float>(code) / 255.0f));
  }
  return colour;
}

}  // namespace

std::vector<float> colour_of_bands(const std::string& what, const std::string& text, const PatchSet& patches,
                                   float most) {
  const auto takes_colours = patches.has_colours();
  std::optional<std::vector<float>> colour;
  if (const auto grey = parse_number(text)) colour = std::vector(patches.band_count(), *grey);
  const bool is_grey = colour.has_value();
  if (!colour && takes_colours) colour = hexadecimal(text);
  if (const auto three = parse_three(text); !colour && takes_colours && three)
    colour = {static_cast<float>(three->x), static_cast<float>(three->y), static_cast<float>(three->z)};
  const auto fits = [&](float x) { return x >= 0.0f && x <= most; };
  if (!colour || !std::all_of(colour->begin(), colour->end(), fits))
    throw UsageError(fmt::format("{}: expected {} from 0 to {:g}, not '{}'", what,
                                 takes_colours ? "#rrggbb, red,green,blue or one number" : "one number", most,
                                 text));
  if (is_grey || patches.wavebands.empty()) return *colour;
  const Vec3 rgb((*colour)[0], (*colour)[1], (*colour)[2]);
  const ColourSpectra spectra(patches.wavebands);
  return most <= 1.0f ? spectra.reflectance(rgb) : spectra.tint(rgb);
}

}  // namespace luxel
