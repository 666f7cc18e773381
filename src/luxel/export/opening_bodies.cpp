// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/opening_bodies.h"

#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/utf8.h"
#include "luxel/export/opening_faces.h"
#include "luxel/patch/luminaire_groups.h"
#include "luxel/photometry/luminaire_mesh.h"
#include "luxel/scene/band_colours.h"

namespace luxel {
namespace {

constexpr double forward = 6e-3;  // m along the aim: before a ceiling that an opening is recessed in by 5 mm

class OpeningBodies {
 public:
  OpeningBodies(GltfWriter& file, const PatchSet& patches, const ToneCurve& curve, const NodeParent& parent)
      : file_(file), patches_(patches), curve_(curve), parent_(parent) {}

  void add(const BandPointLight& lamp) {
    const auto& light = lamp.light;
    const auto place = Vec3d(light.position) + forward * Vec3d(light.direction);
    const auto at = (place + parent_.origin) / parent_.metres_per_unit;
    const auto scale = 1.0 / parent_.metres_per_unit;
    const auto x = scale * Vec3d(light.local_x), y = scale * Vec3d(light.local_y);
    const auto z = -scale * Vec3d(light.direction);
    Json node = {
        {"name", valid_utf8(light.name)},
        {"matrix", {x.x, x.y, x.z, 0.0, y.x, y.y, y.z, 0.0, z.x, z.y, z.z, 0.0, at.x, at.y, at.z, 1.0}},
        {"extras", {{"luxel_lumens", luminaire_lumens(lamp, patches_)}}}};
    if (const auto mesh = mesh_of(lamp)) node["mesh"] = *mesh;
    if (!patches_.light_groups.empty())
      node["extras"]["luxel_light_group"] = valid_utf8(patches_.light_groups[lamp.light_group]);
    const auto number = file_.append("/nodes", node);
    if (!parent_.children.empty()) file_.append(parent_.children, number);
  }

 private:
  using Key = std::tuple<const Photometry*, double, double, double>;

  // Nothing where nothing is emitted.
  std::optional<std::size_t> mesh_of(const BandPointLight& lamp) {
    const auto intensity = patches_.colours().rgb(lamp.intensity);
    const Key key(lamp.light.photometry.get(), intensity.r, intensity.g, intensity.b);
    const auto [found, is_new] = meshes_.try_emplace(key);
    if (is_new) found->second = add_mesh(*lamp.light.photometry, intensity);
    return found->second;
  }

  std::optional<std::size_t> add_mesh(const Photometry& photometry, const Vec3d& intensity) {
    const auto name = valid_utf8(fmt::format("opening of {}", photometry.file));
    auto primitives = Json::array();
    for (const auto& face : opening_faces(photometry, 2.0 * forward)) {
      const auto colour = curve_(in_gamut(intensity * face.radiance));
      const auto material = file_.append(
          "/materials",
          {{"name", name},
           {"emissiveFactor", {colour.r, colour.g, colour.b}},
           {"pbrMetallicRoughness",
            {{"baseColorFactor", {0.0, 0.0, 0.0, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}});
      Json attributes = {{"POSITION", file_.add_positions(face.mesh.positions)}};
      attributes["NORMAL"] = file_.add_vectors(std::span<const Vec3>(face.mesh.normals));
      primitives.push_back({{"attributes", std::move(attributes)},
                            {"indices", file_.add_indices(face.mesh.triangles, face.mesh.positions.size())},
                            {"material", material}});
    }
    return file_.append(
        "/meshes",
        {{"name", name}, {"primitives", std::move(primitives)}, {"extras", {{"luxel_opening", true}}}});
  }

  GltfWriter& file_;
  const PatchSet& patches_;
  const ToneCurve& curve_;
  const NodeParent& parent_;
  std::map<Key, std::optional<std::size_t>> meshes_;
};

void take_off_earlier(GltfWriter& file) {
  for (std::size_t n = 0; n < file.size("/nodes"); ++n) {
    const auto place = fmt::format("/nodes/{}/mesh", n);
    if (file.has(place) && file.has(fmt::format("/meshes/{}/extras/luxel_opening", file.index_at(place))))
      file.erase(place);
  }
}

}  // namespace

void add_opening_bodies(GltfWriter& file, const PatchSet& patches, const ToneCurve& curve,
                        const NodeParent& parent) {
  if (!has_luminaires(patches)) return;
  take_off_earlier(file);
  OpeningBodies bodies(file, patches, curve, parent);
  for (const auto& lamp : patches.point_lights)
    if (lamp.light.kind == PointLightKind::luminaire) bodies.add(lamp);
}

}  // namespace luxel
