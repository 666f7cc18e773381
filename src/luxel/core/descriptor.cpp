// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/descriptor.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace luxel {

Descriptor::Descriptor(const std::filesystem::path& path, int flags) {
  do number_ = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  while (number_ < 0 && errno == EINTR);
}

Descriptor::~Descriptor() {
  // Keeps errno for a caller that throws an error with it afterwards.
  const int error = errno;
  if (is_open()) ::close(number_);
  errno = error;
}

// Linux has closed the file even where a signal interrupted the call.
bool Descriptor::close() { return ::close(std::exchange(number_, -1)) == 0 || errno == EINTR; }

}  // namespace luxel
