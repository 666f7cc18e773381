// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace luxel {

// For readers that take a path: a file in a folder of this process, removed when it ends.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name)
      : root_(std::filesystem::temp_directory_path() / ("luxel-fuzz-" + std::to_string(getpid()))),
        path_(root_ / "nowhere" / name) {
    std::filesystem::create_directories(path_.parent_path());
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }

  // The path of the file, which has these bytes now.
  const std::filesystem::path& filled_with(std::string_view bytes) const {
    std::ofstream out(path_, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) std::abort();
    return path_;
  }

 private:
  std::filesystem::path root_, path_;
};

}  // namespace luxel
