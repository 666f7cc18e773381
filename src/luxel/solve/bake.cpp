// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/bake.h"

#include <algorithm>
#include <utility>

#include "luxel/core/context.h"
#include "luxel/lamps/shadow_lines.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

constexpr std::size_t min_shadow_patches = 4000;  // that lines may add to any scene

}  // namespace

PatchSet make_patches_for_light(const Scene& scene, PatchOptions options, const Context& context) {
  const bool is_automatic = options.max_edge == automatic_edge;
  if (scene.point_lights.empty() || !options.contacts || !(is_automatic || options.max_edge > 0.0f))
    return make_patches(scene, options, context);
  const auto triangles =
      make_patches(scene, {.max_edge = no_max_edge, .contacts = false}, context.with_log({}));
  if (triangles.size() == 0) return {};
  const auto max_edge = is_automatic ? automatic_max_edge(scene, options.target_count) : options.max_edge;
  const auto patches = triangles.size() + (is_automatic ? options.target_count : 0);
  const Tracer tracer(triangles, context);
  auto lines = find_shadow_lines(triangles, tracer,
                                 {.max_edge = static_cast<double>(max_edge),
                                  .contact_gap = static_cast<double>(options.contact_gap),
                                  .max_contacts = contact_budget(options, scene.triangles.size()),
                                  .max_patches = std::max(min_shadow_patches, patches / 2)},
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
