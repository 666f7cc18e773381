// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/opening_bodies.h"

#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/utf8.h"
#include "luxel/patch/luminaire_groups.h"
#include "luxel/photometry/luminaire_mesh.h"
#include "luxel/scene/band_colours.h"

namespace luxel {
namespace {

constexpr double forward = 6e-3;  // m along the aim: before a ceiling that an opening is recessed in by 5 mm

double area_of(const LuminaireMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

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
        {"mesh", mesh_of(lamp)},
        {"matrix", {x.x, x.y, x.z, 0.0, y.x, y.y, y.z, 0.0, z.x, z.y, z.z, 0.0, at.x, at.y, at.z, 1.0}},
        {"extras", {{"luxel_lumens", luminaire_lumens(lamp, patches_)}}}};
    if (!patches_.light_groups.empty())
      node["extras"]["luxel_light_group"] = valid_utf8(patches_.light_groups[lamp.light_group]);
    const auto number = file_.append("/nodes", node);
    if (!parent_.children.empty()) file_.append(parent_.children, number);
  }

 private:
  using Key = std::tuple<const Photometry*, float, float, float>;

  std::size_t mesh_of(const BandPointLight& lamp) {
    const auto& photometry = *lamp.light.photometry;
    const auto mesh = opening_mesh(shown_opening(photometry.opening));
    const auto& intensity = photometry.intensity;
    const auto angle = intensity.maximum() > 0.0 ? intensity.linear_flux() / intensity.maximum() : 0.0;  // sr
    const auto radiance =
        patches_.colours().rgb(lamp.intensity) * (angle / (std::numbers::pi * area_of(mesh)));
    const auto colour = curve_(in_gamut(radiance));
    const auto [found, is_new] = meshes_.try_emplace(Key(&photometry, colour.r, colour.g, colour.b), 0);
    if (!is_new) return found->second;
    const auto name = fmt::format("opening of {}", photometry.file);
    const auto material = file_.append(
        "/materials",
        {{"name", valid_utf8(name)},
         {"doubleSided", true},
         {"emissiveFactor", {colour.r, colour.g, colour.b}},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.0, 0.0, 0.0, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 1.0}}}});
    Json attributes = {{"POSITION", file_.add_positions(mesh.positions)}};
    attributes["NORMAL"] = file_.add_vectors(std::span<const Vec3>(mesh.normals));
    Json primitive = {{"attributes", std::move(attributes)},
                      {"indices", file_.add_indices(mesh.triangles, mesh.positions.size())},
                      {"material", material}};
    return found->second = file_.append("/meshes", {{"name", valid_utf8(name)},
                                                    {"primitives", Json::array({std::move(primitive)})},
                                                    {"extras", {{"luxel_opening", true}}}});
  }

  GltfWriter& file_;
  const PatchSet& patches_;
  const ToneCurve& curve_;
  const NodeParent& parent_;
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
