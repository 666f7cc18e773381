// SPDX-License-Identifier: Apache-2.0
#include "bench/same_rays.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numeric>

#include <embree3/rtcore.h>

#include "luxel/classical/ray_plan.h"
#include "luxel/classical/shooting.h"
#include "luxel/core/address.h"
#include "luxel/lamps/side_power.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel::bench {
namespace {

// The rays of one shot, made from the same plan and the same addresses as transport makes them.
void append_shot(std::vector<Ray>& rays, const PatchSet& patches, const SidePower& leaving,
                 const ShootingOptions& options, const Context& context) {
  const double offset = uniform4({options.seed, options.step, 0xffffffffu, 0})[0];
  const auto plan = make_ray_plan(leaving, patches.band_count(), options.rays, offset, context);
  const auto batches = std::max<std::uint64_t>(1, (plan.rays + options.batch - 1) / options.batch);
  for (std::uint64_t j = 0; j < batches; ++j)
    for (auto ray = j; ray < plan.rays;) {
      const auto entry = plan.entry_of_ray(ray);
      const auto side = leaving.side[entry];
      const PatchEmitter emitter(patches, side);
      const auto key = stream_key(options.seed, options.step, side.index());
      for (; ray < plan.first_ray[entry + 1]; ray += batches)
        rays.push_back(emitter.ray(uniform4(key, ray - plan.first_ray[entry])));
    }
}

}  // namespace

std::vector<Ray> rays_of_solve(const PatchSet& patches, const Tracer& tracer,
                               const StochasticJacobiOptions& options, const Context& context) {
  const auto bands = patches.band_count();
  auto leaving = lamp_power(patches);
  const auto emitted = std::accumulate(leaving.watts.begin(), leaving.watts.end(), 0.0);
  std::vector<Ray> rays;
  double smoothing = 1.0;
  for (std::uint32_t step = 0; smoothing > options.tolerance; ++step) {
    const auto wanted = std::max(1.0, std::round(smoothing * static_cast<double>(options.rays)));
    const ShootingOptions shot{
        .rays = static_cast<std::uint64_t>(wanted), .seed = options.seed, .step = step};
    append_shot(rays, patches, leaving, shot, context);
    const auto arrival = shoot(patches, tracer, leaving, shot, context);
    leaving = {arrival.side, std::vector<double>(arrival.arrived.size())};
    for (std::size_t i = 0; i < leaving.watts.size(); ++i)
      leaving.watts[i] = patches.material_of(leaving.side[i / bands].patch()).reflectance[i % bands] *
                         arrival.scale.watts(arrival.arrived[i]);
    smoothing = std::accumulate(leaving.watts.begin(), leaving.watts.end(), 0.0) / emitted;
  }
  return rays;
}

BareEmbree::BareEmbree(const PatchSet& patches) {
  const auto device = rtcNewDevice("max_isa=avx2");
  const auto scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  const auto geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                      patches.vertices.size()),
              patches.vertices.data(), patches.vertices.size() * sizeof(Vec3));
  std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                      sizeof(patches.corners[0]), patches.size()),
              patches.corners.data(), patches.size() * sizeof(patches.corners[0]));
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  device_ = device;
  scene_ = scene;
}

BareEmbree::~BareEmbree() {
  rtcReleaseScene(static_cast<RTCScene>(scene_));
  rtcReleaseDevice(static_cast<RTCDevice>(device_));
}

std::uint64_t BareEmbree::trace(const std::vector<Ray>& rays, const Context& context) const {
  std::atomic<std::uint64_t> hits{0};
  context.for_chunks(rays.size(), 4096, [&](std::size_t begin, std::size_t end, int) {
    RTCIntersectContext query_context;
    rtcInitIntersectContext(&query_context);
    std::uint64_t mine = 0;
    for (auto i = begin; i < end; ++i) {
      const auto& r = rays[i];
      RTCRayHit query{};
      query.ray = {
          r.origin.x, r.origin.y,  r.origin.z, 0.0f, r.direction.x, r.direction.y, r.direction.z, 0.0f,
          INFINITY,   0xffffffffu, 0,          0};
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(static_cast<RTCScene>(scene_), &query_context, &query);
      mine += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    hits += mine;
  });
  return hits;
}

}  // namespace luxel::bench
