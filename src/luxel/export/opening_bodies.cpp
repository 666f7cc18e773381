// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/opening_bodies.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  using Colour = std::array<float, 3>;
  using Key = std::pair<const Photometry*, std::vector<Colour>>;  // [face]

  // Nothing where nothing is emitted.
  std::optional<std::size_t> mesh_of(const BandPointLight& lamp) {
    const auto& photometry = *lamp.light.photometry;
    const auto [faces, is_first] = faces_.try_emplace(&photometry);
    if (is_first) faces->second = opening_faces(photometry, 2.0 * forward);
    if (faces->second.empty()) return std::nullopt;
    const auto intensity = patches_.colours().rgb(lamp.intensity);
    Key key(&photometry, {});
    for (const auto& face : faces->second) {
      const auto colour = curve_(in_gamut(intensity * face.radiance));
      key.second.push_back({colour.r, colour.g, colour.b});
    }
    const auto [found, is_new] = meshes_.try_emplace(key, 0);
    if (is_new) found->second = add_mesh(photometry.file, faces->second, key.second);
    return found->second;
  }

  std::size_t add_mesh(const std::string& photometric_file, const std::vector<OpeningFace>& faces,
                       const std::vector<Colour>& colours) {
    const auto name = valid_utf8(fmt::format("opening of {}", photometric_file));
    auto primitives = Json::array();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto& mesh = faces[i].mesh;
      const auto material = file_.append(
          "/materials",
          {{"name", name},
           {"emissiveFactor", colours[i]},
           {"pbrMetallicRoughness",
            {{"baseColorFactor", {0.0, 0.0, 0.0, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}});
      Json attributes = {{"POSITION", file_.add_positions(mesh.positions)}};
      attributes["NORMAL"] = file_.add_vectors(std::span<const Vec3>(mesh.normals));
      primitives.push_back({{"attributes", std::move(attributes)},
                            {"indices", file_.add_indices(mesh.triangles, mesh.positions.size())},
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
  std::map<const Photometry*, std::vector<OpeningFace>> faces_;
  std::map<Key, std::size_t> meshes_;
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
