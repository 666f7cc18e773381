// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace luxel {

// The numbers of a page, array after array, and the list by which the page finds them. Of each array the
// first bytes of all numbers come first, then the second ones: what is alike stands together, and deflates to
// two thirds.
class PageArrays {
 public:
  void add(std::string_view name, const std::vector<float>& values);
  void add(std::string_view name, const std::vector<std::uint32_t>& values);
  void add(std::string_view name, const std::vector<std::uint16_t>& values);  // halves
  void add(std::string_view name, const std::vector<std::uint8_t>& values);

  const std::string& bytes() const { return bytes_; }
  // JSON: {"name":...,"type":"f32","count":...}, ... in the order of the bytes.
  const std::string& list() const { return list_; }

 private:
  void append(std::string_view name, std::string_view type, const void* from, std::size_t count,
              std::size_t size);
  std::string bytes_;
  std::string list_;
};

// The text as JSON that may stand inside of an HTML script: quoted, nothing in it ends the script.
std::string page_string(std::string_view text);

}  // namespace luxel
