// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/surface_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "luxel/core/none.h"
#include "luxel/image/raster.h"

namespace luxel {
namespace {

constexpr std::uint32_t max_side = 16384;
const std::string group = "Luxel/surface";

// One column of the table of materials: the use of a texture by each.
struct UseColumn {
  const char* name;
  std::optional<TextureUse> MaterialTextures::*use;
};
constexpr auto columns = std::to_array<UseColumn>({{"reflectance", &MaterialTextures::reflectance},
                                                   {"emittance", &MaterialTextures::emittance},
                                                   {"cutout", &MaterialTextures::cutout}});

void add_uses(Hdf5Writer& file, const PatchSet& patches, const UseColumn& column) {
  std::vector<std::uint32_t> which;  // texture, set, wrap of x, wrap of y
  std::vector<float> placement;
  for (const auto& material : patches.materials) {
    const auto& use = material.textures.*column.use;
    const auto u = use.value_or(TextureUse{});
    which.insert(which.end(), {use ? u.texture : none, u.uv_set, static_cast<std::uint32_t>(u.wrap[0]),
                               static_cast<std::uint32_t>(u.wrap[1])});
    placement.insert(placement.end(), u.placement.begin(), u.placement.end());
  }
  file.add_array(fmt::format("{}/{}_texture", group, column.name), rows_of(which, 4));
  file.add_array(fmt::format("{}/{}_placement", group, column.name), rows_of(placement, 6), "1");
}

void read_uses(const Hdf5Reader& file, PatchSet& patches, const UseColumn& column) {
  const auto n = patches.materials.size();
  const auto which = file.array<std::uint32_t>(fmt::format("{}/{}_texture", group, column.name), n, 4);
  const auto placement = file.array<float>(fmt::format("{}/{}_placement", group, column.name), n, 6);
  constexpr auto last_wrap = static_cast<std::uint32_t>(Wrap::clamp);
  for (std::size_t m = 0; m < n; ++m) {
    const auto* w = &which[4 * m];
    if (w[0] == none) continue;
    if (w[2] > last_wrap || w[3] > last_wrap) file.refuse_as_damaged("a texture is wrapped in no known way");
    TextureUse use{w[0], w[1], {}, {static_cast<Wrap>(w[2]), static_cast<Wrap>(w[3])}};
    std::copy_n(&placement[6 * m], 6, use.placement.begin());
    patches.materials[m].textures.*column.use = use;
  }
}

void add_texture(Hdf5Writer& file, const std::string& name, const Raster& raster) {
  file.add_group(name);
  file.add_array(name + "/size", flat(std::vector<std::uint32_t>{static_cast<std::uint32_t>(raster.width),
                                                                 static_cast<std::uint32_t>(raster.height)}));
  if (raster.codes.empty()) return file.add_array(name + "/linear", vectors(raster.linear), "1");
  std::vector<std::uint8_t> codes;
  codes.reserve(4 * raster.codes.size());
  for (const auto& code : raster.codes) codes.insert(codes.end(), code.begin(), code.end());
  file.add_array(name + "/codes", rows_of(codes, 4));
}

std::shared_ptr<const Raster> read_texture(const Hdf5Reader& file, const std::string& name) {
  const auto size = file.array<std::uint32_t>(name + "/size", 2);
  for (const auto side : size)
    if (side < 1 || side > max_side) file.refuse_as_damaged(fmt::format("'{}' has no such size", name));
  auto raster =
      std::make_shared<Raster>(Raster{static_cast<int>(size[0]), static_cast<int>(size[1]), {}, {}});
  const auto pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  if (file.has(name + "/linear")) {
    raster->linear = file.vectors(name + "/linear", pixels);
    return raster;
  }
  const auto codes = file.array<std::uint8_t>(name + "/codes", pixels, 4);
  raster->codes.resize(pixels);
  for (std::size_t i = 0; i < codes.size(); ++i) raster->codes[i / 4][i % 4] = codes[i];
  return raster;
}

template <typename Vec>
std::vector<float> numbers_of(const std::vector<std::array<Vec, 3>>& corners) {
  std::vector<float> numbers;
  for (const auto& three : corners)
    for (const auto& corner : three)
      for (int i = 0; i < Vec::length(); ++i) numbers.push_back(corner[i]);
  return numbers;
}

template <typename Vec>
std::vector<std::array<Vec, 3>> corners_of(const Hdf5Reader& file, const std::string& name, std::size_t n) {
  constexpr std::size_t width = Vec::length();
  const auto numbers = file.array<float>(name, 3 * n, width);
  std::vector<std::array<Vec, 3>> corners(n);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    corners[i / (3 * width)][i / width % 3][static_cast<int>(i % width)] = numbers[i];
  return corners;
}

bool has_surface(const PatchSet& patches) {
  return !patches.uv_sets.empty() || !patches.corner_colours.empty() || !patches.reflectance_ratio.empty() ||
         !patches.emittance_ratio.empty();
}

void read_factors(const Hdf5Reader& file, PatchSet& patches) {
  const auto n = patches.materials.size();
  const auto reflectance = file.vectors(group + "/reflectance_factor", n);
  const auto emittance = file.vectors(group + "/emittance_factor", n);
  const auto limits = file.array<float>(group + "/limits", n, 2);
  for (std::size_t m = 0; m < n; ++m) {
    auto& textures = patches.materials[m].textures;
    textures.reflectance_factor = reflectance[m];
    textures.emittance_factor = emittance[m];
    textures.max_reflectance = limits[2 * m];
    textures.cutout_threshold = limits[2 * m + 1];
  }
}

bool all_in(const std::vector<float>& values, float least) {
  return std::all_of(values.begin(), values.end(), [&](float x) { return x >= least && std::isfinite(x); });
}

}  // namespace

void add_surface(Hdf5Writer& file, const PatchSet& patches) {
  if (!has_surface(patches)) return;
  file.add_group(group);
  for (const auto& column : columns) add_uses(file, patches, column);
  std::vector<Vec3> reflectance, emittance;
  std::vector<float> limits;
  for (const auto& material : patches.materials) {
    reflectance.push_back(material.textures.reflectance_factor);
    emittance.push_back(material.textures.emittance_factor);
    limits.insert(limits.end(), {material.textures.max_reflectance, material.textures.cutout_threshold});
  }
  file.add_array(group + "/reflectance_factor", vectors(reflectance), "1");
  file.add_array(group + "/emittance_factor", vectors(emittance), "W/m^2");
  file.add_array(group + "/limits", rows_of(limits, 2), "1");
  std::vector<std::string> names;
  for (const auto& texture : patches.textures) names.push_back(texture.name);
  if (!names.empty()) file.add_strings(group + "/texture_name", names);
  for (std::size_t t = 0; t < patches.textures.size(); ++t)
    add_texture(file, fmt::format("{}/texture_{}", group, t), *patches.textures[t].raster);
  for (std::size_t s = 0; s < patches.uv_sets.size(); ++s)
    file.add_array(fmt::format("{}/uv_{}", group, s), rows_of(numbers_of(patches.uv_sets[s]), 2), "1");
  if (!patches.corner_colours.empty())
    file.add_array(group + "/corner_colours", rows_of(numbers_of(patches.corner_colours), 3), "1");
  for (const auto& [name, ratios] : {std::pair("reflectance_ratio", &patches.reflectance_ratio),
                                     std::pair("emittance_ratio", &patches.emittance_ratio)})
    if (!ratios->empty())
      file.add_array(fmt::format("{}/{}", group, name), rows_of(*ratios, patches.band_count()), "1");
}

void read_surface(const Hdf5Reader& file, PatchSet& patches) {
  if (!file.has(group)) return;
  for (const auto& column : columns) read_uses(file, patches, column);
  read_factors(file, patches);
  const auto n = patches.size();
  if (file.has(group + "/texture_name")) {
    const auto count = file.rows(group + "/texture_name");
    for (const auto& name : file.strings(group + "/texture_name", count))
      patches.textures.push_back(
          {name, read_texture(file, fmt::format("{}/texture_{}", group, patches.textures.size()))});
  }
  for (std::size_t s = 0; file.has(fmt::format("{}/uv_{}", group, s)); ++s)
    patches.uv_sets.push_back(corners_of<Vec2>(file, fmt::format("{}/uv_{}", group, s), n));
  if (file.has(group + "/corner_colours"))
    patches.corner_colours = corners_of<Vec3>(file, group + "/corner_colours", n);
  for (const auto& [name, ratios] : {std::pair("reflectance_ratio", &patches.reflectance_ratio),
                                     std::pair("emittance_ratio", &patches.emittance_ratio)})
    if (const auto path = fmt::format("{}/{}", group, name); file.has(path))
      *ratios = file.array<float>(path, n, patches.band_count());
}

std::string fault_in_surface(const PatchSet& patches) {
  const auto n = patches.size();
  const auto values = n * patches.band_count();
  for (const auto* ratios : {&patches.reflectance_ratio, &patches.emittance_ratio})
    if (!ratios->empty() && (ratios->size() != values || !all_in(*ratios, 0.0f)))
      return "what patches reflect and emit over their materials is not one number, 0 or more, for each band";
  for (const auto& set : patches.uv_sets)
    if (set.size() != n) return "texture coordinates are not there for all patches";
  if (!patches.corner_colours.empty() && patches.corner_colours.size() != n)
    return "colours of corners are not there for all patches";
  for (const auto& material : patches.materials)
    for (const auto& column : columns)
      if (const auto& use = material.textures.*column.use;
          use && (use->texture >= patches.textures.size() || use->uv_set >= patches.uv_sets.size()))
        return fmt::format("material '{}' names texture {} of {}, set {} of {}", material.name, use->texture,
                           patches.textures.size(), use->uv_set, patches.uv_sets.size());
  for (const auto& light : patches.point_lights)
    if (light.intensity.size() != patches.band_count() || !all_in(light.intensity, 0.0f) ||
        light.light_group >= patches.group_count())
      return fmt::format("lamp '{}' does not have one intensity, 0 or more, for each band", light.light.name);
  return {};
}

}  // namespace luxel
