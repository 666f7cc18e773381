// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/recent_files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

namespace luxel {

RecentFiles::RecentFiles(std::optional<std::filesystem::path> store) : store_(std::move(store)) {
  if (!store_) return;
  std::ifstream stream(*store_);
  for (std::string line; files_.size() < max_files && std::getline(stream, line);)
    if (!line.empty()) files_.emplace_back(line);
}

void RecentFiles::add(const std::filesystem::path& file) {
  std::error_code error;
  const auto whole = std::filesystem::absolute(file, error).lexically_normal();
  if (error) return;
  std::erase(files_, whole);
  files_.insert(files_.begin(), whole);
  if (files_.size() > max_files) files_.resize(max_files);
  write();
}

void RecentFiles::clear() {
  files_.clear();
  write();
}

void RecentFiles::write() const {
  if (!store_) return;
  std::error_code error;
  std::filesystem::create_directories(store_->parent_path(), error);
  auto part = *store_;
  part += ".part";
  {
    std::ofstream stream(part);
    for (const auto& file : files_)
      if (file.string().find('\n') == std::string::npos) stream << file.string() << '\n';
    if (!stream.flush()) return;
  }
  std::filesystem::rename(part, *store_, error);
}

std::optional<std::filesystem::path> recent_files_path() {
  const auto folder = [](const char* variable) -> std::filesystem::path {
    const char* text = std::getenv(variable);
    const std::filesystem::path path = text == nullptr ? "" : text;
    return path.is_absolute() ? path : "";
  };
  if (const auto state = folder("XDG_STATE_HOME"); !state.empty()) return state / "luxel/recent-files";
  if (const auto home = folder("HOME"); !home.empty()) return home / ".local/state/luxel/recent-files";
  return std::nullopt;
}

}  // namespace luxel
