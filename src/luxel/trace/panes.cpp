// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/panes.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "luxel/core/bounds.h"
#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/scene/band_colours.h"
#include "luxel/scene/glass.h"

namespace luxel {
namespace {

#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
#else
using EmbreeContext = RTCIntersectContext;
#endif

constexpr std::size_t steps = 1024;        // of the table, over the cosine
constexpr std::size_t max_crossed = 64;    // panes on a ray that are sorted; others are skipped
constexpr float same_distance = 0x1p-18f;  // relative: two triangles of a sheet that meet in an edge
constexpr float box_margin = 0x1p-16f;     // of the box of all panes, relative to its largest coordinate
constexpr double even_weight = 0.1;        // of the weights of wavebands

struct Crossing {
  float distance;  // m
  std::uint32_t pane;
};

// The crossings of one ray, as Embree finds them.
struct Query : EmbreeContext {
  std::array<Crossing, max_crossed> crossed;
  std::size_t count = 0;
};

// Returns whether a ray may enter a box before max_distance; the box is larger than what it holds by more
// than rounding.
bool may_enter(const Bounds& box, const Ray& ray, float max_distance) {
  float enters = 0.0f, leaves = max_distance;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0.0f) {
      if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) return false;
      continue;
    }
    const auto a = (box.low[axis] - ray.origin[axis]) / ray.direction[axis];
    const auto b = (box.high[axis] - ray.origin[axis]) / ray.direction[axis];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return enters <= leaves;
}

// Notes each triangle on the way and lets the ray continue.
void note_crossing(const RTCFilterFunctionNArguments* asked) {
  auto& query = *static_cast<Query*>(asked->context);
  for (unsigned i = 0; i < asked->N; ++i) {
    if (asked->valid[i] != -1) continue;
    asked->valid[i] = 0;
    if (query.count < max_crossed)
      query.crossed[query.count++] = {RTCRayN_tfar(asked->ray, asked->N, i),
                                      RTCHitN_primID(asked->hit, asked->N, i)};
  }
}

}  // namespace

struct Panes::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Pane> panes;
  Bounds box;  // of the panes, m
  std::size_t bands = 0;
  std::vector<std::uint32_t> table_of;     // [material]: its table
  std::vector<std::vector<float>> tables;  // [table][step * bands + band]

  explicit State(const PatchSet& patches);
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  std::span<const Crossing> crossed(const Ray& ray, float max_distance, Query& query) const;
  void multiply(const Ray& ray, const Pane& pane, std::span<double> of_band) const;

 private:
  void tabulate(const PatchSet& patches);
};

Panes::State::State(const PatchSet& patches) : panes(patches.panes), bands(patches.band_count()) {
  tabulate(patches);
  // Not "high": with spatial splits a triangle could be met twice. AVX2 at most, as in the tracer.
  device = rtcNewDevice("max_isa=avx2,threads=1");
  if (!device) throw DeviceError("Embree could not start on this processor");
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  const auto geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<Vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), 3 * panes.size()));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), panes.size()));
  if (!vertices || !indices) throw DeviceError("Embree failed: out of memory for the panes of glass");
  for (const auto& pane : panes) {
    vertices = std::copy(pane.corner.begin(), pane.corner.end(), vertices);
    for (const auto& corner : pane.corner) box.add(corner);
  }
  const auto largest = glm::max(glm::abs(box.low), glm::abs(box.high));
  const auto margin = box_margin * std::max({largest.x, largest.y, largest.z});
  box.low -= Vec3(margin);
  box.high += Vec3(margin);
  std::iota(indices, indices + 3 * panes.size(), 0u);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
  rtcSetGeometryOccludedFilterFunction(geometry, note_crossing);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 0);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  if (const auto error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw DeviceError("Embree failed to build the panes of glass: error " +
                      std::to_string(static_cast<int>(error)));
}

void Panes::State::tabulate(const PatchSet& patches) {
  table_of.assign(patches.materials.size(), none);
  for (const auto& pane : panes) {
    const auto material = static_cast<std::size_t>(pane.material);
    if (table_of[material] != none) continue;
    table_of[material] = static_cast<std::uint32_t>(tables.size());
    auto& table = tables.emplace_back((steps + 1) * bands);
    const auto& at_normal = patches.materials[material].transmittance;
    for (std::size_t i = 0; i <= steps; ++i)
      for (std::size_t b = 0; b < bands; ++b)
        table[i * bands + b] = static_cast<float>(pane_transmittance(
            static_cast<double>(at_normal[b]), static_cast<double>(i) / static_cast<double>(steps)));
  }
}

// Sorted by distance, so that the product does not depend on the order of the hierarchy.
std::span<const Crossing> Panes::State::crossed(const Ray& ray, float max_distance, Query& query) const {
  RTCRay embree_ray{};
  embree_ray.org_x = ray.origin.x;
  embree_ray.org_y = ray.origin.y;
  embree_ray.org_z = ray.origin.z;
  embree_ray.dir_x = ray.direction.x;
  embree_ray.dir_y = ray.direction.y;
  embree_ray.dir_z = ray.direction.z;
  embree_ray.tfar = max_distance;
  embree_ray.mask = 0xffffffffu;
#if RTC_VERSION_MAJOR >= 4
  rtcInitRayQueryContext(&query);
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query;
  rtcOccluded1(scene, &embree_ray, &arguments);
#else
  rtcInitIntersectContext(&query);
  rtcOccluded1(scene, &query, &embree_ray);
#endif
  const auto begin = query.crossed.begin(), end = begin + static_cast<std::ptrdiff_t>(query.count);
  std::sort(begin, end, [](const Crossing& a, const Crossing& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.pane < b.pane;
  });
  // A ray through an edge meets both of its triangles.
  const auto is_same = [this](const Crossing& a, const Crossing& b) {
    const auto &p = panes[a.pane], &q = panes[b.pane];
    return b.distance - a.distance <= same_distance * b.distance && p.material == q.material &&
           p.exponent == q.exponent && p.axis == q.axis;
  };
  return {begin, std::unique(begin, end, is_same)};
}

void Panes::State::multiply(const Ray& ray, const Pane& pane, std::span<double> of_band) const {
  const auto& table = tables[table_of[static_cast<std::size_t>(pane.material)]];
  const auto at = std::min(1.0, std::fabs(glm::dot(Vec3d(ray.direction), Vec3d(pane.axis)))) * steps;
  const auto step = std::min(steps - 1, static_cast<std::size_t>(at));
  const auto part = at - static_cast<double>(step);
  const auto* low = &table[step * bands];
  for (std::size_t b = 0; b < bands; ++b) {
    const auto value =
        (1.0 - part) * static_cast<double>(low[b]) + part * static_cast<double>(low[bands + b]);
    of_band[b] *= pane.exponent == 1.0f ? value : std::sqrt(value);
  }
}

Panes::Panes(const PatchSet& patches) : bands_(patches.band_count()) {
  if (patches.panes.empty()) return;
  state_ = std::make_shared<const State>(patches);
  for (const auto& pane : patches.panes) {
    const auto& bands = patches.materials[static_cast<std::size_t>(pane.material)].transmittance;
    if (std::adjacent_find(bands.begin(), bands.end(), std::not_equal_to<>()) != bands.end())
      is_tinted_ = true;
  }
  weights_.assign(bands_, 1.0 / static_cast<double>(bands_));
  if (!patches.has_colours()) return;
  const auto colours = patches.colours();
  const bool is_spectral = !patches.wavebands.empty();
  for (std::size_t b = 0; b < bands_; ++b)
    weights_[b] = (is_spectral ? patches.wavebands[b].width : 1.0) *
                  static_cast<double>(luminance(Vec3(colours.of(b))));
  const auto sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  const auto even = is_spectral ? even_weight : 0.0;
  for (auto& weight : weights_) weight = (1.0 - even) * weight / sum + even / static_cast<double>(bands_);
}

std::span<const double> Panes::along(const Ray& ray, float max_distance) const {
  if (empty() || !may_enter(state_->box, ray, max_distance)) return {};
  Query query;
  const auto crossed = state_->crossed(ray, max_distance, query);
  if (crossed.empty()) return {};
  thread_local std::vector<double> of_band;
  of_band.assign(bands_, 1.0);
  for (const auto& crossing : crossed) state_->multiply(ray, state_->panes[crossing.pane], of_band);
  return of_band;
}

double Panes::luminous(std::span<const double> through) const {
  return through.empty() ? 1.0 : std::inner_product(through.begin(), through.end(), weights_.begin(), 0.0);
}

}  // namespace luxel
