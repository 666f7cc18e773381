// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "luxel/core/descriptor.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"

namespace luxel {

std::string read_file(const std::filesystem::path& path, std::uint64_t most) {
  const auto refuse = [&](int error) {
    throw InputError(path.string(), fmt::format("cannot read it: {}", std::strerror(error)));
  };
  const Descriptor file(path, O_RDONLY);
  if (!file.is_open()) refuse(errno);
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0) refuse(errno);
  if (S_ISDIR(status.st_mode)) throw InputError(path.string(), "it is a folder, expected a file");

  // Pipes and /proc report size 0, so reading continues up to the end of the file.
  constexpr std::size_t block = 1 << 16;
  std::string bytes;
  std::size_t size = 0;
  const auto told = status.st_size > 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  bytes.resize(static_cast<std::size_t>(std::min(told, most)) + block);
  for (;;) {
    if (size == bytes.size()) bytes.resize(2 * size);
    const auto n = ::read(file.number(), bytes.data() + size, bytes.size() - size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse(errno);
    if (n == 0) break;
    size += static_cast<std::size_t>(n);
    if (size > most)
      throw InputError(path.string(), fmt::format("it holds more than the {} bytes that are read", most));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace luxel
