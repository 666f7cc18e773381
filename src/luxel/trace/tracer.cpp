// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/tracer.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/unit_vector.h"

namespace luxel {
namespace {

// AVX2 at most: as fast as AVX-512 here, and bitwise equal on all hosts. A host without AVX2 works too.
constexpr const char* device_config = "max_isa=avx2";

void throw_on_error(RTCDevice device, const char* what) {
  const auto error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  const auto failed = std::string("Embree ") + what + " failed: ";
  if (error == RTC_ERROR_OUT_OF_MEMORY)
    throw with_hints(DeviceError(failed + "out of memory; fewer patches are needed"), {{Setting::max_edge}});
  throw DeviceError(failed + "error " + std::to_string(static_cast<int>(error)));
}

void check_memory(std::size_t patches) {
  constexpr double bytes_per_patch = 200.0;  // while the hierarchy is built
  const auto lack = lack_of_memory(bytes_per_patch * static_cast<double>(patches));
  if (lack.empty()) return;
  throw with_hints(InputError(fmt::format("tracing rays through {} patches needs about {}: a longer edge is "
                                          "needed",
                                          patches, lack)),
                   {{Setting::max_edge}});
}

// The holes of one patch.
struct Holes {
  TextureUse use;
  std::shared_ptr<const Raster> raster;
  float threshold = 0.5f;
  std::array<Vec2, 3> uv;

  bool is_hole(float u, float v) const {
    const auto place = use.place((1.0f - u - v) * uv[0] + u * uv[1] + v * uv[2]);
    return raster->alpha(pixel_at(*raster, use, place)) < threshold;
  }
};

// A subset of the patches, as one Embree geometry.
struct Part {
  std::vector<std::uint32_t> patch;  // [triangle]; released after attaching if it holds all patches
  std::vector<Holes> holes;          // [triangle], or none
};

// Materials are read only where there are holes: plain geometry may lack them.
std::array<Part, 2> parts_of(const PatchSet& patches) {
  std::array<Part, 2> parts;
  if (std::none_of(patches.materials.begin(), patches.materials.end(),
                   [](const BandMaterial& m) { return m.textures.cutout.has_value(); })) {
    parts[0].patch.resize(patches.size());
    std::iota(parts[0].patch.begin(), parts[0].patch.end(), 0u);
    return parts;
  }
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const auto& textures = patches.material_of(p).textures;
    const auto& cutout = textures.cutout;
    auto& part = parts[cutout ? 1 : 0];
    part.patch.push_back(p);
    if (cutout)
      part.holes.push_back({*cutout, patches.textures[cutout->texture].raster, textures.cutout_threshold,
                            patches.uv_sets[cutout->uv_set][p]});
  }
  return parts;
}

// Lets a ray continue through holes. Embree calls it for each triangle on the way, in any order.
void pass_holes(const RTCFilterFunctionNArguments* asked) {
  const auto& part = *static_cast<const Part*>(asked->geometryUserPtr);
  for (unsigned i = 0; i < asked->N; ++i) {
    if (asked->valid[i] != -1) continue;
    const auto triangle = RTCHitN_primID(asked->hit, asked->N, i);
    if (part.holes[triangle].is_hole(RTCHitN_u(asked->hit, asked->N, i), RTCHitN_v(asked->hit, asked->N, i)))
      asked->valid[i] = 0;
  }
}

void attach(RTCDevice device, RTCScene scene, const PatchSet& patches, Part& part, unsigned number) {
  if (part.patch.empty()) return;
  const auto geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<Vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), patches.vertices.size()));
  auto* indices = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(patches.corners[0]), part.patch.size()));
  if (vertices && indices) {
    std::copy(patches.vertices.begin(), patches.vertices.end(), vertices);
    for (std::size_t i = 0; i < part.patch.size(); ++i) indices[i] = patches.corners[part.patch[i]];
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    if (!part.holes.empty()) {
      rtcSetGeometryUserData(geometry, &part);
      rtcSetGeometryIntersectFilterFunction(geometry, pass_holes);
      rtcSetGeometryOccludedFilterFunction(geometry, pass_holes);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, number);
  }
  rtcReleaseGeometry(geometry);
  throw_on_error(device, "geometry");
}

}  // namespace

struct Tracer::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::array<Part, 2> parts;  // patches without holes, and with them

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

Tracer::Tracer(const PatchSet& patches, const Context& context) : state_(std::make_unique<State>()) {
  check_memory(patches.size());
  state_->device = rtcNewDevice(device_config);
  if (!state_->device) {
    if (rtcGetDeviceError(nullptr) == RTC_ERROR_OUT_OF_MEMORY)
      throw DeviceError("Embree could not start: the limit on the memory of this process is too low");
    throw DeviceError("Embree could not start on this processor");
  }
  state_->scene = rtcNewScene(state_->device);
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(state_->scene, RTC_BUILD_QUALITY_HIGH);
  state_->parts = parts_of(patches);
  for (unsigned i = 0; i < 2; ++i) attach(state_->device, state_->scene, patches, state_->parts[i], i);
  if (state_->parts[1].patch.empty()) state_->parts[0].patch = {};
  context.run([this] { rtcJoinCommitScene(state_->scene); });
  throw_on_error(state_->device, "build of the hierarchy");
}

Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

namespace {

void set_ray(RTCRay& out, const Ray& ray, float max_distance) {
  out.org_x = ray.origin.x;
  out.org_y = ray.origin.y;
  out.org_z = ray.origin.z;
  out.dir_x = ray.direction.x;
  out.dir_y = ray.direction.y;
  out.dir_z = ray.direction.z;
  out.tnear = 0.0f;
  out.tfar = max_distance;
  out.time = 0.0f;
  out.mask = 0xffffffffu;
  out.id = 0;
  out.flags = 0;
}

}  // namespace

Hit Tracer::nearest(const Ray& ray) const {
  assert(is_unit(ray.direction));
  RTCRayHit query;
  set_ray(query.ray, ray, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(state_->scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(state_->scene, &context, &query);
#endif
  Hit hit;
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
  const auto& numbers = state_->parts[query.hit.geomID].patch;
  hit.patch = numbers.empty() ? query.hit.primID : numbers[query.hit.primID];
  // Embree's normal of a triangle with counter-clockwise corners points to the front, like Luxel's.
  hit.back = glm::dot(ray.direction, Vec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z)) > 0.0f;
  hit.distance = query.ray.tfar;
  hit.u = query.hit.u;
  hit.v = query.hit.v;
  return hit;
}

void Tracer::nearest(std::span<const Ray> rays, std::span<Hit> hits) const {
  assert(hits.size() == rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = nearest(rays[i]);
}

bool Tracer::occluded(const Ray& ray, float max_distance) const {
  assert(is_unit(ray.direction) && max_distance >= 0.0f);
  RTCRay query;
  set_ray(query, ray, max_distance);
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(state_->scene, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(state_->scene, &context, &query);
#endif
  return query.tfar < 0.0f;
}

float origin_lift(const std::array<Vec3, 3>& points) {
  // With M the largest coordinate and eps = 2^-24: computing the point from its corners errs by at most 5 eps
  // M per coordinate, a neighbour's split vertex by eps M, the lifted sum by eps M; sqrt(3) for the diagonal
  // makes 12 eps M. The sign of the intersection's distance is that of a dot product of three terms over
  // vectors no longer than 2 sqrt(3) M: 4 eps times that is 14 eps M. Together 26, rounded up to a power of
  // two.
  const auto largest = glm::max(glm::max(glm::abs(points[0]), glm::abs(points[1])), glm::abs(points[2]));
  return 0x1p-19f * std::max({largest.x, largest.y, largest.z});
}

}  // namespace luxel
