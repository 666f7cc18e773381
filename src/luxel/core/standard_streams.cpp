// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/standard_streams.h"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace luxel {

static_assert(standard_output == STDOUT_FILENO && error_output == STDERR_FILENO);

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

bool is_terminal_device(int stream) { return ::isatty(stream) == 1; }

std::size_t terminal_columns(int stream) {
  winsize size{};
  return ::ioctl(stream, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

int take_standard_output() {
  const int output = ::dup(STDOUT_FILENO), nothing = ::open("/dev/null", O_WRONLY);
  return output < 0 || nothing < 0 || ::dup2(nothing, STDOUT_FILENO) < 0 ? -1 : output;
}

bool write_all(int stream, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::write(stream, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace luxel
