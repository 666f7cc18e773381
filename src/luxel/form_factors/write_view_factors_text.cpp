// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/form_factors/view_factors_file.h"

namespace luxel {
namespace {

// Buffered text output: a hundred million lines need not fit into memory.
class TextFile {
 public:
  explicit TextFile(const std::filesystem::path& path)
      : path_(path), output_(path), file_(std::fopen(output_.temporary().c_str(), "wb")) {
    if (!file_) fail();
  }
  ~TextFile() {
    if (file_) std::fclose(file_);
  }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    if (buffer_.size() > (1u << 20)) flush();
  }
  void commit() {
    flush();
    auto* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) fail();
    output_.commit();
  }

 private:
  void flush() {
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) fail();
    buffer_.clear();
  }
  [[noreturn]] void fail() const { throw cannot_write(path_.string(), std::strerror(errno)); }

  std::filesystem::path path_;
  OutputFile output_;
  std::FILE* file_;
  fmt::memory_buffer buffer_;
};

// The name as a CSV field.
std::string field(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

// The name on one line.
std::string line_of(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return name;
}

}  // namespace

void write_view_factors_csv(const std::filesystem::path& path, const ViewFactors& factors) {
  TextFile file(path);
  file.add("from,to,factor,standard_error\n");
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const auto from = field(factors.name[i]);
    for (auto at = factors.row_begin[i]; at < factors.row_begin[i + 1]; ++at)
      file.add("{},{},{},{}\n", from, field(factors.name[factors.column[at]]), factors.factor[at],
               factors.standard_error[at]);
    for (std::size_t k = 0; k < ViewFactors::sinks; ++k)
      if (factors.sink[k].factor[i] > 0.0)
        file.add("{},({}),{},{}\n", from, ViewFactors::sink_name[k], factors.sink[k].factor[i],
                 factors.sink[k].standard_error[i]);
  }
  file.commit();
}

void write_view_factors_matrix_market(const std::filesystem::path& path, const ViewFactors& factors,
                                      const ViewFactorsNote& note) {
  TextFile file(path);
  file.add("%%MatrixMarket matrix coordinate real general\n");
  file.add("% view factors between {}: line i, column j holds F_ij, A_i F_ij = A_j F_ji\n", note.between);
  file.add("% {}\n", line_of(note.provenance.command_line));
  file.add("% element, area in m2, what goes to the environment, to backs, what was dropped, name\n");
  for (std::size_t i = 0; i < factors.size(); ++i) {
    file.add("% {} {}", i + 1, factors.area[i]);
    for (const auto& sink : factors.sink) file.add(" {}", sink.factor[i]);
    file.add(" {}\n", line_of(factors.name[i]));
  }
  file.add("{} {} {}\n", factors.size(), factors.size(), factors.count());
  for (std::size_t i = 0; i < factors.size(); ++i)
    for (auto at = factors.row_begin[i]; at < factors.row_begin[i + 1]; ++at)
      file.add("{} {} {}\n", i + 1, factors.column[at] + 1, factors.factor[at]);
  file.commit();
}

}  // namespace luxel
