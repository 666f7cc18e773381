// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/export/target_application.h"
#include "luxel/image/image.h"
#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/atlas.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

struct VertexFit;

struct RoundTripOptions {
  ToneOptions tone;
  TargetApplication program = TargetApplication::any;
  MeshCompression compression = MeshCompression::plain;  ///< the command's default is quantised
  double metres_per_unit = 1.0;                          ///< as the scene was loaded
  Vec3 up = Vec3(0.0f, 1.0f, 0.0f);                      ///< of a scene that was not glTF
};

/// The scene, its patches and their light.
struct RoundTripInput {
  const Scene& scene;
  const PatchSet& patches;
  const Solution& solution;
};

/// Returns a scene whose triangles are the patches, for use where their scene is not available.
/// PatchSet::triangle of each patch must be its own index.
Scene scene_of(const PatchSet& patches);

/// \file
/// A scene with light on it, as one GLB. Where the scene was read from a glTF file (Scene::source, is_gltf())
/// that file is preserved: its nodes, names, hierarchy, textures, extensions and all other contents remain.
/// Another scene is converted to glTF, see gltf_of(). A mesh of several nodes becomes one mesh per node,
/// since each has its own light. A back that received light gets its own triangles. Textures and base colours
/// still colour the surfaces: the written light is what a surface of the factor's colour reflects and, where
/// there is no texture, emits. Surfaces that are not opaque stay as they are. Valid if the file is. Written
/// whole or not at all.
///
/// All throw MismatchError where scene, file, patches and solution do not belong together, InputError where
/// the file is damaged, the GLB would be beyond 4 GiB or the compression is not available, DeviceError.
///
/// With a compression, a node whose mesh has quantised positions gets a child of its name, which holds the
/// mesh; meshes with skins or morph targets keep floats, as does a file with extensions that Luxel does not
/// know.

/// Writes COLOR_0, tone-mapped, and _IRRADIANCE as in export_glb(), materials unlit. Surfaces are cut into
/// the patches of the light; a new vertex has the mean of the attributes of the vertices around it.
void export_round_trip_cut(const std::filesystem::path& path, const RoundTripInput& input,
                           const SmoothLight& light, const RoundTripOptions& options);
/// Writes the light of `fit` to the file's own triangles, without cuts.
void export_round_trip_uncut(const std::filesystem::path& path, const RoundTripInput& input,
                             const VertexFit& fit, const RoundTripOptions& options);

/// Pages of a lightmap; each becomes a texture.
struct RoundTripPages {
  const Atlas& atlas;
  const std::vector<Image>& pages;  ///< [page]; irradiance, W/m², or radiance, W/(m² sr)
  float white = 1.0f;               ///< the value of a texel of 1
  bool as_file_has_it = false;      ///< the file's own coordinates (round_trip_layout()), not new ones
};

/// Both functions write nothing and return false if the monitor stops them before all is ready.
///
/// Adds texture coordinates that map each surface to its page; triangles change only where charts are cut.
/// Pages become 8-bit sRGB textures. Pages of irradiance: glTF has no member for it, so materials name their
/// page by MOZ_lightmap.
bool export_round_trip_lightmap(const std::filesystem::path& path, const RoundTripInput& input,
                                const RoundTripPages& pages, const RoundTripOptions& options,
                                const Context& context = {});
/// Pages of radiance: written as the emission of black surfaces, which programs show without a lamp.
bool export_round_trip_emissive(const std::filesystem::path& path, const RoundTripInput& input,
                                const RoundTripPages& pages, const RoundTripOptions& options,
                                const Context& context = {});

/// Writes the scene with the coordinates of the pages and without light: `path` ends in .glb or .obj. In a
/// GLB they are a further set, TEXCOORD_1 and, where the file has none, TEXCOORD_0 too; extras.luxel_lightmap
/// of a primitive names its page and its set. An OBJ has one set, so its vt are those of the lightmap, from
/// the bottom left; page n + 1 lies n to the right, as UDIM tiles do up to ten. It is in the scene's
/// coordinates and units. Throws InputError where an OBJ is to have the file's own coordinates.
bool export_unwrapped(const std::filesystem::path& path, const RoundTripInput& input,
                      const RoundTripPages& pages, const RoundTripOptions& options,
                      const Context& context = {});

}  // namespace luxel
