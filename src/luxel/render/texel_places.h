// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/side.h"
#include "luxel/render/lightmap.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {

// The point of a surface whose light a texel holds.
struct TexelPlace {
  SideId side;
  Vec2 weights{0.0f};  // barycentric, of the corners 1 and 2 of its patch
  Texel kind = Texel::empty;
};

// [page][texel]: for every texel that is read where a chart is looked up between texels, the point of
// that chart nearest to its middle, on a lit side if there is one. Each is therefore a point of the
// surface, not beyond its border nor behind another surface along that border. The same on any number
// of threads; about 0.1 us per texel and side that it touches. After the monitor's stop there are no
// pages.
//
// is_dark: [side], of no light at all, as a floor below a box: its darkness would be read beside the box.
// Empty: none is.
std::vector<std::vector<TexelPlace>> find_texel_places(const Atlas& atlas, const std::vector<bool>& is_dark,
                                                       const Context& context = {});

}  // namespace luxel
