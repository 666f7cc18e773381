// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace luxel {

bool is_data_uri(std::string_view uri);

// The bytes of a data URI (RFC 2397) of any type in base64, or nothing where it is damaged. Padding may lack.
std::optional<std::string> data_of_uri(std::string_view uri);

// The file that a reference (RFC 3986) names, with %20 and its like resolved and without query; or nothing
// where it has a scheme (http:), or is empty.
std::optional<std::filesystem::path> file_of_uri(std::string_view uri);

}  // namespace luxel
