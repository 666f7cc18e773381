// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/real_path.h"

#include <fcntl.h>
#include <fmt/format.h>

#include "luxel/core/descriptor.h"

namespace luxel {
namespace fs = std::filesystem;

std::optional<fs::path> real_path(const fs::path& path) {
  std::error_code error;
  const Descriptor file(path, O_PATH);
  if (!file.is_open()) return std::nullopt;
  auto place = fs::read_symlink(fmt::format("/proc/self/fd/{}", file.number()), error);
  if (error) place = fs::canonical(path, error);
  return error ? std::nullopt : std::optional(place);
}

bool is_plain_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace luxel
