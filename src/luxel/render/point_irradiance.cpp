// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/point_irradiance.h"

#include "luxel/core/address.h"
#include "luxel/render/batch_means.h"
#include "luxel/render/light_paths.h"
#include "luxel/render/strata.h"

namespace luxel {
namespace {

enum Name : std::uint32_t { direction, lamp_place, lamp_choice };  // of strata

}  // namespace

std::vector<double> irradiance_at(const PatchSet& patches, const Tracer& tracer,
                                  std::span<const SurfacePoint> points, std::uint64_t paths,
                                  std::uint64_t seed, const Context& context) {
  const auto bands = patches.band_count();
  const LightPaths light(patches, tracer);
  const auto batches = (paths + BatchMeans::batch_paths - 1) / BatchMeans::batch_paths;
  std::vector<double> irradiance(points.size() * bands, 0.0);
  context.for_chunks(points.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    std::vector<double> weight(bands);
    for (auto p = begin; p < end; ++p) {
      const auto sum = std::span(irradiance).subspan(p * bands, bands);
      const auto point_key = stream_key(seed, RandomPurpose::traced_points, static_cast<std::uint32_t>(p));
      for (std::uint64_t batch = 0; batch < batches; ++batch) {
        const auto key = nth_key(point_key, batch);
        constexpr auto cells = BatchMeans::batch_side;
        const Strata directions(key, direction, cells), lamps(key, lamp_place, cells),
            choices(key, lamp_choice, cells);
        for (std::uint32_t i = 0; i < BatchMeans::batch_paths; ++i) {
          const auto of_path = path_key(key, i);
          const auto u = uniform4(of_path, ~std::uint64_t{0});
          const auto v = uniform4(of_path, ~std::uint64_t{1});
          const auto out = directions.pair(i, u[0], u[1]);
          const auto on_lamp = lamps.pair(i, u[2], u[3]);
          const VertexNumbers first{{out.x, out.y}, {choices.number(i, v[0]), on_lamp.x, on_lamp.y}};
          light.irradiance(points[p], first, of_path, BouncesFrom::points, weight, sum);
        }
      }
      for (auto& h : sum) h /= static_cast<double>(batches * BatchMeans::batch_paths);
    }
  });
  return irradiance;
}

}  // namespace luxel
