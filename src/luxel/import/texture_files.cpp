// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/texture_files.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/import/make_materials.h"
#include "luxel/import/material_library.h"
#include "luxel/import/name_list.h"
#include "luxel/import/raster_colours.h"

namespace luxel {
namespace {

std::string consequence(std::size_t purpose) {
  if (purpose == 0) return fmt::format("{} is taken for the mean", default_reflectance);
  return purpose == 1 ? "0 is taken for the mean, so that nothing is emitted" : "no hole is cut by it";
}

}  // namespace

std::optional<std::uint32_t> TextureFiles::find(Purpose purpose, const std::filesystem::path& folder,
                                                const std::string& name, const std::string& material) {
  auto& troubles = troubles_[static_cast<std::size_t>(purpose)];
  const auto found = folder_.find(folder, name);
  if (!found.file) {
    (found.is_outside ? troubles.outside : troubles.missing).insert(name);
    auto& first = found.is_outside ? troubles.first_outside : troubles.first_missing;
    if (!first) first = Trouble{name, material, {}};
    return std::nullopt;
  }
  const auto& file = read(*found.file, name);
  if (!file.texture) {
    troubles.unreadable.insert(*found.file);
    if (!troubles.first_unreadable) troubles.first_unreadable = Trouble{name, material, file.reason};
  }
  return file.texture;
}

const TextureFiles::File& TextureFiles::read(const std::filesystem::path& path, const std::string& name) {
  const auto [place, is_new] = files_.try_emplace(path);
  auto& file = place->second;
  if (!is_new) return file;
  try {
    auto raster = read_raster(path);
    budget_.take(raster, std::filesystem::file_size(path));
    for (auto& colour : raster.linear)
      colour = glm::max(colour, Vec3(0.0f));  // negative light does not exist
    if (!is_finite(mean_colour(raster))) throw InputError(path.string(), "its mean colour is not finite");
    file.texture = static_cast<std::uint32_t>(textures_.size());
    textures_.push_back({name, std::make_shared<const Raster>(std::move(raster))});
  } catch (const InputError& error) {
    file.reason = error.what();
  }
  return file;
}

std::uint32_t TextureFiles::mask_of(std::uint32_t texture) {
  if (min_alpha(raster(texture)) < 1.0f) return texture;
  const auto [place, is_new] = masks_.try_emplace(texture, static_cast<std::uint32_t>(textures_.size()));
  if (is_new) {
    auto name = textures_[texture].name;
    textures_.push_back(
        {std::move(name), std::make_shared<const Raster>(with_grey_as_alpha(raster(texture)))});
  }
  return place->second;
}

void TextureFiles::list_files(std::vector<std::filesystem::path>& files) const {
  for (const auto& [path, file] : files_) add_file(files, path);
}

void TextureFiles::say_warnings(const std::string& source, const Context& context) const {
  for (std::size_t purpose = 0; purpose < troubles_.size(); ++purpose) {
    const auto& [missing, outside, unreadable, first_missing, first_outside, first_unreadable] =
        troubles_[purpose];
    if (first_outside)
      context.warn(fmt::format("{}: {} outside the scene's folder not read (first: {}, needed by material "
                               "'{}'); {}",
                               source, counted(outside.size(), "texture"), first_outside->texture,
                               first_outside->material, consequence(purpose)),
                   {{Setting::allow_outside}});
    if (first_missing)
      context.warn(fmt::format("{}: {} not found (first: {}, needed by material '{}'); {}", source,
                               counted(missing.size(), "texture"), first_missing->texture,
                               first_missing->material, consequence(purpose)));
    if (first_unreadable)
      context.warn(fmt::format("{}: {} cannot be read (first: needed by material '{}', {}); {}", source,
                               counted(unreadable.size(), "texture"), first_unreadable->material,
                               first_unreadable->reason, consequence(purpose)));
  }
}

}  // namespace luxel
