// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/json.h"

namespace luxel {

// The numbers of a page, array after array, and the index by which the page finds them. Each array is stored
// byte by byte: the first bytes of all numbers come first, then the second ones. Similar bytes are then
// adjacent and deflate to two thirds.
class PageArrays {
 public:
  void add(std::string_view name, const std::vector<float>& values);
  void add(std::string_view name, const std::vector<std::uint32_t>& values);
  void add(std::string_view name, const std::vector<std::uint16_t>& values);  // halves
  void add(std::string_view name, const std::vector<std::uint8_t>& values);

  const std::string& bytes() const { return bytes_; }
  // [{"name":...,"type":"f32","count":...}, ...] in the order of the bytes.
  const Json& list() const { return list_; }

 private:
  void append(std::string_view name, std::string_view type, const void* from, std::size_t count,
              std::size_t size);
  std::string bytes_;
  Json list_ = Json::array();
};

// Returns the value as JSON text that an HTML script may contain: nothing in it ends the script.
std::string page_json(const Json& value);

}  // namespace luxel
