// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace luxel {

// [texture]: whether a material names it.
std::vector<bool> used_textures(nlohmann::json& root);

// Takes accessors, and bytes, that nothing names any more out of a glTF file of one buffer, and counts the
// others anew; so too textures that were used once, [texture] as used_textures(), with their pictures and
// samplers: what nothing ever used is its author's. Nothing is done where the file uses an extension that may
// name them in ways not known here.
void drop_unused(nlohmann::json& root, std::string& bytes, const std::vector<bool>& once_used);

}  // namespace luxel
