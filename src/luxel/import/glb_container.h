// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "luxel/core/json.h"

namespace luxel {

// Returns a GLB of the JSON and the bytes of its first buffer, whose length is written into the JSON. Without
// bytes the file has no buffers. Throws InputError, naming `source`, where it is beyond the 4 GiB of a GLB.
std::string glb_container(SortedJson root, std::string_view binary, const std::string& source);

}  // namespace luxel
