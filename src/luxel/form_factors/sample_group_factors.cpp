// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "luxel/form_factors/group_sums.h"
#include "luxel/form_factors/sampling.h"

namespace luxel {
namespace {

constexpr std::size_t rays_per_job = 1u << 18;
constexpr std::uint64_t min_rays = 1u << 20;      // in a first round, regardless of the error
constexpr std::uint64_t gentle_first = 1u << 24;  // limit of a first round where there are many sides
constexpr std::uint32_t few_per_replicate =
    16;                                    // rays per side and replicate that suffice to estimate a spread
constexpr std::uint32_t max_halvings = 4;  // of the ray count for the smaller patches of an element

// Ray counts are those of the element's largest patches. A patch with less than half that area gets half as
// many rays, and so on; each ray is weighted by the area it represents.
class GroupSampling {
 public:
  GroupSampling(const ElementRays& rays, const SampleFactorsOptions& options, const Context& context)
      : rays_(rays),
        context_(context),
        sums_(rays.replicates()),
        max_(max_per_replicate(options)),
        first_(first_rays()),
        rounds_(rays.elements().size(), 0) {
    plan_receivers();
  }

  // Doubles the rays of these elements. Returns false where the monitor stops the work; the sums are then
  // unusable.
  bool double_rays(const std::vector<std::uint8_t>& wanted) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> alike;
    for (std::uint32_t s = 0; s < rays_.receivers(); ++s)
      if (const auto e = rays_.element_of_receiver(s); wanted[e])
        alike[{rounds_[e], halvings_[s]}].push_back(s);
    Turn turn;
    for (const auto& [key, receivers] : alike)
      turn.whole += receivers.size() * std::uint64_t{added(key.first) >> key.second};
    for (const auto& [key, receivers] : alike)
      if (!trace(receivers, key.first, added(key.first) >> key.second, turn)) return false;
    for (std::size_t e = 0; e < wanted.size(); ++e) rounds_[e] += wanted[e];
    traced_ += turn.whole * rays_.replicates();
    return true;
  }

  bool may_double(std::size_t element) const { return whole_[element] > 0.0 && so_far(element) < max_; }
  const GroupSums& sums() const { return sums_; }
  std::uint64_t traced() const { return traced_; }
  std::uint64_t max_rays_per_side() const {
    std::uint32_t most = 0;
    for (std::size_t e = 0; e < rounds_.size(); ++e) most = std::max(most, so_far(e));
    return std::uint64_t{rays_.replicates()} * most;
  }

  ViewFactors factors(double min_factor) const {
    auto result = ViewFactors::between(rays_.elements().name, rays_.elements().area);
    auto whole = whole_;
    for (std::size_t e = 0; e < whole.size(); ++e) {
      whole[e] *= so_far(e);
      result.rays[e] = worth_[e] * rays_.replicates() * so_far(e);
    }
    sums_.write(whole, min_factor, result);
    return result;
  }

 private:
  // Progress of a doubling, in rays per replicate.
  struct Turn {
    std::uint64_t whole = 0, done = 0;
  };

  // Rays per largest patch and replicate: of one round, and of all rounds so far.
  std::uint32_t added(std::uint32_t round) const { return round == 0 ? first_ : first_ << (round - 1); }
  std::uint32_t so_far(std::size_t e) const { return rounds_[e] == 0 ? 0 : first_ << (rounds_[e] - 1); }

  std::uint32_t first_rays() const {
    const auto sides = rays_.receivers() * std::uint64_t{rays_.replicates()};
    auto first = few_per_replicate;
    while (first > 1 && first * sides > gentle_first) first /= 2;
    while (first < max_ && first * sides < min_rays) first *= 2;
    return std::min(first, max_);
  }

  void plan_receivers() {
    const auto n = rounds_.size();
    std::vector<double> largest(n, 0.0), variance(n, 0.0);
    for (std::size_t s = 0; s < rays_.receivers(); ++s) {
      auto& most = largest[rays_.element_of_receiver(s)];
      most = std::max(most, rays_.area_of_receiver(s));
    }
    const auto most = std::min<std::uint32_t>(max_halvings, std::bit_width(first_) - 1);
    whole_.assign(n, 0.0);
    worth_.assign(n, 0.0);
    for (std::size_t s = 0; s < rays_.receivers(); ++s) {
      const auto e = rays_.element_of_receiver(s);
      const auto area = rays_.area_of_receiver(s);
      std::uint32_t halvings = 0;
      while (halvings < most && area * (2u << halvings) <= largest[e]) ++halvings;
      halvings_.push_back(halvings);
      whole_[e] += area;
      variance[e] += area * area * (1u << halvings);
    }
    for (std::size_t e = 0; e < n; ++e)
      if (variance[e] > 0.0) worth_[e] = whole_[e] * whole_[e] / variance[e];
  }

  bool trace(const std::vector<std::uint32_t>& receivers, std::uint32_t level, std::uint32_t per_receiver,
             Turn& turn) {
    const auto positions = std::bit_floor(std::clamp<std::size_t>(rays_per_job / per_receiver, 1, 4096));
    const auto begins = rays_.runs(receivers, static_cast<std::uint32_t>(positions));
    const auto replicates = rays_.replicates();
    const auto jobs = (begins.size() - 1) * replicates;
    const auto together = 16 * static_cast<std::size_t>(context_.threads());
    for (std::size_t from = 0; from < jobs; from += together) {
      const auto to = std::min(jobs, from + together);
      std::vector<GroupSums> parts(to - from, GroupSums(replicates));
      context_.for_chunks(to - from, 1, [&](std::size_t begin, std::size_t end, int) {
        for (auto i = begin; i < end; ++i) {
          const auto run = (from + i) / replicates;
          add_run(std::span(receivers).subspan(begins[run], begins[run + 1] - begins[run]),
                  static_cast<std::uint32_t>((from + i) % replicates), level, per_receiver, parts[i]);
        }
      });
      for (const auto& part : parts) sums_.add(part);
      const auto done = turn.done + begins[to / replicates] * std::uint64_t{per_receiver};
      if (context_.report({"view factors", static_cast<double>(done) / static_cast<double>(turn.whole),
                           traced_ + done * replicates}) == Next::stop)
        return false;
    }
    turn.done += receivers.size() * std::uint64_t{per_receiver};
    return true;
  }

  void add_run(std::span<const std::uint32_t> receivers, std::uint32_t replicate, std::uint32_t level,
               std::uint32_t per_receiver, GroupSums& sums) const {
    std::vector<std::uint32_t> met(receivers.size() * per_receiver);
    rays_.trace(receivers, replicate, level, per_receiver, met);
    for (std::size_t s = 0; s < receivers.size(); ++s) {
      const auto element = rays_.element_of_receiver(receivers[s]);
      const auto area = rays_.area_of_receiver(receivers[s]) * (1u << halvings_[receivers[s]]);
      for (std::uint32_t k = 0; k < per_receiver; ++k)
        sums.add(element, met[s * per_receiver + k], replicate, area);
    }
  }

  const ElementRays& rays_;
  const Context& context_;
  GroupSums sums_;
  std::uint32_t max_, first_;
  std::vector<std::uint32_t> rounds_;    // [element]: rounds begun
  std::vector<std::uint32_t> halvings_;  // [receiver]
  std::vector<double> whole_;            // [element], m²: total area weight of the rays; 0: no row
  std::vector<double> worth_;            // [element]: equal-area rays per ray of a largest patch
  std::uint64_t traced_ = 0;
};

// Rows for which the mean squared standard error of the listed factors exceeds the target.
std::vector<std::uint8_t> poor_rows(const ViewFactors& factors, double error, const GroupSampling& sampling) {
  std::vector<std::uint8_t> poor(factors.size(), 0);
  for (std::size_t e = 0; e < factors.size(); ++e) {
    double sum = 0.0;
    for (auto at = factors.row_begin[e]; at < factors.row_begin[e + 1]; ++at)
      sum +=
          static_cast<double>(factors.standard_error[at]) * static_cast<double>(factors.standard_error[at]);
    const auto count = static_cast<double>(factors.row_begin[e + 1] - factors.row_begin[e]);
    poor[e] = sampling.may_double(e) && (error == 0.0 || sum > error * error * count) ? 1 : 0;
  }
  return poor;
}

}  // namespace

std::optional<ViewFactors> sample_group_factors(const ElementRays& rays, const SampleFactorsOptions& options,
                                                SampleFactorsReport& report, const Context& context) {
  GroupSampling sampling(rays, options, context);
  std::optional<ViewFactors> factors;
  std::vector<std::uint8_t> wanted(rays.elements().size(), 0);
  for (std::size_t e = 0; e < wanted.size(); ++e) wanted[e] = sampling.may_double(e) ? 1 : 0;
  for (;;) {
    if (!sampling.double_rays(wanted)) {
      report.stop = StopReason::stopped_by_user;
      return factors;
    }
    report.rays_per_side = sampling.max_rays_per_side();
    report.rays = sampling.traced();
    const auto pairs = static_cast<double>(sampling.sums().pairs());
    predict(pairs, 2.0 * pairs, options, report);
    report.predicted_bytes = std::max(report.predicted_bytes, sampling.sums().bytes());
    factors = sampling.factors(options.min_factor);
    report.error = rms_standard_error(*factors);
    if (options.error > 0.0 && report.error <= options.error) {
      report.stop = StopReason::error_reached;
      return factors;
    }
    wanted = poor_rows(*factors, options.error, sampling);
    if (std::count(wanted.begin(), wanted.end(), 1) == 0) {
      report.stop = StopReason::ray_limit;
      return factors;
    }
  }
}

}  // namespace luxel
