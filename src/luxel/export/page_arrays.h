// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "luxel/core/json.h"

namespace luxel {

// The numbers of a page, array after array, and the index by which the page finds them. The bytes of an array
// are stored by place: the first bytes of all numbers come first, then the second ones. Similar bytes are
// then adjacent and deflate well.
class PageArrays {
 public:
  // Each number is stored as its difference from the one `stride` before it, which is small where neighbours
  // are alike; positive and negative differences alternate (0, -1, 1, -2, ...). stride 0: the numbers
  // themselves.
  void add_differences(std::string_view name, std::span<const std::int32_t> values, std::size_t stride);
  void add(std::string_view name, std::span<const std::uint8_t> values);
  // A file, as it is.
  void add_file(std::string_view name, std::string_view bytes);

  const std::string& bytes() const { return bytes_; }
  // [{"name":...,"type":"i32","count":...,"stride":...}, ...] in the order of the bytes; type: i32 or u8.
  const Json& list() const { return list_; }

 private:
  std::string bytes_;
  Json list_ = Json::array();
};

// Returns the value as JSON text that an HTML script may contain: nothing in it ends the script.
std::string page_json(const Json& value);

}  // namespace luxel
