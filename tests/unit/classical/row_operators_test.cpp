// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include "luxel/classical/dense_operator.h"
#include "luxel/classical/hemicube_operator.h"
#include "luxel/classical/lines_operator.h"
#include "luxel/patch/make_patches.h"
#include "luxel/trace/patch_emitter.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A lit floor, one-sided, under a two-sided sheet; beside them a one-sided plate that shows the floor its
// back.
PatchSet scene() {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 1.0f, false).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("sheet", 0.5f, 0.0f).quad({0, 0, 0.5f}, {0.5f, 0, 0.5f}, {0.5f, 1, 0.5f}, {0, 1, 0.5f});
  b.material("turned", 0.5f, 0.0f, false).quad({0.5f, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0.5f, 1, 1});
  return make_patches(b.scene(), {.max_edge = 0.5f});
}

struct Made {
  explicit Made(PatchSet set) : patches(std::move(set)) {}

  PatchSet patches;
  Context context;
  Tracer tracer{patches, context};
  std::optional<DenseOperator> dense = DenseOperator::make(patches, tracer, {}, context);
  std::optional<HemicubeOperator> hemicube =
      HemicubeOperator::make(patches, {.resolution = 64, .points = 4}, context);
  std::optional<LinesOperator> lines = LinesOperator::make(patches, tracer, {.lines = 4096}, context);

  std::vector<const RowOperator*> all() const { return {&*dense, &*hemicube, &*lines}; }
};

const Made& made() {
  static const Made all(scene());
  return all;
}

TEST(RowOperators, elements_are_the_sides_that_gather) {
  std::size_t two_sided = 0;
  for (std::size_t p = 0; p < made().patches.size(); ++p)
    two_sided += made().patches.material_of(p).two_sided ? 1 : 0;
  for (const auto* transport : made().all()) {
    EXPECT_EQ(transport->size(), made().patches.size() + two_sided);
    EXPECT_EQ(transport->bands(), 3u);
    EXPECT_EQ(transport->row_begins().front(), 0u);
    EXPECT_EQ(transport->row_begins().back(), transport->size());
  }
}

TEST(RowOperators, rows_and_losses_sum_to_one) {
  for (const auto* transport : made().all())
    transport->for_rows(0, transport->size(),
                        [&](std::size_t receiver, std::span<const RowOperator::Factor> row) {
                          double sum = transport->losses().escaped[receiver];
                          for (const auto& factor : row) sum += static_cast<double>(factor.fraction);
                          for (std::size_t m = 0; m < 3; ++m)
                            sum += transport->losses().at_backs[receiver * 3 + m];
                          EXPECT_NEAR(sum, 1.0, 1e-5) << receiver;
                        });
}

// Two unit squares, a metre apart, the upper one turned away: the closed form of opposed squares.
TEST(RowOperators, what_meets_a_black_back_is_lost_there) {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 1.0f, false).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("turned", 0.5f, 0.0f, false).quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  const Made plates(make_patches(b.scene(), {.max_edge = 0.5f}));
  for (const auto* transport : plates.all()) {
    double lost = 0.0;
    for (std::size_t receiver = 0; receiver < transport->size(); ++receiver) {
      const auto patch = transport->sides().side[receiver].patch();
      lost +=
          static_cast<double>(plates.patches.area[patch]) * transport->losses().at_backs[receiver * 2 + 1];
      EXPECT_EQ(transport->losses().at_backs[receiver * 2], 0.0) << "the floor's back is turned from all";
    }
    const bool is_dense = transport == plates.all().front();
    EXPECT_NEAR(lost, 0.19982489569838746, is_dense ? 1e-7 : 0.01);
  }
}

TEST(RowOperators, apply_is_the_product_with_the_rows) {
  for (const auto* transport : made().all()) {
    const auto n = transport->size();
    std::vector<float> radiosity(3 * n), irradiance(3 * n, -1.0f);
    for (std::size_t i = 0; i < radiosity.size(); ++i) radiosity[i] = static_cast<float>(i % 7);
    const std::size_t end = transport->row_begins()[1];
    transport->apply(radiosity, irradiance, 0, end, made().context);
    transport->for_rows(0, n, [&](std::size_t receiver, std::span<const RowOperator::Factor> row) {
      double sum = 0.0;
      for (const auto& factor : row)
        sum += static_cast<double>(factor.fraction) * static_cast<double>(radiosity[3 * factor.receiver + 1]);
      EXPECT_EQ(irradiance[3 * receiver + 1], receiver < end ? static_cast<float>(sum) : -1.0f) << receiver;
    });
  }
}

TEST(RowOperators, dense_is_reciprocal_and_the_others_come_near_it) {
  const auto& dense = *made().dense;
  const auto n = dense.size();
  const auto area = [&](std::size_t receiver) {
    return static_cast<double>(made().patches.area[dense.sides().side[receiver].patch()]);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      EXPECT_NEAR(area(i) * static_cast<double>(dense.factors()[i * n + j]),
                  area(j) * static_cast<double>(dense.factors()[j * n + i]), 1e-8);
  for (const auto* transport : {made().all()[1], made().all()[2]})
    transport->for_rows(0, n, [&](std::size_t receiver, std::span<const RowOperator::Factor> row) {
      for (const auto& factor : row)
        EXPECT_NEAR(factor.fraction, dense.factors()[receiver * n + factor.receiver], 0.04) << receiver;
    });
}

TEST(RowOperators, joined_faces_receive_alike_and_no_power_is_lost) {
  auto dense = *made().dense;
  const auto n = dense.size();
  std::vector<std::uint32_t> face;  // one for each material
  for (const auto material : made().patches.material) face.push_back(static_cast<std::uint32_t>(material));
  dense.join_faces(face);
  std::vector<double> power(n, 0.0), power_before(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const auto side = dense.sides().side[i];
      const double area = made().patches.area[side.patch()];
      power[j] += area * static_cast<double>(dense.factors()[i * n + j]);
      power_before[j] += area * static_cast<double>(made().dense->factors()[i * n + j]);
      for (std::size_t k = 0; k < n; ++k) {
        const auto other = dense.sides().side[k];
        if (face[side.patch()] == face[other.patch()] && side.is_back() == other.is_back()) {
          EXPECT_EQ(dense.factors()[i * n + j], dense.factors()[k * n + j]);
        }
      }
    }
  for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(power[j], power_before[j], 1e-6);
}

TEST(RowOperators, are_not_made_where_the_monitor_says_stop) {
  const auto stop = [](const Progress& p) {
    EXPECT_EQ(p.stage, "factors");
    return Next::stop;
  };
  const auto& m = made();
  EXPECT_FALSE(DenseOperator::make(m.patches, m.tracer, {}, m.context.with_monitor(stop)));
  EXPECT_FALSE(HemicubeOperator::make(m.patches, {}, m.context.with_monitor(stop)));
  EXPECT_FALSE(LinesOperator::make(m.patches, m.tracer, {}, m.context.with_monitor(stop)));
}

}  // namespace
}  // namespace luxel
