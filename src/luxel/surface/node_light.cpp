// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/node_light.h"

#include <algorithm>
#include <limits>

#include "luxel/patch/side.h"
#include "luxel/surface/needle_nodes.h"
#include "luxel/surface/side_slopes.h"

namespace luxel {
namespace {

constexpr std::size_t elements_per_chunk = 4096;
// Two sweeps with over-relaxation of 1.5 are as accurate as four plain ones; more sweeps amplify noise.
constexpr int sweeps = 2;
constexpr double reach = 1.5;

class NodeFit {
 public:
  NodeFit(const SideLight& light, const SideNodes& nodes, const SideSlopes& slopes,
          const NeedleNodes& needles, const Context& context)
      : light_(light),
        nodes_(nodes),
        slopes_(slopes),
        needles_(needles),
        context_(context),
        bands_(light.bands()),
        value_(nodes.size() * bands_, 0.0f),
        lack_(nodes.of_side.size() * bands_, 0.0f) {}

  void begin() {
    for_nodes([this](std::size_t node, std::vector<double>& mean) {
      mean_over_sides(node, mean, [this](const auto& at_node, std::size_t b) {
        return static_cast<double>(light_.at(at_node.side)[b]) + rise_at(at_node, b);
      });
      for (std::size_t b = 0; b < bands_; ++b) value_[node * bands_ + b] = static_cast<float>(mean[b]);
    });
  }

  void sweep() {
    context_.for_chunks(nodes_.of_side.size(), elements_per_chunk,
                        [this](std::size_t first, std::size_t last, int) {
                          for (auto i = first; i < last; ++i) find_lack(SideId::at(i));
                        });
    for_nodes([this](std::size_t node, std::vector<double>& mean) {
      mean_over_sides(node, mean, [this](const auto& at_node, std::size_t b) {
        return static_cast<double>(lack_[at_node.side.index() * bands_ + b]);
      });
      for (std::size_t b = 0; b < bands_; ++b)
        value_[node * bands_ + b] += static_cast<float>(reach * mean[b]);
    });
  }

  void limit() {
    for_nodes([this](std::size_t node, std::vector<double>&) {
      for (std::size_t b = 0; b < bands_; ++b) {
        auto low = std::numeric_limits<double>::infinity(), high = 0.0;
        for_sides(node, [&](const auto& at_node, double) {
          const auto mean = static_cast<double>(light_.at(at_node.side)[b]);
          const auto here = mean + rise_at(at_node, b);
          low = std::max(0.0, std::min({low, mean, here}));
          high = std::max({high, mean, here});
        });
        auto& value = value_[node * bands_ + b];
        value = static_cast<float>(std::clamp(static_cast<double>(value), std::min(low, high), high));
      }
    });
  }

  std::vector<float> take() { return std::move(value_); }

 private:
  // body(node, scratch of one number per band)
  template <typename Body>
  void for_nodes(Body body) {
    context_.for_chunks(nodes_.size(), elements_per_chunk, [&](std::size_t first, std::size_t last, int) {
      std::vector<double> scratch(bands_);
      for (auto node = first; node < last; ++node) body(node, scratch);
    });
  }

  // body(at_node, weight) for the sides with a weight: members of the node, and far ones.
  template <typename Body>
  void for_sides(std::size_t node, Body body) const {
    const auto visit = [&](const auto& at_node) {
      if (const auto weight = light_.weight(at_node.side); weight > 0.0) body(at_node, weight);
    };
    for (const auto& m : nodes_.at(node)) visit(m);
    for (const auto& f : needles_.at(static_cast<std::uint32_t>(node))) visit(f);
  }

  // The mean weighted by area; unchanged from 0 where no side has a weight.
  template <typename Value>
  void mean_over_sides(std::size_t node, std::vector<double>& mean, Value value) const {
    std::fill(mean.begin(), mean.end(), 0.0);
    double whole = 0.0;
    for_sides(node, [&](const auto& at_node, double weight) {
      whole += weight;
      for (std::size_t b = 0; b < bands_; ++b) mean[b] += weight * value(at_node, b);
    });
    if (whole > 0.0)
      for (auto& x : mean) x /= whole;
  }

  // The side's linear function at the node, minus the side's mean.
  double rise_at(const NeedleNodes::FarSide& far, std::size_t b) const {
    double sum = 0.0;
    for (std::uint32_t k = 0; k < 3; ++k)
      sum += far.weights[static_cast<int>(k)] * slopes_.rise(far.side, k, b);
    return sum;
  }
  double rise_at(const SideNodes::Member& m, std::size_t b) const {
    if (m.place < 3) return slopes_.rise(m.side, m.place, b);
    const auto& h = nodes_.hanging[m.place - 3];
    const auto fraction = static_cast<double>(h.fraction);
    return (1.0 - fraction) * slopes_.rise(m.side, h.edge, b) +
           fraction * slopes_.rise(m.side, (h.edge + 1) % 3, b);
  }

  void find_lack(SideId side) {
    if (!(light_.weight(side) > 0.0)) return;
    const auto& corners = nodes_.of_side[side.index()];
    for (std::size_t b = 0; b < bands_; ++b) {
      double sum = 0.0;
      for (const auto node : corners) sum += static_cast<double>(value_[node * bands_ + b]);
      lack_[side.index() * bands_ + b] =
          static_cast<float>(static_cast<double>(light_.at(side)[b]) - sum / 3.0);
    }
  }

  const SideLight& light_;
  const SideNodes& nodes_;
  const SideSlopes& slopes_;
  const NeedleNodes& needles_;
  const Context& context_;
  std::size_t bands_;
  std::vector<float> value_;  // [node][band]
  std::vector<float> lack_;   // [side][band]: its value minus the mean of its interpolated light
};

void close_seams(const PatchSet& patches, const SideNodes& nodes, std::size_t bands,
                 std::vector<float>& value) {
  const auto hangs = [&](std::uint32_t vertex) {
    const auto found = std::lower_bound(nodes.hanging.begin(), nodes.hanging.end(), vertex,
                                        [](const HangingVertex& h, std::uint32_t v) { return h.vertex < v; });
    return found != nodes.hanging.end() && found->vertex == vertex;
  };
  for (const auto& visit : nodes.visits)
    for (const auto& m : nodes.at(visit.node)) {
      if (m.side != visit.side || m.place < 3) continue;
      const auto& h = nodes.hanging[m.place - 3];
      const auto from = h.edge, to = (h.edge + 1) % 3;
      if (hangs(patches.corners[h.patch][from]) || hangs(patches.corners[h.patch][to])) continue;
      const auto a = nodes.of_side[m.side.index()][from] * bands,
                 b = nodes.of_side[m.side.index()][to] * bands;
      for (std::size_t i = 0; i < bands; ++i)
        value[visit.node * bands + i] = (1.0f - h.fraction) * value[a + i] + h.fraction * value[b + i];
    }
}

}  // namespace

std::vector<float> light_of_nodes(const PatchSet& patches, const SideLight& light, const SideNodes& nodes,
                                  const Context& context) {
  const SideSlopes slopes(patches, light, nodes, context);
  const NeedleNodes needles(patches, nodes);
  NodeFit fit(light, nodes, slopes, needles, context);
  fit.begin();
  for (int i = 0; i < sweeps; ++i) fit.sweep();
  fit.limit();
  auto value = fit.take();
  close_seams(patches, nodes, light.bands(), value);
  return value;
}

}  // namespace luxel
