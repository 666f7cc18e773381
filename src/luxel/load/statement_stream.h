// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <streambuf>
#include <string>
#include <string_view>

#include "luxel/load/text.h"

namespace luxel {

// Hands a text to a parser one statement at a time. A parser that reads character by character (tinyobjloader
// does) asks for the next statement only when it is done with this one, so whoever it calls back in between
// can ask here for the statement's text and line.
class StatementStream : public std::streambuf {
 public:
  explicit StatementStream(std::string_view text) : statements_(text) {}

  const std::string& text() const { return statements_.text(); }
  std::size_t line() const { return statements_.line(); }

 protected:
  int_type underflow() override {
    if (gptr() < egptr()) return traits_type::to_int_type(*gptr());
    if (!statements_.next()) return traits_type::eof();
    buffer_ = statements_.text();
    // The blank makes a bare "v" a statement like any other; tinyobjloader would step over it.
    buffer_ += " \n";
    setg(buffer_.data(), buffer_.data(), buffer_.data() + buffer_.size());
    return traits_type::to_int_type(buffer_.front());
  }

 private:
  Statements statements_;
  std::string buffer_;
};

}  // namespace luxel
