// SPDX-License-Identifier: Apache-2.0
#include "luxel/window/instruments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "luxel/live/tree_boxes.h"

namespace luxel {
namespace {

constexpr std::size_t most_normals = 100'000, most_boxes = 20'000;
const Vec3 normal_colour(0.05f, 0.55f, 0.75f), outline_colour(1.0f, 0.75f, 0.05f);

void add_normals(const PatchSet& patches, Marks& marks) {
  const auto step = patches.size() / most_normals + 1;
  for (std::size_t patch = 0; patch < patches.size(); patch += step) {
    const auto middle = patches.centroid(patch);
    marks.add_segment(middle, middle + 0.5f * std::sqrt(patches.area[patch]) * patches.normal[patch],
                      normal_colour);
  }
}

void add_boxes(const std::vector<Bounds>& boxes, Marks& marks) {
  const auto count = std::min(boxes.size(), most_boxes);
  for (std::size_t i = 0; i < count; ++i) {
    const float shade = static_cast<float>(i * 37 % 100) / 100.0f;
    marks.add_box(boxes[i], Vec3(0.15f + 0.5f * shade, 0.7f, 0.75f - 0.5f * shade));
  }
}

void add_outline(const PatchSet& patches, std::size_t patch, Marks& marks) {
  const auto points = patches.points(patch);
  for (std::size_t i = 0; i < 3; ++i) marks.add_segment(points[i], points[(i + 1) % 3], outline_colour);
}

}  // namespace

void Instruments::forget() {
  boxes_.reset();
  made_ = {};
  marks_ = {};
  ++version_;
}

void Instruments::find_boxes(const LiveMesh& mesh) {
  if (auto done = finding_boxes_.take(); done && (*done)->of == mesh.patches) boxes_ = *done;
  if (boxes_ || finding_boxes_.is_busy()) return;
  finding_boxes_.start([patches = mesh.patches] {
    return std::make_shared<const Boxes>(
        Boxes{patches, tree_boxes(*patches, make_patch_tree(*patches, Workers(1)))});
  });
}

bool Instruments::update(const Look& look, const std::shared_ptr<const LiveMesh>& mesh,
                         const std::shared_ptr<const LiveLight>& light, const std::optional<Probe>& probe,
                         bool is_pinned) {
  if (!mesh) return false;
  if (look.boxes) find_boxes(*mesh);
  const bool has_side = probe && (is_pinned || look.rays || look.samples);
  const Made wanted{
      look.normals,
      look.boxes,
      look.rays,
      look.samples,
      look.box_level,
      look.rays || look.samples ? (light ? light->number : 0) : 0,
      mesh->patches.get(),
      boxes_.get(),
      has_side ? std::optional<std::uint64_t>(2ull * probe->patch + probe->back) : std::nullopt};
  if (wanted == made_) return false;
  made_ = wanted;
  marks_ = {};
  ++version_;
  const auto& patches = *mesh->patches;
  if (look.normals) add_normals(patches, marks_);
  if (look.boxes && boxes_ && !boxes_->levels.empty())
    add_boxes(boxes_->levels[std::min(static_cast<std::size_t>(look.box_level), boxes_->levels.size() - 1)],
              marks_);
  if (has_side) add_outline(patches, probe->patch, marks_);
  return true;
}

}  // namespace luxel
