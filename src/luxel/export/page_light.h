// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/export/export_page.h"
#include "luxel/export/page_mesh.h"

namespace luxel {

// The light of a page's vertices in halves: [group][front, then back][vertex][component]. Plain colour has
// three components, the irradiance (W/m²). Light by wavelength has five: the reflected light as linear sRGB
// (W/m²), since a page has no reflectance by wavelength; its illuminance divided by the luminous efficacy;
// and its total power (W/m²).
struct PageLight {
  std::size_t components = 3;
  float unit = 1.0f;  // W/m² of a half's 1
  std::vector<std::uint16_t> halves;
};

// The light of backs that no part shows is 0.
PageLight make_page_light(const PatchSet& patches, const PageMesh& mesh, const SmoothLight& light,
                          std::span<const GroupLight> groups);

// Reflectance and emission of the page's vertices, in halves: [vertex][red, green, blue]. Relative to
// the material's own where it has no texture, else to that times the texture. Empty where the scene has
// neither textures nor colours of corners. For light by wavelength the light includes the reflectance
// of the patch already.
struct PageColours {
  std::vector<std::uint16_t> reflectance, emittance;
};

PageColours make_page_colours(const PatchSet& patches, const PageMesh& mesh);

// Standard errors of illuminance of the sides in steps of a twelfth of an octave: [whole, then each
// group][front, then back][triangle]. 255 is `largest`, 254 a twelfth of an octave less; 0: none, dark, or a
// back that is not shown.
struct PageErrors {
  double largest = 0.0;  // lux
  std::vector<std::uint8_t> codes;
};

PageErrors make_page_errors(const PatchSet& patches, const PageMesh& mesh, const Solution& solution,
                            std::span<const GroupLight> groups);

}  // namespace luxel
