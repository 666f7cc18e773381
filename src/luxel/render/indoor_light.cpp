// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/indoor_light.h"

#include <algorithm>
#include <span>

#include "luxel/core/address.h"
#include "luxel/core/none.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/patch/side.h"
#include "luxel/render/side_point.h"

namespace luxel {
namespace {

constexpr std::uint32_t neighbours = 64;  // positions whose fronts, and whose backs, form one face
constexpr std::size_t rays = 64;          // per face
constexpr float indoors = 0.3f;           // enclosed fraction above which a face counts as indoors
constexpr double many = 0.05;             // fraction of the lit area above which the scene has an indoors
constexpr float reflected = 0.5f;         // assumed reflectance
constexpr int bounces = 16;
// Relative to lamps and the sky: darker faces are weighted less, so that a room wins over the cavity of a
// roof.
constexpr float dim = 0.1f;

// The sides of neighbouring patches: the fronts of group g are face 2 g, the backs face 2 g + 1.
class Faces {
 public:
  static constexpr std::uint32_t sky = none;

  Faces(const PatchSet& patches, const Context& context)
      : patches_(patches), tree_(make_patch_tree(patches, context)), group_of_(patches.size()) {
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (i == 0 || tree_.position[i] / neighbours != tree_.position[i - 1] / neighbours)
        begins_.push_back(i);
      group_of_[tree_.order[i]] = static_cast<std::uint32_t>(begins_.size() - 1);
    }
    begins_.push_back(patches.size());
  }

  std::size_t size() const { return 2 * (begins_.size() - 1); }
  std::span<const std::uint32_t> patches(std::size_t face) const {
    return std::span(tree_.order).subspan(begins_[face / 2], begins_[face / 2 + 1] - begins_[face / 2]);
  }

  // The faces, or the sky, that the rays of each face hit: [face * rays + ray].
  std::vector<std::uint32_t> look_round(const Tracer& tracer, const Context& context) const {
    std::vector<std::uint32_t> met(size() * rays);
    context.for_chunks(size(), 16, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin * rays; i < end * rays; ++i) met[i] = met_by(tracer, i / rays, i % rays);
    });
    return met;
  }

 private:
  std::uint32_t met_by(const Tracer& tracer, std::size_t face, std::size_t ray) const {
    const auto own = patches(face);
    const SideId side(own[ray * own.size() / rays], face % 2 == 1);
    const auto u =
        uniform4(stream_key(0, RandomPurpose::indoor_light, static_cast<std::uint32_t>(face)), ray);
    const auto direction = Frame(patches_.normal_of(side)).to_world(cosine_hemisphere(u[2], u[3]));
    const auto hit = tracer.nearest({point_before(patches_, side, u[0], u[1]), direction});
    return hit ? 2 * group_of_[hit.patch] + (hit.back ? 1 : 0) : sky;
  }

  const PatchSet& patches_;
  PatchTree tree_;
  std::vector<std::uint32_t> group_of_;  // [patch]
  std::vector<std::size_t> begins_;      // [group + 1], into the tree's order
};

// Rough brightness of faces: lamps and the sky are 1, and half of the arriving light is reflected. 0: not
// reached by light.
std::vector<float> brightness_of(const PatchSet& patches, const Faces& faces,
                                 const std::vector<std::uint32_t>& met) {
  std::vector<float> light(faces.size(), 0.0f);
  std::vector<bool> is_lamp(faces.size(), false);
  for (std::size_t f = 0; f < light.size(); f += 2) {
    const auto own = faces.patches(f);
    is_lamp[f] =
        std::any_of(own.begin(), own.end(), [&](auto p) { return patches.material_of(p).is_lamp(); });
  }
  for (int bounce = 0; bounce < bounces; ++bounce)
    for (std::size_t f = 0; f < light.size(); ++f) {
      float sum = 0.0f;
      for (auto i = f * rays; i < (f + 1) * rays; ++i)
        sum += met[i] == Faces::sky || is_lamp[met[i]] ? 1.0f : reflected * light[met[i]];
      light[f] = is_lamp[f] ? 1.0f : sum / rays;
    }
  return light;
}

}  // namespace

Solution indoor_light(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  const Faces faces(patches, context);
  const auto met = faces.look_round(tracer, context);
  const auto light = brightness_of(patches, faces, met);

  // How enclosed each face is, and whether the scene has an indoors.
  std::vector<float> fraction(faces.size(), 0.0f);
  double lit_area = 0.0;
  double inside = 0.0;
  for (std::size_t f = 0; f < fraction.size(); ++f) {
    const auto first = met.begin() + static_cast<std::ptrdiff_t>(f * rays);
    fraction[f] = 1.0f - static_cast<float>(std::count(first, first + rays, Faces::sky)) / rays;
    for (const auto p : faces.patches(f)) {
      if (!(light[f] > 0.0f)) continue;
      lit_area += static_cast<double>(patches.area[p]);
      if (fraction[f] > indoors) inside += static_cast<double>(patches.area[p]);
    }
  }
  const bool has_indoors = inside > many * lit_area;

  const auto bands = patches.band_count();
  Solution result;
  result.bands = patches.bands;
  for (auto* array : {&result.irradiance.front, &result.irradiance.back})
    array->assign(patches.size() * bands, 0.0f);
  for (std::size_t f = 0; f < fraction.size(); ++f) {
    if (!(light[f] > 0.0f) || (has_indoors && fraction[f] <= indoors)) continue;
    const auto seen = std::min(1.0f, light[f] / dim);
    auto& irradiance = result.irradiance.of(f % 2 == 1);
    for (const auto p : faces.patches(f))
      std::fill_n(&irradiance[p * bands], bands, has_indoors ? seen * fraction[f] * fraction[f] : 1.0f);
  }
  return result;
}

}  // namespace luxel
