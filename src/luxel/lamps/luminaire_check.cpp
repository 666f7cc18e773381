// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/luminaire_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "luxel/patch/make_patches.h"
#include "luxel/photometry/figures.h"
#include "luxel/photometry/photometry.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
namespace {

constexpr double reach = 0.05;      // m: how far before an opening a surface counts as placed by mistake
constexpr double margin = 0.1;      // m: as far beyond the opening such a surface goes on
constexpr double min_ahead = 0.01;  // of the largest intensity: a luminaire shines along its aim if above

// The axes of a luminaire's photometry, in the scene.
std::array<Vec3d, 3> axes_of(const PointLight& light) {
  return {Vec3d(light.local_x), Vec3d(light.local_y), -Vec3d(light.direction)};
}

// A line along one axis of an opening, from one of its ends to the other or beyond.
struct Probe {
  Vec3d from, direction;
  double length = 0.0;  // m
};

Hit first_hit(const Tracer& tracer, const Probe& probe) {
  const auto hit = tracer.nearest({Vec3(probe.from), Vec3(probe.direction)});
  return hit && static_cast<double>(hit.distance) < probe.length ? hit : Hit{};
}

// True if lines beside the opening meet something too, on two sides at least.
bool is_wider(const Tracer& tracer, const PointLight& light, std::size_t axis, const Probe& probe) {
  const auto axes = axes_of(light);
  int met = 0;
  for (const auto other : {(axis + 1) % 3, (axis + 2) % 3}) {
    const auto k = static_cast<glm::length_t>(other);
    const auto aside = (0.5 * light.photometry->opening.size[k] + margin) * axes[other];
    for (const auto& offset : {aside, -aside})
      if (first_hit(tracer, {probe.from + offset, probe.direction, probe.length})) ++met;
  }
  return met >= 2;
}

bool shines_ahead(const PointLight& light) {
  return photometric_figures(light.photometry->intensity).downward_fraction >= 0.5;
}

std::optional<LuminaireFault> fault_along(const Tracer& tracer, const PointLight& light, std::size_t axis) {
  const auto depth = light.photometry->opening.size[static_cast<glm::length_t>(axis)];
  const auto along = -axes_of(light)[axis];
  const bool is_aim = axis == 2;
  const auto aim = Vec3d(light.position) + Vec3d(light.direction);
  const bool looks_ahead = is_aim && relative_intensity(light, aim) > min_ahead;
  const Probe probe{Vec3d(light.position) - 0.5 * depth * along, along, depth + (looks_ahead ? reach : 0.0)};
  if (!(probe.length > recess)) return std::nullopt;
  const auto hit = first_hit(tracer, probe);
  if (!hit || !is_wider(tracer, light, axis, probe)) return std::nullopt;
  const auto at = static_cast<double>(hit.distance);
  LuminaireFault fault;
  fault.patch = hit.patch;
  if (at < recess || std::abs(at - depth) < recess) return std::nullopt;
  fault.kind = at < depth ? LuminaireFault::Kind::crosses : LuminaireFault::Kind::hides;
  // Along the aim, the luminaire is moved into the room that it lights most.
  const bool is_forward =
      is_aim ? fault.kind == LuminaireFault::Kind::hides || shines_ahead(light) : at < depth - at;
  fault.move = (is_forward ? at : at - depth) * along;
  return fault;
}

std::optional<LuminaireFault> fault_of(const Tracer& tracer, const PointLight& light) {
  if (!has_opening(light)) return std::nullopt;
  for (const std::size_t axis : {2u, 0u, 1u})
    if (const auto fault = fault_along(tracer, light, axis)) return fault;
  return std::nullopt;
}

std::string describe(const LuminaireFaultGroup& group) {
  const auto count = group.faults.size();
  const auto who = count == 1 ? fmt::format("a luminaire of '{}'", group.file)
                              : fmt::format("{} luminaires of '{}'", count, group.file);
  const bool crosses = group.kind == LuminaireFault::Kind::crosses;
  const auto verb = crosses ? (count == 1 ? "reaches" : "reach") : (count == 1 ? "lies" : "lie");
  return fmt::format("{} {} {:.0f} mm {} a surface of '{}'", who, verb, 1000.0 * group.distance,
                     crosses ? "through" : "behind", group.material);
}

}  // namespace

std::vector<LuminaireFault> find_luminaire_faults(const PatchSet& patches, const Tracer& tracer) {
  std::vector<LuminaireFault> faults;
  for (std::size_t i = 0; i < patches.point_lights.size(); ++i)
    if (auto fault = fault_of(tracer, patches.point_lights[i].light)) {
      fault->light = i;
      faults.push_back(*fault);
    }
  return faults;
}

std::vector<LuminaireFaultGroup> group_faults(const PatchSet& patches,
                                              const std::vector<LuminaireFault>& faults) {
  std::vector<LuminaireFaultGroup> groups;
  for (const auto& fault : faults) {
    const auto& photometry = *patches.point_lights[fault.light].light.photometry;
    const auto file = std::filesystem::path(photometry.file).filename().string();
    const auto& material = patches.material_of(fault.patch).name;
    auto found = std::find_if(groups.begin(), groups.end(), [&](const LuminaireFaultGroup& g) {
      return g.kind == fault.kind && g.file == file && g.material == material;
    });
    if (found == groups.end()) found = groups.insert(found, {fault.kind, file, material, {}, 0.0, {}, {}});
    found->faults.push_back(fault);
  }
  for (auto& group : groups) {
    for (const auto& fault : group.faults) group.distance = std::max(group.distance, glm::length(fault.move));
    group.fact = describe(group);
    group.remedy = fmt::format("move {} by {:.0f} mm, {}", group.faults.size() == 1 ? "it" : "them",
                               1000.0 * group.distance,
                               group.kind == LuminaireFault::Kind::crosses ? "away from it" : "before it");
  }
  return groups;
}

std::string moved_text(const LuminaireFaultGroup& group) {
  return fmt::format("{}: moved away from it by as much", group.fact);
}

std::vector<LuminaireFaultGroup> move_luminaires_free(Scene& scene, const Context& context) {
  const bool any_body = std::any_of(
      scene.point_lights.begin(), scene.point_lights.end(),
      [](const auto& light) { return has_opening(light) && light.photometry->opening.size.z > recess; });
  if (!any_body) return {};
  auto patches = make_patches(scene, {.max_edge = no_max_edge, .contacts = false}, context.quiet());
  if (patches.size() == 0) return {};
  const Tracer tracer(patches, context.quiet());
  std::vector<LuminaireFault> mended;
  for (const auto& fault : find_luminaire_faults(patches, tracer)) {
    if (fault.kind != LuminaireFault::Kind::crosses) continue;
    auto& light = patches.point_lights[fault.light].light;
    const auto moved = Vec3(Vec3d(light.position) + fault.move);
    light.position = moved;
    if (fault_of(tracer, light)) continue;
    scene.point_lights[fault.light].position = moved;
    mended.push_back(fault);
  }
  return group_faults(patches, mended);
}

}  // namespace luxel
