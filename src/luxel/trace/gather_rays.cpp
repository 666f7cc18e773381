// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/gather_rays.h"

#include <bit>

#include "luxel/core/address.h"
#include "luxel/core/sobol.h"
#include "luxel/core/warp.h"
#include "luxel/core/wide.h"

namespace luxel {
namespace {

// Dimensions for the point on the patch (two) and the direction (two): directions have more influence, and
// the first two dimensions are the best.
constexpr std::array<int, 4> dimension = {2, 3, 0, 1};

LUXEL_WIDE void sobol_numbers(const std::uint32_t* __restrict raw, std::uint32_t more, std::uint32_t seed,
                              std::size_t count, float* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = OwenSobol::number(raw[i] ^ more, seed);
}

// Maps four uniform numbers to corner weights and a direction, and to its cell, in boustrophedon order of
// rows.
LUXEL_WIDE void warp_weights(float* __restrict a, float* __restrict b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto weights = uniform_triangle(a[i], b[i]);
    a[i] = weights.x;
    b[i] = weights.y;
  }
}

LUXEL_WIDE void warp_directions(float* __restrict x, float* __restrict y, float* __restrict z,
                                std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto local = cosine_hemisphere(x[i], y[i]);
    x[i] = local.x;
    y[i] = local.y;
    z[i] = local.z;
  }
}

// Cells of two numbers, 16 per row, in boustrophedon order: along one row and back along the next.
LUXEL_WIDE void find_cells(const float* __restrict x, const float* __restrict y,
                           std::uint8_t* __restrict cell, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<std::int32_t>(x[i] * 16.0f);
    const auto column = static_cast<std::int32_t>(y[i] * 16.0f);
    cell[i] = static_cast<std::uint8_t>(16 * row + (column ^ (15 * (row & 1))));
  }
}

}  // namespace

GatherRays::GatherRays(const PatchSet& patches, const GatherSides& sides,
                       std::span<const std::uint32_t> receivers, const GatherPoints& points,
                       std::uint32_t level, std::uint32_t per_receiver)
    : sides_(sides),
      receivers_(receivers),
      points_(points),
      level_(level),
      per_receiver_(per_receiver),
      shift_(std::countr_zero(std::bit_ceil(receivers.size()))) {
  emitters_.reserve(receivers.size());
  for (const auto s : receivers) emitters_.emplace_back(patches, sides.side[s]);
  for (std::size_t i = 0; i < 4; ++i)
    for (const auto s : receivers)
      raw_[i].push_back(OwenSobol::raw(sides.position[s] * per_receiver, dimension[i]));
}

std::uint64_t GatherRays::key_of(std::uint32_t replicate) const {
  const bool back = !receivers_.empty() && receivers_.front() >= sides_.fronts;
  return mix64(stream_key(points_.seed, RandomPurpose::gather_rays, 2 * replicate + (back ? 1 : 0)) + level_);
}

void GatherRays::make(std::span<const Row> rows) {
  const auto size = rows.size() << shift_;
  if (cell_.size() < size) {
    for (auto& n : numbers_) n.resize(size);
    height_.resize(size);
    cell_.resize(size);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) draw(rows[r], r << shift_);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto at = r << shift_;
    find_cells(&numbers_[2][at], &numbers_[3][at], &cell_[at], receivers_.size());
    warp_weights(&numbers_[0][at], &numbers_[1][at], receivers_.size());
    warp_directions(&numbers_[2][at], &numbers_[3][at], &height_[at], receivers_.size());
  }
  sort(rows.size());
}

// Draws the four numbers of a ray: from one sequence per block of neighbouring sides with similar normals,
// from one per side, or plain random numbers.
void GatherRays::draw(const Row& row, std::size_t at) {
  const auto key = key_of(row.replicate);
  if (points_.low_discrepancy && points_.stratified) {
    for (std::size_t begin = 0, end = 0; begin < receivers_.size(); begin = end) {
      const auto block = sides_.position[receivers_[begin]] / sequence_positions;
      while (end < receivers_.size() && sides_.position[receivers_[end]] / sequence_positions == block) ++end;
      const OwenSobol sequence(stream_key(key, 0, block));
      for (std::size_t i = 0; i < 4; ++i)
        sobol_numbers(raw_[i].data() + begin, OwenSobol::raw(row.sample, dimension[i]),
                      sequence.seed(dimension[i]), end - begin, &numbers_[i][at + begin]);
    }
    return;
  }
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    const auto own = stream_key(key, 0, sides_.side[receivers_[i]].index());
    const auto u = points_.low_discrepancy ? OwenSobol(own).first4(row.sample) : uniform4(own, row.sample);
    for (std::size_t d = 0; d < 4; ++d) numbers_[d][at + i] = u[static_cast<std::size_t>(dimension[d])];
  }
}

void GatherRays::sort(std::size_t rows) {
  std::array<std::uint32_t, cells + 1> begin{};
  const auto for_each = [&](auto body) {
    for (std::size_t i = 0; i < receivers_.size(); ++i)
      for (std::size_t r = 0; r < rows; ++r) body((r << shift_) + i);
  };
  for_each([&](std::size_t id) { ++begin[cell_[id] + 1u]; });
  for (std::size_t c = 0; c < cells; ++c) begin[c + 1] += begin[c];
  order_.resize(rows * receivers_.size());
  for_each([&](std::size_t id) { order_[begin[cell_[id]]++] = static_cast<std::uint16_t>(id); });
}

}  // namespace luxel
