// SPDX-License-Identifier: Apache-2.0
#include "luxel/lightmap/make_lightmap.h"

#include <cmath>

#include <fmt/format.h>

#include "luxel/lightmap/dilate.h"
#include "luxel/lightmap/make_charts.h"
#include "luxel/lightmap/pack_charts.h"
#include "luxel/report/error.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

Lightmap make_lightmap(const PatchSet& patches, const Solution& solution, const Tracer* tracer,
                       const LightmapOptions& options, const Workers& workers, LightmapReport* report,
                       const Monitor& monitor) {
  if (!(options.texels_per_metre > 0.0) || !std::isfinite(options.texels_per_metre))
    throw InputError(
        fmt::format("the texels a metre must be more than 0, but they are {}", options.texels_per_metre));
  const PackOptions pack{.texel = static_cast<float>(1.0 / options.texels_per_metre),
                         .page_size = options.page_size,
                         .margin = options.margin};
  check_pack_options(patches, pack);
  const auto charts = make_charts(
      patches, solution,
      {.texel = pack.texel, .crease_angle = options.crease_angle, .most_texels = most_texels(pack)}, workers);
  const auto smooth = make_smooth_light(patches, solution, {.crease_angle = options.crease_angle}, workers);

  Lightmap lightmap;
  LightmapReport done;
  done.charts = charts.charts.size();
  lightmap.atlas = pack_charts(patches, charts, pack);
  done.texels = gather_texels(patches, solution, smooth, tracer, options.texels, workers, lightmap, monitor);
  done.seams = solve_seams(charts, lightmap);
  dilate(lightmap, options.margin);
  if (report) *report = done;
  return lightmap;
}

}  // namespace luxel
