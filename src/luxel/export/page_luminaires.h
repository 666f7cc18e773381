// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/export/page_arrays.h"
#include "luxel/import/gltf_writer.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// The luminaires of a page. "kinds": one per photometric file, with the array of its opening's corners, three
// positions per triangle in steps of 0.1 mm in local axes, and of its photometric solid in codes 0 to 255 of
// the largest radius, see PhotometricSolid; "isSheet": the opening is flat. "places": kind, light group,
// name, position (m), local x and y, luminous flux (lm), radiant intensity where it is largest (W/sr by
// linear sRGB). has_groups: the page's light is divided among light groups.
Json add_luminaires(PageArrays& arrays, const PatchSet& patches, bool has_groups);

// Returns the fractions of red, green and blue light in the lumens of each light group with luminaires; null
// for other groups. Colours are divided by their sum with these weights, so that they preserve lumens.
Json lumens_of_groups(const PatchSet& patches, bool has_groups);

}  // namespace luxel
