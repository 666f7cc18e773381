// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace luxel {

using Mat4 = glm::mat4;  // columns; from one space to another, of homogeneous coordinates
using Vec4 = glm::vec4;

}  // namespace luxel
