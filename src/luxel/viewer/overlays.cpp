// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/overlays.h"

#include <algorithm>
#include <cmath>

#include "luxel/patch/patch_tree.h"
#include "luxel/session/sample_rays.h"
#include "luxel/session/tree_boxes.h"
#include "luxel/viewer/solid_marks.h"

namespace luxel {
namespace {

constexpr std::size_t max_normals = 100'000, max_boxes = 20'000, max_rays = 256;
const Vec3 normal_colour(0.05f, 0.55f, 0.75f), outline_colour(1.0f, 0.75f, 0.05f),
    line_colour(1.0f, 0.5f, 0.05f);
const Vec3 gather_colour(0.9f, 0.35f, 0.05f), lost_colour(0.25f, 0.3f, 0.5f);
const Vec3 seen_colour(1.0f, 0.9f, 0.2f), blocked_colour(0.75f, 0.03f, 0.05f);

void add_normals(const PatchSet& patches, Marks& marks) {
  const auto step = patches.size() / max_normals + 1;
  for (std::size_t patch = 0; patch < patches.size(); patch += step) {
    const auto middle = patches.centroid(patch);
    marks.add_segment(middle, middle + 0.5f * std::sqrt(patches.area[patch]) * patches.normal[patch],
                      normal_colour);
  }
}

// Neighbours get different colours.
void add_boxes(const std::vector<Bounds>& boxes, Marks& marks) {
  const auto count = std::min(boxes.size(), max_boxes);
  for (std::size_t i = 0; i < count; ++i) {
    const float shade = static_cast<float>(i * 37 % 100) / 100.0f;
    marks.add_box(boxes[i], Vec3(0.15f + 0.5f * shade, 0.7f, 0.75f - 0.5f * shade));
  }
}

void add_outline(const PatchSet& patches, std::size_t patch, Marks& marks) {
  const auto points = patches.points(patch);
  for (std::size_t i = 0; i < 3; ++i) marks.add_segment(points[i], points[(i + 1) % 3], outline_colour);
}

// Gather rays to the surfaces they hit; those that leave the scene are cut short.
void add_gather_rays(const SessionLight& light, const Probe& probe, float size, Marks& marks) {
  for (const auto& ray : gather_rays(light, probe.patch, probe.back, max_rays)) {
    const bool hits = static_cast<bool>(ray.hit);
    const auto end = ray.from + (hits ? ray.hit.distance : 0.3f * size) * ray.direction;
    marks.add_segment(ray.from, end, hits ? gather_colour : lost_colour);
    if (hits) marks.add_point(end, gather_colour);
  }
}

void add_direct_rays(const SessionLight& light, const Probe& probe, Marks& marks) {
  for (const auto& ray : direct_rays(light, probe.patch, probe.back, max_rays)) {
    const auto& colour = ray.seen ? seen_colour : blocked_colour;
    marks.add_segment(ray.from, ray.to, colour);
    marks.add_point(ray.to, colour);
  }
}

// Triangles and edges in the colours that `luxel check` gives their kinds.
void add_faults(const Scene& scene, const CheckReport& report, Marks& marks) {
  for (const auto& diagnostic : report.diagnostics) {
    const auto ink = colour(diagnostic.kind).linear;
    for (const auto& edge : diagnostic.edges) marks.add_segment(edge[0], edge[1], ink);
    for (const auto triangle : diagnostic.triangles) {
      const auto& corners = scene.triangles[triangle];
      for (std::size_t i = 0; i < 3; ++i)
        marks.add_segment(scene.positions[corners[i]], scene.positions[corners[(i + 1) % 3]], ink);
    }
  }
}

// Marks the line of the plot, also in other views: dashes of two colours, visible on any surface.
void add_line(const std::vector<ProfilePoint>& profile, Marks& marks) {
  constexpr std::size_t dash = 6;
  std::optional<Vec3> last;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const auto& place = profile[i].place;
    if (!place) continue;
    if (last) marks.add_segment(*last, *place, i / dash % 2 == 0 ? line_colour : Vec3(0.0f));
    if (!last) marks.add_point(*place, line_colour);
    last = place;
  }
  if (last) marks.add_point(*last, line_colour);
}

float size_of(const PatchSet& patches) {
  Bounds box;
  for (const auto& vertex : patches.vertices) box.add(vertex);
  return glm::length(box.size());
}

}  // namespace

void Overlays::forget() {
  made_ = {};
  marks_ = {};
  ++version_;
}

bool Overlays::update(const Look& look, const std::shared_ptr<const SessionMesh>& mesh,
                      const std::shared_ptr<const SessionLight>& light, const LightProbe& light_probe,
                      const std::shared_ptr<const CheckReport>& diagnostics) {
  if (!mesh) return false;
  const auto& probe = light_probe.probe();
  const bool is_lit = light && light->mesh.geometry == mesh->geometry;
  const auto& as_lit = is_lit ? light->mesh.patches : mesh->patches;
  const bool asks_rays = look.rays || look.samples;
  const bool has_side = probe && (light_probe.is_pinned() || asks_rays);
  const Made wanted{
      look.normals,
      look.boxes && mesh->tree,
      look.rays,
      look.samples,
      look.box_level,
      asks_rays && light ? light->number : 0,
      light_probe.line_version(),
      mesh->patches.get(),
      look.diagnostics ? diagnostics.get() : nullptr,
      look.solids ? as_lit.get() : nullptr,
      has_side ? std::optional<std::uint64_t>(2ull * probe->patch + (probe->back ? 1 : 0)) : std::nullopt};
  if (wanted == made_) return false;
  made_ = wanted;
  marks_ = {};
  ++version_;
  const auto& patches = *mesh->patches;
  if (wanted.normals) add_normals(patches, marks_);
  if (wanted.boxes) {
    const auto levels = tree_boxes(patches, *mesh->tree);
    add_boxes(levels[std::min(static_cast<std::size_t>(look.box_level), levels.size() - 1)], marks_);
  }
  add_line(light_probe.profile(), marks_);
  if (has_side) add_outline(patches, probe->patch, marks_);
  if (has_side && light && look.rays) add_gather_rays(*light, *probe, size_of(patches), marks_);
  if (has_side && light && look.samples) add_direct_rays(*light, *probe, marks_);
  if (wanted.diagnostics != nullptr && mesh->scene) add_faults(*mesh->scene, *diagnostics, marks_);
  if (wanted.luminaires != nullptr) add_photometric_solids(*as_lit, size_of(patches), marks_);
  return true;
}

}  // namespace luxel
