// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

/// Kind of an element: all triangles of a group (OBJ g or o, whichever was last), of an object (OBJ o) or of
/// a material; or a single patch.
enum class Between { groups, objects, materials, patches };

/// Which sides of patches are (parts of) elements: fronts; or fronts, and the backs of two-sided materials as
/// elements of their own.
enum class ElementSides { front, both };

/// The surfaces between which view factors are computed. Front elements stand first, in the order of the
/// scene (patches: of the patch set), then the backs in the same order; those without a patch are left out.
struct ViewElements {
  Between kind = Between::groups;
  std::vector<std::string> name;       ///< patches: their number; backs: with ":back"
  std::vector<double> area;            ///< m², above 0
  std::vector<std::uint32_t> of_side;  ///< [2 * patches]: the element of front 2p and back 2p + 1, or none
  std::vector<std::uint32_t> first_patch;  ///< [element]: the lowest patch of it

  std::size_t size() const { return name.size(); }
};

/// Throws InputError where objects are requested but the scene names none. patches: of this scene.
ViewElements make_view_elements(const Scene& scene, const PatchSet& patches, Between kind,
                                ElementSides sides);

}  // namespace luxel
