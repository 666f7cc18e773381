// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace luxel {

// The files that were opened last, the newest first; in a file of their own, one path per line, so that the
// next window has them too. Without access to that file they last as long as the window.
class RecentFiles {
 public:
  static constexpr std::size_t max_files = 10;

  // An empty path: not stored.
  explicit RecentFiles(std::optional<std::filesystem::path> store);

  const std::vector<std::filesystem::path>& files() const { return files_; }
  void add(const std::filesystem::path& file);
  void clear();

 private:
  void write() const;

  std::optional<std::filesystem::path> store_;
  std::vector<std::filesystem::path> files_;
};

// Returns the file that stores them: luxel/recent-files in XDG_STATE_HOME, or else in .local/state of the
// home folder. Nothing where neither is known.
std::optional<std::filesystem::path> recent_files_path();

}  // namespace luxel
