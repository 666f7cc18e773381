// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/bake.h"

#include <algorithm>
#include <utility>

#include "luxel/core/context.h"
#include "luxel/lamps/shadow_lines.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

// Patches that lines of shadows may add: half of those of the scene, but at least this many, and no more than
// the second where all lights have surfaces.
constexpr std::size_t min_shadow_patches = 10'000, max_soft_patches = 20'000;
// As fractions of the automatic edge length, below 1 because patches of automatic size are refined later: the
// scale of shadow features, and the widest penumbra with lines, where 1 stands for a given edge length.
constexpr double automatic_detail = 0.08, automatic_penumbra = 0.125, given_penumbra = 0.5;

std::size_t max_shadow_patches(const Scene& scene, std::size_t patches) {
  const auto most = std::max(min_shadow_patches, patches / 2);
  return scene.point_lights.empty() ? std::min(most, max_soft_patches) : most;
}

}  // namespace

PatchSet make_patches_for_light(const Scene& scene, PatchOptions options, const Context& context) {
  const bool is_automatic = options.max_edge == automatic_edge;
  if (!has_lamp(scene) || !options.contacts || !(is_automatic || options.max_edge > 0.0f))
    return make_patches(scene, options, context);
  const auto triangles = make_patches(
      scene, {.max_edge = no_max_edge, .contacts = false, .plain_reflectance = true}, context.with_log({}));
  if (triangles.size() == 0) return {};
  const auto max_edge = is_automatic ? automatic_max_edge(scene, options.target_count) : options.max_edge;
  const auto patches = triangles.size() + (is_automatic ? options.target_count : 0);
  const Tracer tracer(triangles, context);
  auto lines =
      find_shadow_lines(triangles, tracer,
                        {.max_edge = static_cast<double>(max_edge),
                         .detail = (is_automatic ? automatic_detail : 1.0) * static_cast<double>(max_edge),
                         .widest_penumbra = (is_automatic ? automatic_penumbra : given_penumbra) *
                                            static_cast<double>(max_edge),
                         .contact_gap = static_cast<double>(options.contact_gap),
                         .max_contacts = max_contact_lines(options, scene.triangles.size()),
                         .max_patches = max_shadow_patches(scene, patches)},
                        context);
  options.shadow_lines.insert(options.shadow_lines.end(), lines.begin(), lines.end());
  return make_patches(scene, options, context);
}

Baked bake(const Scene& scene, const BakeOptions& options, const Context& context) {
  check_scene(scene);
  Baked baked{make_patches_for_light(scene, options.patches, context), {}};
  if (baked.patches.size() == 0) return baked;
  const Tracer tracer(baked.patches, context);
  solve_sampled(baked.patches, tracer, baked.solution, options.light, context);
  return baked;
}

}  // namespace luxel
