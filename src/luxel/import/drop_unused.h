// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/json.h"

namespace luxel {

// [texture]: whether a material names it.
std::vector<bool> used_textures(SortedJson& root);

// Returns false where the file uses an extension that may refer to its arrays in unknown ways.
bool uses_known_extensions(const SortedJson& root);

// Removes accessors, and bytes, without references from a glTF file of one buffer, and renumbers the others.
// Removes textures that were used before, [texture] as used_textures(), with their pictures and samplers;
// textures that were never used belong to the author and stay. Does nothing without uses_known_extensions().
void drop_unused(SortedJson& root, std::string& bytes, const std::vector<bool>& once_used);

}  // namespace luxel
