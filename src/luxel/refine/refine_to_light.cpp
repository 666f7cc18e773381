// SPDX-License-Identifier: Apache-2.0
#include "luxel/refine/refine_to_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/patch/refine_patches.h"
#include "luxel/refine/level_difference.h"
#include "luxel/report/error.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

constexpr double light_share = 0.7;   // of the mesh error: how well the light is solved that decides
constexpr double left_alone = 0.3;    // of the squared error allowed: what patches that stay may have
constexpr double large_patch = 5e-4;  // of the whole area: cut once whatever it says
constexpr double least_ratio = 0.25, most_ratio = 0.5;  // that halving leaves of a squared error
constexpr double parts = 4.0;  // of a marked patch; neighbours are cut too, others not at all

void check(const RefineOptions& options) {
  if (!(options.mesh_error > 0.0))
    throw InputError(fmt::format("mesh_error must be above 0, not {}", options.mesh_error));
  if (options.max_levels < 1)
    throw InputError(fmt::format("max_levels must be 1 or more, not {}", options.max_levels));
}

// A mesh with its light.
struct Level {
  PatchSet patches;
  Solution solution;
  SmoothLight smooth;
  std::uint64_t rays = 0;
  double light2 = 0.0;  // see squared_light()

  LevelLight light() const { return {patches, solution, smooth}; }
};

class Refinement {
 public:
  Refinement(PatchSet patches, const RefineOptions& options, RefineReport& report, const Workers& workers,
             const Monitor& monitor)
      : options_(options), report_(report), workers_(workers), monitor_(monitor) {
    now_.patches = std::move(patches);
    options_.light.error = std::max(options_.light.error, light_share * options_.mesh_error);
  }

  PatchSet go() {
    if (!solve(now_)) return end(RefineStop::stopped_by_user);
    difference_ = difference_within_patches(now_.light(), workers_);
    note_level();
    auto marks = marked_by_difference();
    mark_large(marks);
    for (int level = 0;; ++level) {
      if (is_met() && level > 0) return end(RefineStop::mesh_error_reached);
      if (std::count(marks.begin(), marks.end(), 1) == 0)
        return end(is_met() ? RefineStop::mesh_error_reached : RefineStop::drowned_in_noise);
      if (level == options_.max_levels) return end(RefineStop::level_limit);
      auto refined = refine_within_limit(marks);
      if (!refined) return end(RefineStop::patch_limit);
      if (!descend(std::move(*refined))) return end(RefineStop::stopped_by_user);
      note_level();
      marks = marked_by_difference();
    }
  }

 private:
  PatchSet end(RefineStop stop) {
    report_.stop = stop;
    report_.mesh_error = report_.levels.empty() ? 0.0 : report_.levels.back().mesh_error;
    return std::move(now_.patches);
  }

  bool is_met() const { return report_.levels.back().mesh_error <= options_.mesh_error; }

  bool solve(Level& level) {
    const Tracer tracer(level.patches, workers_);
    const auto on_the_way = [&](const Progress& p) {
      return tell(monitor_, {"refine", 0.0, rays_before_ + p.rays, p.error});
    };
    const auto solved =
        solve_sampled(level.patches, tracer, level.solution, options_.light, workers_, on_the_way);
    level.rays = solved.rays;
    rays_before_ += solved.rays;
    level.light2 = squared_light(level.patches, level.solution);
    level.smooth = make_smooth_light(level.patches, level.solution, options_.smooth, workers_);
    return solved.stop != StopReason::stopped_by_user;
  }

  // Goes on to the finer mesh. What was not cut keeps what it was known to differ by.
  bool descend(RefinedPatches refined) {
    Level next;
    next.patches = std::move(refined.patches);
    if (!solve(next)) return false;
    auto difference = difference_of_levels(now_.light(), next.light(), refined.parent, workers_);
    const auto& parent = refined.parent;
    for (std::size_t p = 0; p < parent.size(); ++p) {
      const bool is_whole =
          (p == 0 || parent[p - 1] != parent[p]) && (p + 1 == parent.size() || parent[p + 1] != parent[p]);
      if (!is_whole) continue;
      difference.squared[p] = difference_.squared[parent[p]];
      difference.noise[p] = difference_.noise[parent[p]];
    }
    difference_ = std::move(difference);
    now_ = std::move(next);
    return true;
  }

  void note_level() {
    const auto sum = std::accumulate(difference_.squared.begin(), difference_.squared.end(), 0.0);
    const auto share = now_.light2 > 0.0 ? std::max(0.0, sum) / now_.light2 : 0.0;
    // What the first level says of itself is of another kind.
    if (report_.levels.size() >= 2 && share_before_ > 0.0) {
      const auto ratio = std::clamp(share / share_before_, least_ratio, most_ratio);
      left_over_ = ratio / (1.0 - ratio);
    }
    share_before_ = share;
    report_.levels.push_back(
        {now_.patches.size(), std::sqrt(left_over_ * share), now_.solution.predicted_error, now_.rays});
  }

  // The fewest patches that leave a share of what is allowed to the others. What noise may have made is no
  // reason to cut.
  std::vector<std::uint8_t> marked_by_difference() const {
    std::vector<std::uint32_t> order;
    double left = 0.0;
    for (std::uint32_t p = 0; p < now_.patches.size(); ++p) {
      if (difference_.squared[p] <= difference_.noise[p]) continue;
      order.push_back(p);
      left += difference_.squared[p];
    }
    sort_by_difference(order);
    const auto allowed = left_alone * options_.mesh_error * options_.mesh_error * now_.light2 / left_over_;
    std::vector<std::uint8_t> marks(now_.patches.size(), 0);
    for (const auto p : order) {
      if (left <= allowed) break;
      marks[p] = 1;
      left -= difference_.squared[p];
    }
    return marks;
  }

  void sort_by_difference(std::vector<std::uint32_t>& order) const {
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const auto x = difference_.squared[a];
      const auto y = difference_.squared[b];
      return x != y ? x > y : a < b;
    });
  }

  void mark_large(std::vector<std::uint8_t>& marks) const {
    const auto& area = now_.patches.area;
    const auto least = large_patch * std::accumulate(area.begin(), area.end(), 0.0);
    for (std::size_t p = 0; p < area.size(); ++p)
      if (static_cast<double>(area[p]) > least) marks[p] = 1;
  }

  // Where they would be too many, those that differ most.
  std::optional<RefinedPatches> refine_within_limit(const std::vector<std::uint8_t>& marks) const {
    const auto size = now_.patches.size();
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < size; ++p)
      if (marks[p] != 0) order.push_back(p);
    sort_by_difference(order);
    const auto room = options_.max_patches > size ? options_.max_patches - size : 0;
    auto count = std::min(order.size(), static_cast<std::size_t>(static_cast<double>(room) / (parts - 1.0)));
    for (; count > 0; count = count * 3 / 4) {
      std::vector<std::uint8_t> chosen(size, 0);
      for (std::size_t i = 0; i < count; ++i) chosen[order[i]] = 1;
      auto refined = refine_patches(now_.patches, chosen);
      if (refined.patches.size() <= options_.max_patches) return refined;
    }
    return std::nullopt;
  }

  RefineOptions options_;
  RefineReport& report_;
  const Workers& workers_;
  const Monitor& monitor_;
  Level now_;
  FieldDifference difference_;  // of the patches now
  double share_before_ = 0.0;   // of the level before: squared differences over squared light
  double left_over_ = 1.0;      // of the squared differences: what is still wrong
  std::uint64_t rays_before_ = 0;
};

}  // namespace

PatchSet refine_to_light(PatchSet patches, const RefineOptions& options, RefineReport& report,
                         const Workers& workers, const Monitor& monitor) {
  check(options);
  report = {};
  return Refinement(std::move(patches), options, report, workers, monitor).go();
}

}  // namespace luxel
