// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/texture_means.h"

#include <fmt/format.h>

#include "luxel/image/image_file.h"
#include "luxel/load/material_library.h"
#include "luxel/load/name_list.h"
#include "luxel/report/error.h"

namespace luxel {
namespace {

Vec3 mean_of_file(const std::filesystem::path& path) {
  const auto mean = mean_color(read_image(path));
  if (!is_finite(mean)) throw InputError(path.string(), "its mean colour is not finite");
  return glm::max(mean, Vec3(0.0f));
}

}  // namespace

std::optional<Vec3> TextureMeans::mean(const std::filesystem::path& folder, const std::string& texture,
                                       const std::string& material) {
  const auto path = find_file(folder, texture);
  if (!path) {
    missing_.insert(texture);
    if (!first_missing_) first_missing_ = Trouble{texture, material, {}};
    return std::nullopt;
  }
  const auto [place, is_new] = means_.try_emplace(*path);
  if (!is_new) return place->second;
  try {
    place->second = mean_of_file(*path);
  } catch (const InputError& error) {
    ++unreadable_;
    if (!first_unreadable_) first_unreadable_ = Trouble{texture, material, error.what()};
  }
  return place->second;
}

void TextureMeans::say_warnings(const std::string& source, const std::string& consequence,
                                const LogSink& log) const {
  if (first_missing_)
    warn(log, fmt::format("{}: {} not found (first: {}, needed by material '{}'); {}", source,
                          counted(missing_.size(), "texture"), first_missing_->texture,
                          first_missing_->material, consequence));
  if (first_unreadable_)
    warn(log, fmt::format("{}: {} cannot be read (first: needed by material '{}', {}); {}", source,
                          counted(unreadable_, "texture"), first_unreadable_->material,
                          first_unreadable_->reason, consequence));
}

}  // namespace luxel
