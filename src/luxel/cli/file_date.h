// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace luxel {

// The day on which a file was written, UTC, such as "2026-03-31". At most that of SOURCE_DATE_EPOCH
// (reproducible-builds.org, seconds since 1970) where the environment has it.
std::string day_of_file(const std::filesystem::path& path);

// Today, in UTC, as YYYY-MM-DD; the day of SOURCE_DATE_EPOCH where that is set (reproducible builds).
std::string today();

}  // namespace luxel
