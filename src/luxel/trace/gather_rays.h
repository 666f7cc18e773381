// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/trace/gather_sides.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {

// Neighbouring sides whose rays are traced together: those of one block of positions, and all fronts or all
// backs.
constexpr std::uint32_t gather_block_positions = 1024;

// Source of the points of gather rays.
struct GatherPoints {
  std::uint64_t seed = 1;
  bool low_discrepancy = true;  // Owen-scrambled Sobol points, else independent random numbers
  bool stratified = true;       // one sequence over neighbouring patches; else each side has its own
};

// Rays of the sides of one block or a few neighbouring ones, traced in the order of their directions. Rays of
// similar directions are adjacent and meet the same surfaces, so that the tracer finds its nodes in the
// cache. A ray does not depend on the order, nor on the other rays traced with it.
class GatherRays {
 public:
  static constexpr std::size_t max_rows = 16;   // traced together
  static constexpr std::size_t max_blocks = 4;  // traced together

  // Sample `sample` of each receiver, of one replicate; the element that the ray of receivers[i] meets goes
  // to to[i * per_receiver].
  struct Row {
    std::uint32_t replicate = 0, sample = 0;
    std::uint32_t* to = nullptr;
  };

  // The receivers, rising, lie in max_blocks blocks at most, all fronts or all backs. Each has per_receiver
  // rays per replicate, a power of two, in that level.
  GatherRays(const PatchSet& patches, const GatherSides& sides, std::span<const std::uint32_t> receivers,
             const GatherPoints& points, std::uint32_t level, std::uint32_t per_receiver);

  // element(hit, ray): the element that a hit counts as. rows: at most max_rows.
  template <typename Element>
  void trace(const Tracer& tracer, std::span<const Row> rows, Element element) {
    std::array<Hit, batch> hits;
    for_each_batch(rows, [&](std::span<const Ray> rays, std::span<const std::uint16_t> ids) {
      tracer.nearest(rays, std::span(hits.data(), rays.size()));
      for (std::size_t i = 0; i < rays.size(); ++i)
        rows[ids[i] >> shift_].to[per_receiver_ * place_of(ids[i])] = element(hits[i], rays[i]);
    });
  }

  // Calls body(rays, ids) for all rays of these rows, in the order of tracing.
  template <typename Body>
  void for_each_batch(std::span<const Row> rows, Body body) {
    make(rows);
    std::array<Ray, batch> rays;
    for (std::size_t from = 0; from < order_.size(); from += batch) {
      const auto ids =
          std::span<const std::uint16_t>(order_).subspan(from, std::min(batch, order_.size() - from));
      for (std::size_t i = 0; i < ids.size(); ++i) rays[i] = ray(ids[i]);
      body(std::span<const Ray>(rays.data(), ids.size()), ids);
    }
  }

 private:
  static constexpr std::size_t batch = 256;
  static constexpr std::size_t cells = 256;  // of directions

  // A ray's id is (row << shift_) + i: 16 bits hold max_rows rows of max_blocks blocks.
  std::size_t place_of(std::size_t id) const { return id & ((std::size_t{1} << shift_) - 1); }
  // The numbers of these rows, warped, and their order.
  void make(std::span<const Row> rows);
  void draw(const Row& row, std::size_t at);
  void sort(std::size_t rows);
  std::uint64_t key_of(std::uint32_t replicate) const;
  Ray ray(std::size_t id) const {
    return emitters_[place_of(id)].ray(Vec2{numbers_[0][id], numbers_[1][id]},
                                       Vec3{numbers_[2][id], numbers_[3][id], height_[id]});
  }

  const GatherSides& sides_;
  std::span<const std::uint32_t> receivers_;
  GatherPoints points_;
  std::uint32_t level_, per_receiver_;
  int shift_;
  std::vector<PatchEmitter> emitters_;             // [i]
  std::array<std::vector<std::uint32_t>, 4> raw_;  // [dimension][i], of the receiver's first sample
  std::array<std::vector<float>, 4> numbers_;      // [dimension][id]; then the warped ones
  std::vector<float> height_;                      // the direction's third coordinate
  std::vector<std::uint8_t> cell_;                 // [id], of the direction
  std::vector<std::uint16_t> order_;               // id, sorted by cell
};

}  // namespace luxel
