// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace luxel {

// A colour as a person types it: one number for all bands; and where there are three bands red,green,blue
// (linear), or #rrggbb (sRGB, as a colour picker has it). [band], each from 0 to `most`. Throws UsageError
// that begins with `what`.
std::vector<float> colour_of_bands(const std::string& what, const std::string& text, std::size_t bands,
                                   float most);

}  // namespace luxel
