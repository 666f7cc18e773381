// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/csv_field.h"
#include "luxel/core/output_file.h"
#include "luxel/form_factors/view_factors_file.h"

namespace luxel {
namespace {

// Buffered text output: a hundred million lines need not fit into memory.
class TextFile {
 public:
  explicit TextFile(const std::filesystem::path& path) : output_(path) {}

  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    if (buffer_.size() > (1u << 20)) flush();
  }
  void commit() {
    flush();
    output_.commit();
  }

 private:
  void flush() {
    output_.write({buffer_.data(), buffer_.size()});
    buffer_.clear();
  }

  OutputFile output_;
  fmt::memory_buffer buffer_;
};

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
    const auto from = csv_field(factors.name[i]);
    for (auto at = factors.row_begin[i]; at < factors.row_begin[i + 1]; ++at)
      file.add("{},{},{},{}\n", from, csv_field(factors.name[factors.column[at]]), factors.factor[at],
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
