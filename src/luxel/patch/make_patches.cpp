// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/make_patches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/bounds.h"
#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/cut_contacts.h"
#include "luxel/patch/dense_lines.h"
#include "luxel/patch/line_search.h"
#include "luxel/patch/make_panes.h"
#include "luxel/patch/near_lines.h"
#include "luxel/patch/overlaps.h"
#include "luxel/patch/set_bands.h"
#include "luxel/patch/size_field.h"
#include "luxel/patch/triangle_splitter.h"
#include "luxel/scene/clean_triangles.h"
#include "luxel/scene/up_axis.h"

namespace luxel {
namespace {

constexpr std::size_t triangles_per_report = 1 << 14;
// Memory of a patch and its part of the patch tree. Measured: 170 bytes on a plate, 290 in a scene whose
// surfaces touch in many places.
constexpr double bytes_per_patch = 300.0;

// Mean area, as a fraction of h², of a triangle whose longest edge bisection has brought between h / sqrt(2)
// and h: a right isosceles triangle on that hypotenuse, averaged.
constexpr double split_area_fraction = 0.18;

// Estimates the number of parts to some tens of per cent: by area, and for slivers by the length of the
// longest edge.
double expected_parts(double area, double longest, double max_edge) {
  if (longest <= max_edge) return 1.0;
  return std::max({1.0, area / (split_area_fraction * max_edge * max_edge), 1.5 * longest / max_edge});
}

struct Shape {
  double area = 0.0;
  double longest = 0.0;
};

// Shapes of the triangles that become patches.
std::vector<Shape> shapes(const Scene& scene) {
  std::vector<Shape> result;
  result.reserve(scene.triangles.size());
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    if (!scene.materials[static_cast<std::size_t>(scene.triangle_material[i])].opaque) continue;
    const auto& t = scene.triangles[i];
    const Vec3d a(scene.positions[t[0]]), b(scene.positions[t[1]]), c(scene.positions[t[2]]);
    result.push_back({0.5 * glm::length(glm::cross(b - a, c - a)),
                      std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)})});
  }
  return result;
}

double expected_count(const std::vector<Shape>& all, double max_edge) {
  double count = 0.0;
  for (const auto& s : all) count += expected_parts(s.area, s.longest, max_edge);
  return count;
}

// Returns the shortest edge (to 1 %) whose expected count is within the given one.
double edge_for_count(const std::vector<Shape>& all, double count) {
  double longest = 0.0;
  for (const auto& s : all) longest = std::max(longest, s.longest);
  if (longest == 0.0) return 1.0;
  double low = longest * 1e-7;
  double high = longest;
  while (high > low * 1.01) {
    const auto middle = std::sqrt(low * high);
    (expected_count(all, middle) > count ? low : high) = middle;
  }
  return high;
}

// Returns the material of each triangle. Two one-sided sheets back to back are one sheet seen from both
// sides: its material is a two-sided twin, which is added to those of the patches.
std::vector<MaterialId> materials_of(const std::vector<CleanTriangle>& triangles, const Scene& scene,
                                     PatchSet& patches) {
  std::map<MaterialId, MaterialId> twins;
  std::vector<MaterialId> result;
  result.reserve(triangles.size());
  for (const auto& t : triangles) {
    auto material = scene.triangle_material[t.triangle];
    const auto i = static_cast<std::size_t>(material);
    if (t.opposite_twin && !patches.materials[i].two_sided) {
      const auto [twin, is_new] =
          twins.try_emplace(material, static_cast<MaterialId>(patches.materials.size()));
      if (is_new) {
        auto two_sided = patches.materials[i];
        two_sided.two_sided = true;
        patches.materials.push_back(std::move(two_sided));
      }
      material = twin->second;
    }
    result.push_back(material);
  }
  return result;
}

void reserve(PatchSet& patches, std::size_t count) {
  patches.corners.reserve(count);
  patches.normal.reserve(count);
  patches.area.reserve(count);
  patches.material.reserve(count);
  patches.triangle.reserve(count);
}

// Patches that do not fit into memory, in words; empty where they fit.
std::string patches_beyond_memory(double patches) {
  const auto lack = lack_of_memory(bytes_per_patch * patches);
  return lack.empty() ? "" : fmt::format("about {:.2g} patches, which need about {}", patches, lack);
}

void check_memory(const Scene& scene) {
  constexpr double patches_per_triangle = 2.0;  // of scenes that are not split at all, and where they touch
  const auto count = static_cast<double>(scene.triangles.size());
  if (const auto beyond = patches_beyond_memory(patches_per_triangle * count); !beyond.empty())
    throw InputError(scene.source, fmt::format("its triangles make {}", beyond));
}
void check_memory(const PatchSet& patches, std::size_t contact_lines) {
  constexpr double patches_per_line = 2.0;
  const auto count =
      static_cast<double>(patches.size()) + patches_per_line * static_cast<double>(contact_lines);
  if (const auto beyond = patches_beyond_memory(count); !beyond.empty())
    throw with_hints(InputError(fmt::format("the scene makes {}: a longer edge is needed, or no cuts where "
                                            "surfaces touch",
                                            beyond)),
                     {{Setting::max_edge}, {Setting::contacts, "off"}});
}

// Returns the maximum edge, or 0 for none; refuses one whose patches would not fit into memory.
double chosen_edge(const Scene& scene, const PatchOptions& options) {
  if (options.max_edge == automatic_edge) return automatic_max_edge(scene, options.target_count);
  if (!(options.max_edge >= 0.0f))
    throw InputError(fmt::format("max_edge must be 0 or more metres, not {}", options.max_edge));
  if (options.max_edge == no_max_edge) return 0.0;
  const auto all = shapes(scene);
  const auto expected = expected_count(all, options.max_edge);
  if (expected > 2.0 * static_cast<double>(options.max_count))
    throw with_hints(InputError(fmt::format(
                         "an edge of {} m would make about {:.2g} patches, more than {}: {:.3g} m would fit",
                         options.max_edge, expected, options.max_count,
                         edge_for_count(all, 0.7 * static_cast<double>(options.max_count)))),
                     {{Setting::max_edge}});
  if (const auto beyond = patches_beyond_memory(expected); !beyond.empty()) {
    const auto fitting = 0.7 * static_cast<double>(free_memory()) / bytes_per_patch;
    throw with_hints(InputError(fmt::format("an edge of {} m would make {}: {:.3g} m would fit",
                                            options.max_edge, beyond, edge_for_count(all, fitting))),
                     {{Setting::max_edge}});
  }
  return options.max_edge;
}

// Adds lines in the order of comes_before().
void merge_into(std::vector<ContactLine>& lines, const std::vector<ContactLine>& more) {
  const auto middle = static_cast<std::ptrdiff_t>(lines.size());
  lines.insert(lines.end(), more.begin(), more.end());
  std::inplace_merge(lines.begin(), lines.begin() + middle, lines.end(), comes_before);
}

// Outlines of things before a surface that patches of this size do not resolve.
std::vector<ContactLine> outlines_near(const std::vector<CleanTriangle>& triangles,
                                       const std::vector<Vec3>& positions, const PatchOptions& options,
                                       double max_edge, const Context& context) {
  constexpr double of_edge = 0.35;   // of the longest edge of a patch, that things are close at
  constexpr double of_scene = 0.01;  // of its diagonal, at most
  if (!(max_edge > 0.0)) return {};
  Bounds box;
  for (const auto& p : positions) box.add(p);
  const auto distance = std::min(of_edge * max_edge, of_scene * static_cast<double>(glm::length(box.size())));
  return find_near_lines(triangles, positions, options.contact_gap, distance,
                         max_contact_lines(options, triangles.size()), context);
}

// Shadow lines on triangles that are left, as lines of something that stands along the normal.
std::vector<ContactLine> shadow_edges(const std::vector<CleanTriangle>& triangles,
                                      const std::vector<ShadowLine>& lines) {
  const auto comes_first = [](const CleanTriangle& t, std::uint32_t i) { return t.triangle < i; };
  std::vector<ContactLine> result;
  for (const auto& line : lines) {
    const auto on = std::lower_bound(triangles.begin(), triangles.end(), line.triangle, comes_first);
    if (on == triangles.end() || on->triangle != line.triangle) continue;
    result.push_back({.on = static_cast<std::uint32_t>(on - triangles.begin()),
                      .other = none,
                      .ends = line.ends,
                      .into = {line.lit_side, Vec3d(0.0)}});
  }
  std::stable_sort(result.begin(), result.end(), comes_before);
  return result;
}

// Patches that lines of contacts may add in a scene of this many triangles.
std::size_t max_contact_patches(const PatchOptions& options, std::size_t triangles) {
  constexpr std::size_t per_triangle = 12, of_small_scenes = 200'000;
  return options.max_contacts > 0 ? options.max_contacts
                                  : std::max(per_triangle * triangles, of_small_scenes);
}

// Warns that some surfaces are not cut, since there are too many contacts; refuses them under a limit that
// was given. surfaces: "triangles" or "patches".
void leave_whole(std::size_t count, const char* surfaces, const PatchOptions& options,
                 const Context& context) {
  if (count == 0) return;
  if (options.max_contacts > 0) refuse_contacts(options.max_contacts);
  context.warn(fmt::format("there are too many contacts between surfaces, so {} {} with the "
                           "densest contacts are not cut: light may leak there",
                           count, surfaces),
               {{Setting::max_contacts}});
}

std::vector<ContactLine> lines_to_cut(const std::vector<CleanTriangle>& triangles,
                                      const std::vector<Vec3>& positions, const PatchOptions& options,
                                      double max_edge, const Context& context) {
  std::vector<ContactLine> lines;
  if (options.contacts) {
    const auto max_lines = max_contact_lines(options, triangles.size());
    lines = find_contact_lines(triangles, positions, options.contact_gap, max_lines, context);
    merge_into(lines, outlines_near(triangles, positions, options, max_edge, context));
    if (options.max_contacts == 0) {
      const auto max_added = static_cast<double>(max_contact_patches(options, triangles.size()));
      leave_whole(leave_out_dense_lines(lines, triangles, positions, max_edge, max_added), "triangles",
                  options, context);
    }
  }
  if (!options.shadow_lines.empty()) merge_into(lines, shadow_edges(triangles, options.shadow_lines));
  return lines;
}

// Returns the numbers of the contact lines on a triangle; lines are sorted by triangle.
std::vector<std::uint32_t> lines_on(std::span<const ContactLine> lines, std::uint32_t triangle) {
  const auto comes_before = [](const ContactLine& line, std::uint32_t t) { return line.on < t; };
  const auto first = std::lower_bound(lines.begin(), lines.end(), triangle, comes_before);
  std::vector<std::uint32_t> numbers;
  for (auto line = first; line != lines.end() && line->on == triangle; ++line)
    numbers.push_back(static_cast<std::uint32_t>(line - lines.begin()));
  return numbers;
}

void say_what_was_cut(std::span<const ContactLine> lines, std::size_t before, const PatchSet& patches,
                      const Context& context) {
  if (!context.log()) return;
  std::size_t surfaces = 0, shadows = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == 0 || lines[i].on != lines[i - 1].on) ++surfaces;
    if (lines[i].other == none) ++shadows;
  }
  const auto more = patches.size() - before;
  if (shadows == 0)
    context.note(fmt::format(
        "{} of the triangles are touched or pierced by others, along {} lines: cut along these into {} "
        "patches more",
        surfaces, lines.size(), more));
  else
    context.note(fmt::format(
        "{} of the triangles are cut along {} lines where others touch or pierce them, and along {} edges of "
        "shadows: {} patches more",
        surfaces, lines.size() - shadows, shadows, more));
}

}  // namespace

std::size_t max_contact_lines(const PatchOptions& options, std::size_t triangles) {
  // About 100 bytes each. Where a triangle has more lines in the mean, each ray passes as many triangles.
  constexpr std::size_t per_triangle = 64, in_memory = 4'000'000;
  const auto patches = max_contact_patches(options, triangles);
  return options.max_contacts > 0 ? patches
                                  : std::max(patches, std::min(per_triangle * triangles, in_memory));
}

void check_contacts(const Scene& scene, const PatchOptions& options, const Context& context) {
  if (!options.contacts) return;
  check_memory(scene);
  VertexWeld weld;
  const auto triangles = clean_triangles(scene, weld, context.quiet()).kept;
  find_contact_lines(triangles, weld.positions(), options.contact_gap,
                     max_contact_lines(options, triangles.size()), context);
}

float automatic_max_edge(const Scene& scene, std::size_t target_count) {
  const auto all = shapes(scene);
  // The target limits the patches that splitting adds: triangles that are already finer stay unchanged.
  return static_cast<float>(edge_for_count(all, static_cast<double>(all.size() + target_count)));
}

PatchSet make_patches(const Scene& scene, const PatchOptions& options, const Context& context) {
  check_memory(scene);
  PatchSet patches;
  set_bands(patches, scene);
  patches.scene_fingerprint = fingerprint(scene);
  patches.origin = scene.origin;
  patches.up = up_of_scene(scene);
  patches.cameras = scene.cameras;
  patches.panes = make_panes(scene);

  VertexWeld weld;
  const auto triangles = clean_triangles(scene, weld, context).kept;
  if (triangles.empty())
    throw InputError(scene.source,
                     "expected at least one triangle with area, found none: there is nothing to light");

  reserve(patches, triangles.size());
  const auto max_edge = chosen_edge(scene, options);
  const auto lines = lines_to_cut(triangles, weld.positions(), options, max_edge, context);
  const auto material = materials_of(triangles, scene, patches);
  const SizeField sizes(max_edge, lines, triangles, weld.positions());
  TriangleSplitter splitter(patches, weld, sizes, options.max_count);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto done = static_cast<double>(i) / static_cast<double>(triangles.size());
    if (i % triangles_per_report == 0 && context.report({.stage = "patches", .done = done}) == Next::stop)
      return {};
    const auto& t = triangles[i];
    const auto& p = weld.positions();
    const auto normal = triangle_normal(p[t.corners[0]], p[t.corners[1]], p[t.corners[2]]);
    splitter.add(t.corners, normal, t.triangle, material[i], lines, lines_on(lines, i));
  }
  if (!lines.empty()) {
    const auto before = patches.size();
    check_memory(patches, lines.size());
    constexpr std::size_t of_shadow_line = 20;  // they have a limit of their own, ShadowLineOptions
    const auto max_added =
        max_contact_patches(options, triangles.size()) + of_shadow_line * options.shadow_lines.size();
    const auto whole = cut_along_contacts(patches, weld, lines, splitter.lines_on_patches(), max_added);
    leave_whole(whole, "patches", options, context);
    if (patches.size() > options.max_count)
      throw with_hints(
          InputError(fmt::format("more than {} patches where surfaces touch: a longer edge is needed, or no "
                                 "cuts where surfaces touch",
                                 options.max_count)),
          {{Setting::max_edge}, {Setting::contacts, "off"}});
    say_what_was_cut(lines, before, patches, context);
  }
  if (options.contacts) {
    const auto overlaps = find_overlaps(triangles, material, patches.materials, weld.positions(), context);
    if (const auto removed = remove_covered(patches, overlaps, triangles, weld.positions()); removed > 0)
      context.note(fmt::format(
          "{} patches are left out, since smaller surfaces lie on them in the same plane", removed));
  }
  patches.vertices = weld.take();
  lay_textures(patches, scene, options.plain_reflectance, context);
  return patches;
}

}  // namespace luxel
