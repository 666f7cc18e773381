// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/scene_folder.h"

#include <algorithm>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/real_path.h"

namespace luxel {
namespace fs = std::filesystem;

SceneFolder::SceneFolder(const fs::path& scene_file, bool allow_outside) : allow_outside_(allow_outside) {
  const auto folder = scene_file.parent_path();
  folder_ = real_path(folder.empty() ? fs::path(".") : folder).value_or(fs::path());
}

bool SceneFolder::permits(const fs::path& file) const {
  if (allow_outside_) return true;
  const auto place = real_path(file);
  if (!place || folder_.empty()) return false;
  const auto [in_folder, in_place] =
      std::mismatch(folder_.begin(), folder_.end(), place->begin(), place->end());
  return in_folder == folder_.end();
}

SceneFolder::Found SceneFolder::find(const fs::path& folder, const std::string& name) const {
  Found found;
  if (name.empty() || name.find('\0') != std::string::npos) return found;
  auto slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  for (const auto& candidate : {folder / name, folder / slashed, folder / fs::path(slashed).filename()}) {
    if (!is_plain_file(candidate)) continue;
    if (permits(candidate)) return {candidate};
    found.is_outside = true;
  }
  return found;
}

void refuse_outside(const std::string& place, const std::string& what) {
  throw with_hints(
      InputError(place, what + " lies outside the scene's folder; copy it there, or allow files outside"),
      {{Setting::allow_outside}});
}

void add_file(std::vector<fs::path>& files, const fs::path& file) {
  if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

}  // namespace luxel
