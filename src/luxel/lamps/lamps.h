// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// A triangle that shines from its front, evenly and by Lambert's law: a surface, or a portal of the sky.
struct LampTriangle {
  bool is_portal() const { return portal != none; }
  std::array<Vec3, 3> corner;   // m, counter-clockwise seen from the front
  Vec3d normal;                 // unit, front
  double area = 0.0;            // m²
  double longest_edge = 0.0;    // m
  double weight = 0.0;          // radiance summed over bands, W/(m² sr)
  bool has_holes = false;       // a cut-out texture: radiance is the mean over holes and surface
  std::uint32_t portal = none;  // the side of a portal (see Portals) that the sky shines through
  bool fan_goes_on = false;     // the next triangle is of the same polygon, between the same first corner and
                                // this one's third
};

// The lamps of a scene as they were before they were cut into patches and meshed: flat convex ones as a few
// large triangles, so that choices are few and their light has a closed form. Read-only after it was made;
// memory about 150 bytes per triangle and 4 a patch. Behind them stand the portals of the sky, where there is
// a sky: lamps of its radiance and of its light group, the last.
class Lamps {
 public:
  // Joins the patches of each emitting input triangle, where they fill it, and what join_lamps() can.
  explicit Lamps(const PatchSet& patches);

  std::span<const LampTriangle> triangles() const { return triangles_; }
  std::size_t size() const { return triangles_.size(); }
  std::size_t bands() const { return bands_; }
  std::size_t groups() const { return groups_; }
  // The triangle that a point of a patch is part of, or none.
  std::uint32_t lamp_at(std::size_t patch, const Vec3& point) const;
  // Returns the lamp of this side of a portal, or none.
  std::uint32_t lamp_of_portal(std::uint32_t portal_side) const {
    return portal_side < lamp_of_portal_.size() ? lamp_of_portal_[portal_side] : none;
  }
  // Radiance of one triangle's front, W/(m² sr), [band]; of a portal the sky's mean.
  std::span<const float> radiance(std::size_t triangle) const {
    return std::span(radiance_).subspan(triangle * bands_, bands_);
  }
  // Radiance of a patch of the sky minus that mean: [band], W/(m² sr); empty where the sky is even.
  std::span<const float> sky_difference(std::size_t sky_patch) const {
    return sky_difference_.empty() ? std::span<const float>()
                                   : std::span(sky_difference_).subspan(sky_patch * bands_, bands_);
  }
  // Its light group.
  std::size_t group(std::size_t triangle) const { return group_[triangle]; }
  // Returns whether all lamps have one colour: radiance = weight * colour, [band], up to the rounding of
  // floats.
  bool one_colour() const { return one_colour_; }
  std::span<const double> colour() const { return colour_; }

 private:
  void add(const std::array<Vec3, 3>& corner, std::span<const float> emittance, std::uint32_t group);
  void add_portals(const PatchSet& patches);

  std::vector<LampTriangle> triangles_;
  std::vector<std::uint32_t> lamp_of_patch_;   // the first of its polygon
  std::vector<std::uint32_t> lamp_of_portal_;  // [side of a portal]
  std::size_t bands_ = 0;
  std::size_t groups_ = 1;
  std::vector<float> radiance_;        // [triangle][band]
  std::vector<float> sky_difference_;  // [sky patch][band]
  std::vector<std::uint32_t> group_;   // [triangle]
  bool one_colour_ = true;
  std::vector<double> colour_;  // of the first lamp, sums to 1
};

}  // namespace luxel
