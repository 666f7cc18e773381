// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace luxel {

// Takes accessors, and bytes, that nothing names any more out of a glTF file of one buffer, and counts the
// others anew. Nothing is done where the file uses an extension that may name them in ways not known here.
void drop_unused(nlohmann::json& root, std::string& bytes);

}  // namespace luxel
