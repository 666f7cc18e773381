// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/hidden_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr float same_plane = 0.9f;  // cosine between normals

// Irradiance below which a side counts as hidden, over the mean of all sides, and over that of the brightest
// side at the vertex: a few rays slip past the edge on which one solid stands on another, more where a gap of
// a millimetre is left between them.
constexpr double dark = 1e-3, dark_here = 5e-3;

double sum_of(const Solution& solution, std::size_t patch, bool back, std::size_t bands) {
  const auto* values = &solution.irradiance.of(back)[patch * bands];
  return std::accumulate(values, values + bands, 0.0);
}

// [side][smooth vertex]: the greatest irradiance of the sides that use it, summed over bands; below 0: none
// does.
FrontAndBack<double> brightest_at(const PatchSet& patches, const Solution& solution,
                                  const SmoothLight& light) {
  FrontAndBack<double> brightest;
  for (const bool back : {false, true}) {
    auto& at = brightest.of(back);
    at.assign(light.size(), -1.0);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (back && !patches.material_of(p).two_sided) continue;
      const auto own = sum_of(solution, p, back, patches.band_count());
      for (const auto corner : light.corners[p]) at[corner] = std::max(at[corner], own);
    }
  }
  return brightest;
}

// [vertex]: whether another surface passes through its patches there, with vertices of its own.
std::vector<std::uint8_t> pierced_vertices(const PatchSet& patches) {
  std::vector<std::uint8_t> is_pierced(patches.vertices.size(), 0);
  const auto& contacts = patches.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (auto j = i + 1; j < contacts.size() && contacts[j].edge == contacts[i].edge; ++j)
      if (glm::dot(contacts[i].into, contacts[j].into) < -same_plane)
        for (const auto v : contacts[i].edge) is_pierced[v] = 1;
  return is_pierced;
}

// The mean of some values of several bands.
class MeanValue {
 public:
  explicit MeanValue(std::size_t bands) : sum_(bands, 0.0) {}
  bool is_empty() const { return count_ == 0; }
  void add(const float* value) {
    for (auto& s : sum_) s += static_cast<double>(*value++);
    ++count_;
  }
  void write(float* value) const {
    for (const auto s : sum_) *value++ = static_cast<float>(s / count_);
  }

 private:
  std::vector<double> sum_;
  int count_ = 0;
};

}  // namespace

double hidden_irradiance(const PatchSet& patches, const Solution& solution) {
  double sum = 0.0, area = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const bool back : {false, true}) {
      const auto irradiance = sum_of(solution, p, back, patches.band_count());
      if (!(irradiance > 0.0)) continue;
      sum += static_cast<double>(patches.area[p]) * irradiance;
      area += static_cast<double>(patches.area[p]);
    }
  return area > 0.0 ? dark * sum / area : 0.0;
}

void light_hidden_vertices(const PatchSet& patches, const Solution& solution, SmoothLight& light) {
  const auto bands = patches.band_count();
  const auto brightest = brightest_at(patches, solution, light);
  const auto dark_anywhere = hidden_irradiance(patches, solution);
  const auto is_pierced = pierced_vertices(patches);
  // Smooth vertices at one vertex follow each other.
  for (std::uint32_t first = 0, end = 0; first < light.size(); first = end) {
    while (end < light.size() && light.vertex[end] == light.vertex[first]) ++end;
    double of_vertex = 0.0;
    for (const bool back : {false, true})
      for (auto s = first; s < end; ++s) of_vertex = std::max(of_vertex, brightest.of(back)[s]);
    const auto least = std::max(dark_anywhere, dark_here * of_vertex);
    for (const bool back : {false, true})
      for (auto s = first; s < end; ++s) {
        if (brightest.of(back)[s] < 0.0 || brightest.of(back)[s] > least) continue;
        MeanValue in_plane(bands), around(bands);
        bool is_corner = is_pierced[light.vertex[first]] != 0;
        for (auto other = first; other < end; ++other) {
          const auto cosine = glm::dot(light.normal[s], light.normal[other]);
          is_corner |= std::abs(cosine) < same_plane;
          for (const bool side : {false, true}) {
            if (!(brightest.of(side)[other] > least)) continue;
            const auto* value = &light.irradiance.of(side)[other * bands];
            around.add(value);
            // A surface with the opposite winding continues with its back.
            if (std::abs(cosine) >= same_plane && side == (back != (cosine < 0.0f))) in_plane.add(value);
          }
        }
        // Where no other surface is, the edge is that of a shadow.
        if (around.is_empty() || !is_corner) continue;
        (in_plane.is_empty() ? around : in_plane).write(&light.irradiance.of(back)[s * bands]);
      }
  }
}

}  // namespace luxel
