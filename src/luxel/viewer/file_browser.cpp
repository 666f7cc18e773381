// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/file_browser.h"

#include <algorithm>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"

namespace luxel {

FileBrowser::FileBrowser(const std::filesystem::path& folder, std::vector<std::string> endings)
    : endings_(std::move(endings)) {
  std::error_code error;
  folder_ = std::filesystem::current_path(error);
  enter(folder.empty() ? "." : folder);
}

void FileBrowser::enter(const std::filesystem::path& folder) {
  error_.clear();
  auto whole = (folder_ / folder).lexically_normal();
  if (!whole.has_filename() && whole.has_relative_path()) whole = whole.parent_path();  // no slash at the end
  std::error_code error;
  std::vector<Entry> found;
  auto next = std::filesystem::directory_iterator(whole, error);
  for (; !error && next != std::filesystem::directory_iterator(); next.increment(error)) {
    const auto name = next->path().filename().string();
    std::error_code unknown;
    const bool is_folder = next->is_directory(unknown);
    const bool fits = is_folder || endings_.empty() ||
                      std::find(endings_.begin(), endings_.end(), ending_of(name)) != endings_.end();
    if (fits && !name.starts_with('.')) found.push_back({name, is_folder});
  }
  if (error) {
    error_ = fmt::format("{} cannot be read: {}", whole.string(), error.message());
    return;
  }
  std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) {
    return std::tuple(!a.is_folder, a.name) < std::tuple(!b.is_folder, b.name);
  });
  folder_ = whole;
  entries_ = std::move(found);
}

std::filesystem::path FileBrowser::path_of(const std::string& name) const {
  return (folder_ / name).lexically_normal();
}

}  // namespace luxel
