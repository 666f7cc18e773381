// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/scene_folder.h"
#include "luxel/import/texel_budget.h"
#include "luxel/scene/texture.h"

namespace luxel {

// The pictures that MTL files name, each file read once. Missing ones are recorded, for one warning per
// purpose at the end.
class TextureFiles {
 public:
  // The folder must outlive it.
  explicit TextureFiles(const SceneFolder& folder) : folder_(folder) {}

  enum class Purpose { reflectance, emission, holes };

  // The number of the picture that an MTL file in `folder` names for a material, or nothing where it is
  // missing, outside the scene's folder or cannot be read.
  std::optional<std::uint32_t> find(Purpose purpose, const std::filesystem::path& folder,
                                    const std::string& name, const std::string& material);

  const Raster& raster(std::uint32_t texture) const { return *textures_[texture].raster; }

  // Returns a picture whose alpha is the coverage of the surface: this one, or, where all of it is opaque,
  // one with its greys for alpha.
  std::uint32_t mask_of(std::uint32_t texture);

  const std::vector<Texture>& textures() const { return textures_; }
  // Appends those that were read.
  void list_files(std::vector<std::filesystem::path>& files) const;

  void say_warnings(const std::string& source, const Context& context) const;

 private:
  struct File {
    std::optional<std::uint32_t> texture;
    std::string reason;  // where there is none
  };
  struct Trouble {
    std::string texture, material, reason;
  };
  struct Troubles {
    std::set<std::string> missing, outside;      // as the MTL names them
    std::set<std::filesystem::path> unreadable;  // there, but of no use
    std::optional<Trouble> first_missing, first_outside, first_unreadable;
  };

  const File& read(const std::filesystem::path& path, const std::string& name);

  const SceneFolder& folder_;
  std::vector<Texture> textures_;
  TexelBudget budget_;
  std::map<std::filesystem::path, File> files_;
  std::map<std::uint32_t, std::uint32_t> masks_;
  std::array<Troubles, 3> troubles_;
};

}  // namespace luxel
