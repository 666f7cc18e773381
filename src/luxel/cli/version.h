// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// From the project's CMakeLists.txt, the one place where the version stands.
inline constexpr const char* program_version = LUXEL_VERSION;

}  // namespace luxel
