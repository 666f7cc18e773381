// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

/// The directions below the horizon.
enum class LowerHalf : std::uint8_t {
  one,      ///< one patch: ground of even radiance
  mirrored  ///< rows as above the horizon: the lower half of a picture of the surroundings
};

/// The directions around a scene in patches, each of constant radiance: the ground, then Tregenza's 145
/// patches of the sky with each split into `subdivision` rows and columns, as Reinhart did: 144 subdivision²
/// + 1. With a subdivision of 0 the sky is one patch, from the horizon to the zenith.
///
/// The order is that of Radiance's gendaymtx: patch 0 is the ground; the rows begin at the horizon; in a row
/// the first patch is centred on north and azimuths grow to the east; the last patch is round the zenith.
/// With LowerHalf::mirrored the images of patches 1, 2, ... below the horizon follow, without a patch 0 of
/// any extent.
///
/// By default a single patch covers all directions. Immutable except for assignment; safe for any number of
/// threads.
class SkyPatches {
 public:
  SkyPatches() = default;
  /// subdivision: 0 to 16. zenith, north: unit, orthogonal, in the scene's axes.
  SkyPatches(int subdivision, const Vec3d& zenith, const Vec3d& north, LowerHalf lower = LowerHalf::one);

  std::size_t size() const { return row_begins_.empty() ? 1 : size_; }
  bool is_one() const { return row_begins_.empty(); }
  int subdivision() const { return subdivision_; }  ///< 0 also where all directions are one patch
  LowerHalf lower_half() const { return lower_; }
  const Vec3d& zenith() const { return zenith_; }
  const Vec3d& north() const { return north_; }
  /// Number of patches that are not below the horizon, the ground not counted; they begin at patch 1.
  std::size_t upper() const { return is_one() ? 1 : row_begins_.back(); }

  /// Returns the patch that contains a unit direction of the scene. Cost: 30 ns.
  std::size_t patch_of(const Vec3d& direction) const;
  /// Patches whose centres lie around a unit direction, with weights that add up to 1: bilinear between rows
  /// and columns. Above the horizon they are patches of the sky, below it those of the lower half. For
  /// pictures: the mean over a patch is only nearly the patch's own value.
  struct Weighted {
    std::size_t patch = 0;
    double weight = 0.0;
  };
  std::array<Weighted, 4> around(const Vec3d& direction) const;
  /// sr. 0 of a ground without extent.
  double solid_angle(std::size_t patch) const;
  /// A direction in the patch, unit, in the scene's axes; u uniform in [0, 1)² gives uniform solid angle.
  /// Patch 0, the ground, of LowerHalf::mirrored gives straight down.
  Vec3d direction(std::size_t patch, const std::array<double, 2>& u) const;
  /// Returns the direction at u = (0.5, 0.5).
  Vec3d centre(std::size_t patch) const { return direction(patch, {0.5, 0.5}); }
  /// Integral of the cosine to the zenith over a patch, sr: the irradiance of open ground by a patch of unit
  /// radiance; negative below the horizon.
  double projected_solid_angle(std::size_t patch) const;

  /// East, north and zenith are the axes: from the scene's axes, and back.
  Vec3d in_local_axes(const Vec3d& direction) const;
  Vec3d in_scene_axes(const Vec3d& local) const;

  bool operator==(const SkyPatches&) const = default;

 private:
  struct Place {
    bool is_below = false;
    std::size_t row = 0, column = 0, columns = 1;
  };
  Place place_of(std::size_t patch) const;

  int subdivision_ = 0;
  LowerHalf lower_ = LowerHalf::one;
  Vec3d zenith_ = Vec3d(0.0, 0.0, 1.0), north_ = Vec3d(0.0, 1.0, 0.0), east_ = Vec3d(1.0, 0.0, 0.0);
  std::vector<std::size_t> row_begins_;  // [row + 1], counted from 0 at the horizon
  std::vector<double> sine_;             // [row + 1]: of the elevation that the row begins at; the last is 1
  std::size_t size_ = 1;
};

}  // namespace luxel
