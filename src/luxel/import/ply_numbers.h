// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "luxel/import/ply_header.h"

namespace luxel {

// The numbers behind the header of a PLY file, one after the other. In text, each element has a line of its
// own.
class PlyNumbers {
 public:
  // All arguments must outlive the object.
  PlyNumbers(std::string_view bytes, const PlyHeader& header, const std::string& source)
      : header_(header),
        all_(bytes),
        rest_(bytes.substr(header.size)),
        source_(source),
        line_(header.lines) {}

  // Throws InputError where the rest of the file is too short for all elements of this kind, even if their
  // lists are empty: nothing is allocated for them before.
  void expect(const PlyElement& element) const;

  void begin_element();
  void end_element() const;  // throws where a line has more numbers than its element

  // The next number, of this type; NaN where the text is no number. Throws where the data end.
  double next(PlyType type);
  // The next count of a list, after which that many numbers of its type are left.
  std::size_t next_count(const PlyProperty& list);
  void skip(PlyType type);

  std::size_t line() const { return is_text() ? line_ : 0; }  // of the current element; 0 in binary files
  std::size_t done() const { return all_.size() - rest_.size(); }  // bytes
  [[noreturn]] void refuse(const std::string& message) const;      // with the line, or the byte

 private:
  bool is_text() const { return header_.encoding == PlyEncoding::ascii; }
  std::string_view take_text();
  std::string_view take_bytes(std::size_t count);

  const PlyHeader& header_;
  std::string_view all_, rest_;
  const std::string& source_;
  std::size_t line_;          // of rest_ in binary files: that of the header's end
  std::string_view current_;  // in text: what is left of the element's line
};

}  // namespace luxel
