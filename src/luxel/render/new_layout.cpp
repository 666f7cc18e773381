// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/new_layout.h"

#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {

LaidOut lay_out(const PatchSet& patches, const Solution& solution, const LightmapOptions& options,
                const Context& context) {
  const PackOptions pack{.texel = static_cast<float>(1.0 / texels_per_metre(patches, solution, options)),
                         .page_size = options.page_size,
                         .margin = options.margin};
  check_pack_options(patches, pack);
  LaidOut laid;
  laid.charts = make_charts(
      patches, solution,
      {.texel = pack.texel, .crease_angle = options.crease_angle, .max_texels = max_texels(pack)}, context);
  if (laid.charts.charts.empty()) return {};
  laid.atlas = pack_charts(patches, laid.charts, pack);
  return laid;
}

}  // namespace luxel
