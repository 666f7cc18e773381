// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_scene.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/core/memory.h"
#include "luxel/import/finish_scene.h"
#include "luxel/import/is_gltf.h"
#include "luxel/import/load_converted.h"
#include "luxel/import/load_gltf.h"
#include "luxel/import/load_obj.h"
#include "luxel/import/load_ply.h"
#include "luxel/import/load_stl.h"

namespace luxel {
namespace {

bool is_obj(const std::filesystem::path& path) { return ending_of(path) == ".obj"; }
bool is_ply(const std::filesystem::path& path) { return ending_of(path) == ".ply"; }
bool is_stl(const std::filesystem::path& path) { return ending_of(path) == ".stl"; }

constexpr const char* endings = ".obj, .glb, .gltf, .ply, .stl, .fbx, .dae or .3ds";

struct Reader {
  bool (*reads)(const std::filesystem::path&);
  Scene (*load)(const std::filesystem::path&, const LoadOptions&, const Context&);
};
constexpr auto readers = std::to_array<Reader>({{is_obj, load_obj},
                                                {is_gltf, load_gltf},
                                                {is_ply, load_ply},
                                                {is_stl, load_stl},
                                                {is_converted, load_converted}});

void check_options(const LoadOptions& options) {
  if (!(options.scale > 0.0 && std::isfinite(options.scale)))
    throw InputError(fmt::format("expected a scale above 0 metres a unit, found {}", options.scale));
  if (!(options.max_reflectance >= 0.0f && options.max_reflectance < 1.0f))
    throw InputError(fmt::format("expected max_reflectance in [0, 1), found {}", options.max_reflectance));
  if (!(options.weld >= 0.0f && std::isfinite(options.weld)))
    throw InputError(fmt::format("expected a weld distance of 0 or more metres, found {}", options.weld));
  if (options.bands != 0 && (options.bands < min_bands || options.bands > max_bands))
    throw InputError(fmt::format("expected {} to {} bands, or 0 for those of the file, found {}", min_bands,
                                 max_bands, options.bands));
  for (const auto& glass : options.glass)
    if (const auto& t = glass.transmittance; t != glm::clamp(t, 0.0f, 1.0f) || t == Vec3(0.0f))
      throw InputError(
          fmt::format("expected a transmittance in [0, 1] and above 0 in a band, found {}, "
                      "{}, {}",
                      t.r, t.g, t.b));
  for (int band = 0; band < 3; ++band)
    if (!(options.sky[band] >= 0.0f && std::isfinite(options.sky[band])))
      throw InputError(
          fmt::format("expected a sky of 0 or more W/(m² sr) in each band, found {}", options.sky[band]));
}

void check_is_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string(), "no such file");
  if (std::filesystem::is_directory(status))
    throw InputError(path.string(),
                     fmt::format("it is a folder; name the scene's file inside it ({})", endings));
}

void check_memory(const std::filesystem::path& path) {
  constexpr double bytes_per_byte = 8.0;  // of the file; measured: 3.5 to 8
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) return;
  if (const auto lack = lack_of_memory(bytes_per_byte * static_cast<double>(size)); !lack.empty())
    throw InputError(path.string(), fmt::format("reading it needs about {}", lack));
}

const Reader& reader_of(const std::filesystem::path& path) {
  for (const auto& reader : readers)
    if (reader.reads(path)) return reader;
  const auto ending = ending_of(path);
  throw InputError(path.string(),
                   fmt::format("expected a file that ends in {}, found {}; convert the scene to one of these",
                               endings, ending.empty() ? "no ending" : "'" + ending + "'"));
}

}  // namespace

Scene load_scene(const std::filesystem::path& path, const LoadOptions& options, const Context& context) {
  check_options(options);
  check_is_file(path);
  check_memory(path);
  auto scene = reader_of(path).load(path, options, context);
  if (scene.triangles.empty()) return scene;  // stopped
  finish_scene(path, options, scene, context);
  return scene;
}

}  // namespace luxel
