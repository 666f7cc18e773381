// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/streams.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "luxel/core/error.h"
#include "luxel/core/utf8.h"

namespace luxel {

void secure_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // open() returns the lowest free number: this one. Opened in the wrong direction, so that using it fails
    // like using a closed stream.
    [[maybe_unused]] const int held = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void print_result(std::string_view text) {
  if (::isatty(STDOUT_FILENO) == 1) return print_styled(printable(text));
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
