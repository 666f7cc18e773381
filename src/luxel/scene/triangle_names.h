// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "luxel/scene/scene.h"

namespace luxel {

// The names of a triangle's object and group, those of the two that the scene has. A name that selects
// surfaces is compared with these and with the material's.
std::vector<std::string> object_and_group(const Scene& scene, std::size_t triangle);

}  // namespace luxel
