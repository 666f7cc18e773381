// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/automatic_camera.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/bounds.h"
#include "luxel/core/error.h"
#include "luxel/render/indoor_light.h"
#include "luxel/render/lit_sides.h"
#include "luxel/render/view_candidates.h"
#include "luxel/render/view_score.h"
#include "luxel/trace/place_views.h"

namespace luxel {
namespace {

constexpr int coarse_rows = 9;  // 108 rays per view
constexpr int fine_rows = 24;   // 768 rays per view
constexpr std::size_t finalists_inside = 16;
constexpr std::size_t finalists_outside = 8;
// smallest difference of scores that counts: below it the first view wins, so that rounding (for example in
// another unit of length) does not select the view
constexpr double clearly = 1e-3;

struct Ranked {
  View view;
  double score = -1e30;
  float depth = 0.0f;
};

Ranked rank(const Subject& subject, const View& view, int rows) {
  const auto facts = look(subject, camera_of(view, subject.up, subject.diagonal), rows);
  return {view, score(facts, subject.openness), facts.depth};
}

void keep_more_visible(Ranked& best, const Ranked& other) {
  if (other.score > best.score + clearly) best = other;
}

Ranked best_of(const Subject& subject, const std::vector<View>& views, int rows) {
  Ranked best;
  for (const auto& view : views) keep_more_visible(best, rank(subject, view, rows));
  return best;
}

// The view after a step sideways, up or ahead (fractions of the depth), a turn and a change of pitch. Steps
// through walls are omitted.
View moved(const Subject& subject, const Ranked& from, const Vec3& step, float turn, float nod) {
  View view = from.view;
  const auto camera = camera_of({view.eye, view.turn, 0.0f, view.vertical_fov}, subject.up, 1.0f);
  const auto ahead = glm::normalize(camera.target - camera.eye);
  const auto side = glm::cross(ahead, subject.up);
  const auto way = from.depth * (step.x * side + step.y * subject.up + step.z * ahead);
  const auto length = glm::length(way);
  if (length > 0.0f && !subject.tracer.occluded({view.eye, way / length}, 1.2f * length)) view.eye += way;
  view.turn += turn;
  view.pitch = std::clamp(view.pitch + nod, -0.15f, 0.15f);
  return view;
}

// Improves a view by small moves, which are halved where none helps.
Ranked refined(const Subject& subject, const View& start) {
  auto best = rank(subject, start, fine_rows);
  float size = 1.0f;
  for (int round = 0; round < 4; ++round) {
    const auto before = best.score;
    for (const auto sign : {-size, size}) {
      keep_more_visible(best, rank(subject, moved(subject, best, Vec3(0.0f), 0.05f * sign, 0.0f), fine_rows));
      keep_more_visible(
          best, rank(subject, moved(subject, best, {0.0f, 0.0f, 0.25f * sign}, 0.0f, 0.0f), fine_rows));
      keep_more_visible(
          best, rank(subject, moved(subject, best, {0.2f * sign, 0.0f, 0.0f}, 0.0f, 0.0f), fine_rows));
      keep_more_visible(best, rank(subject, moved(subject, best, Vec3(0.0f), 0.0f, 0.02f * sign), fine_rows));
    }
    if (best.score == before) size *= 0.5f;
  }
  return best;
}

// The best view of each group; of these the best `count`, in descending order.
std::vector<Ranked> best_groups(const Subject& subject, const std::vector<std::vector<View>>& groups,
                                std::size_t count, const Context& context) {
  std::vector<Ranked> ranked(groups.size());
  context.for_chunks(groups.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) ranked[i] = best_of(subject, groups[i], coarse_rows);
  });
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Ranked& a, const Ranked& b) { return a.score > b.score; });
  ranked.resize(std::min(ranked.size(), count));
  return ranked;
}

void check(const PatchSet& patches, const Vec3& up, float aspect) {
  if (patches.size() == 0)
    throw InputError("there is nothing to look at: the scene has no surface with area");
  if (!is_finite(up) || up == Vec3(0.0f))
    throw InputError("the up direction must be finite and not zero; (0, 1, 0) and (0, 0, 1) are usual");
  if (!(aspect >= smallest_aspect && aspect <= max_aspect))
    throw InputError(fmt::format("a picture's width / height must be from {} to {}, but it is {}",
                                 smallest_aspect, max_aspect, aspect));
}

Bounds bounds_of(const PatchSet& patches) {
  Bounds box;
  for (const auto& corners : patches.corners)
    for (const auto c : corners) box.add(patches.vertices[c]);
  return box;
}

}  // namespace

Camera automatic_camera(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                        const Vec3& up, float aspect, const Context& context) {
  check(patches, up, aspect);
  const auto sides = patches.has_sky()
                         ? make_lit_sides(patches, indoor_light(patches, tracer, context), {})
                         : make_lit_sides(patches, solution, place_views(patches, tracer, context).stating);
  const auto box = bounds_of(patches);
  Subject subject{patches, sides, tracer, box, glm::length(box.size()), glm::normalize(up), aspect};
  subject.openness = openness(subject);

  // 1. The best view of each place by coarse thumbnails. Views from outside are ranked separately: they would
  // be lost among the many from inside.
  auto finals = best_groups(subject, views_from_inside(subject), finalists_inside, context);
  for (const auto& one : best_groups(subject, views_from_outside(subject), finalists_outside, context))
    finals.push_back(one);

  // 2. Score the finalists with finer thumbnails and improve them by small moves.
  context.for_chunks(finals.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) finals[i] = refined(subject, finals[i].view);
  });

  Ranked best;
  for (const auto& one : finals) keep_more_visible(best, one);
  // Large enough for eye and target to differ in float.
  const auto distance = best.depth > 0.0f ? std::max(best.depth, 1e-3f * subject.diagonal) : subject.diagonal;
  return camera_of(best.view, subject.up, distance);
}

}  // namespace luxel
