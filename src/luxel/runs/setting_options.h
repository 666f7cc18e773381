// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "luxel/core/hint.h"

namespace luxel {

// The option that changes a setting, such as "max-edge".
std::string_view option_of(Setting setting);

}  // namespace luxel
