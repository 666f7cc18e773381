// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/runs/outside_settings.h"

namespace luxel {

// The output of `luxel sky`.
std::string text_of(const OutsideLight& light);
std::string json_of(const OutsideLight& light, const std::string& output);

}  // namespace luxel
