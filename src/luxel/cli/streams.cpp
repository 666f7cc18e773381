// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/streams.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/standard_streams.h"
#include "luxel/core/utf8.h"

namespace luxel {

void print_result(std::string_view text) {
  if (is_terminal_device(standard_output)) return print_styled(printable(text));
  print_styled(text);
}

void print_styled(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if ((written && std::fflush(stdout) == 0) || errno == EPIPE) return;
  throw DeviceError(fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
}

void print_note(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stderr) == text.size()) std::fflush(stderr);
}

}  // namespace luxel
