// SPDX-License-Identifier: Apache-2.0
#include "bench/coverage.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "luxel/patch/side.h"
#include "luxel/trace/seen_error.h"

#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr double within = 1.96;    // standard errors
constexpr double rounding = 1e-6;  // of floats, relative: what is exact has no error but this
constexpr std::uint64_t first_truth_seed = 2'000'003;

double squared(double x) { return x * x; }

std::vector<float> both_sides(const std::vector<float>& front, const std::vector<float>& back,
                              std::size_t bands) {
  std::vector<float> both(2 * front.size());
  for (std::size_t i = 0; i < front.size(); ++i) {
    const auto at = 2 * (i / bands) * bands + i % bands;
    both[at] = front[i];
    both[at + bands] = back[i];
  }
  return both;
}

// Mean of n independent numbers, and its variance; 0 for a single number.
template <typename Number>
std::pair<double, double> mean_and_variance(std::size_t n, Number number) {
  const auto count = static_cast<double>(n);
  double mean = 0.0;
  for (std::size_t k = 0; k < n; ++k) mean += number(k) / count;
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) sum += squared(number(k) - mean);
  return {mean, n > 1 ? sum / (count * (count - 1.0)) : 0.0};
}

// Share of intervals that hold, seed by seed.
class Tally {
 public:
  void add(double weight, bool holds) {
    held_ += holds ? weight : 0.0;
    whole_ += weight;
    ++intervals_;
  }
  void end_seed() {
    if (whole_ > 0.0) fractions_.push_back(held_ / whole_);
    held_ = whole_ = 0.0;
  }
  Held held() const {
    Held result;
    result.intervals = intervals_;
    const auto [mean, variance] =
        mean_and_variance(fractions_.size(), [&](std::size_t k) { return fractions_[k]; });
    result.fraction = mean;
    result.error = std::sqrt(variance);
    return result;
  }

 private:
  double held_ = 0.0, whole_ = 0.0;
  std::size_t intervals_ = 0;
  std::vector<double> fractions_;
};

// The truth's power at one side of a material, W, [band].
struct TruePower {
  std::vector<double> power, variance;
};

class Pool {
 public:
  Pool(const Stage& stage, const Views& views, const KnownLight& truth)
      : patches_(stage.patches), views_(views), truth_(truth), bands_(patches_.band_count()) {
    differences_.assign(truth.irradiance.size(), 0.0);
    std::map<Surface, std::vector<std::vector<double>>> powers;  // W, [surface][run][band]
    for (std::size_t i = 0; i < side_count(patches_.size()); ++i) {
      const auto side = SideId::at(i);
      for (const auto& surface : {surface_of(side), everything}) {
        auto& power = powers[surface];
        power.resize(truth.runs.size(), std::vector<double>(bands_, 0.0));
        for (std::size_t k = 0; k < power.size(); ++k)
          for (std::size_t b = 0; b < bands_; ++b)
            power[k][b] += area(side) * static_cast<double>(truth.runs[k][i * bands_ + b]);
      }
    }
    for (const auto& [surface, power] : powers)
      for (std::size_t b = 0; b < bands_; ++b) {
        const auto& of_run = power;
        const auto [mean, variance] =
            mean_and_variance(of_run.size(), [&](std::size_t k) { return of_run[k][b]; });
        known_[surface].power.push_back(mean);
        known_[surface].variance.push_back(variance);
      }
  }

  void add(const Solution& solution, const SolveReport& report) {
    add_sides(both_sides(solution.irradiance.front, solution.irradiance.back, bands_),
              both_sides(solution.standard_error.front, solution.standard_error.back, bands_));
    for (const auto& s : report.means.surfaces) {
      const auto& known = known_.at({s.material, s.is_back});
      for (std::size_t b = 0; b < bands_; ++b)
        add(surfaces_, s.area * s.irradiance[b], s.area * s.standard_error[b], known, b);
    }
    surfaces_.end_seed();
    const auto& received = report.means.received;
    for (std::size_t b = 0; b < bands_; ++b)
      add(power_, received.power[b], received.standard_error[b], known_.at(everything), b);
    power_.end_seed();
    stated2_ += squared(report.seen_error);
    ++seeds_;
  }

  Coverage result() const {
    Coverage c;
    const auto n = static_cast<double>(seeds_);
    c.seeds = seeds_;
    c.sides = sides_.held();
    c.sides_by_area = by_area_.held();
    c.surfaces = surfaces_.held();
    c.power = power_.held();
    c.stated = std::sqrt(stated2_ / n);
    c.true_error = true_error();
    const auto [off, variance] =
        mean_and_variance(power_off_.size(), [&](std::size_t k) { return power_off_[k]; });
    c.power_bias = off;
    double power = 0.0;
    double of_truth = 0.0;
    for (std::size_t b = 0; b < bands_; ++b) {
      power += known_.at(everything).power[b];
      of_truth += known_.at(everything).variance[b];
    }
    c.power_bias_error = std::sqrt(variance + of_truth / squared(power));
    c.truth_part = std::sqrt(truth2_ / std::max(stated_sides2_, 1e-300));
    return c;
  }

 private:
  using Surface = std::pair<std::size_t, bool>;  // material, and whether it is its back
  inline static const Surface everything{std::size_t(-1), false};
  Surface surface_of(SideId side) const {
    return {static_cast<std::size_t>(patches_.material[side.patch()]), side.is_back()};
  }
  double area(SideId side) const { return static_cast<double>(patches_.area[side.patch()]); }
  double light(std::size_t i) const { return static_cast<double>(truth_.irradiance[i]); }
  double variance(std::size_t i) const { return static_cast<double>(truth_.variance[i]); }

  void add_sides(const std::vector<float>& irradiance, const std::vector<float>& standard_error) {
    double power = 0.0;
    double of_truth = 0.0;
    for (std::size_t i = 0; i < irradiance.size(); ++i) {
      const auto off = static_cast<double>(irradiance[i]) - light(i);
      const auto squared_error = squared(static_cast<double>(standard_error[i]));
      const auto weight = area(SideId::at(i / bands_));
      differences_[i] += squared(off);
      power += weight * static_cast<double>(irradiance[i]);
      of_truth += weight * light(i);
      if (!(light(i) > 0.0) && !(irradiance[i] > 0.0f)) continue;
      const bool holds =
          squared(off) <= squared(within) * (squared_error + variance(i)) + squared(rounding * light(i));
      sides_.add(1.0, holds);
      by_area_.add(weight, holds);
      truth2_ += weight * variance(i);
      stated_sides2_ += weight * squared_error;
    }
    sides_.end_seed();
    by_area_.end_seed();
    power_off_.push_back(power / of_truth - 1.0);
  }

  static void add(Tally& tally, double power, double error, const TruePower& known, std::size_t band) {
    if (!(known.power[band] > 0.0)) return;
    tally.add(
        1.0, squared(power - known.power[band]) <= squared(within) * (squared(error) + known.variance[band]) +
                                                       squared(rounding * known.power[band]));
  }

  double true_error() const {
    SeenLight seen{{}, {}, sky_radiance(patches_)};
    const bool black = reflects_nothing(patches_, views_);
    const auto estimate_of = [this](SideId side) {
      SideEstimate estimate;
      for (auto i = side.index() * bands_; i < (side.index() + 1) * bands_; ++i) {
        estimate.irradiance.push_back(truth_.irradiance[i]);
        estimate.squared_error.push_back(differences_[i] / static_cast<double>(seeds_) - variance(i));
      }
      return estimate;
    };
    for (const auto side : views_.sides) {
      const auto of_side =
          light_of_side(patches_, side, estimate_of(side), estimate_of(side.opposite()), black);
      seen.radiance.push_back(of_side.radiance);
      seen.squared_error.push_back(of_side.squared_error);
    }
    return SeenError(views_, seen).percentile_95();
  }

  const PatchSet& patches_;
  const Views& views_;
  const KnownLight& truth_;
  std::size_t bands_, seeds_ = 0;
  std::map<Surface, TruePower> known_;
  std::vector<double> differences_;  // squared, summed over seeds
  Tally sides_, by_area_, surfaces_, power_;
  std::vector<double> power_off_;  // [seed], relative
  double stated2_ = 0.0, truth2_ = 0.0, stated_sides2_ = 0.0;
};

template <typename Stream, typename T>
bool read(Stream& file, std::vector<T>& values) {
  return static_cast<bool>(file.read(reinterpret_cast<char*>(values.data()),
                                     static_cast<std::streamsize>(values.size() * sizeof(T))));
}
template <typename T>
void write(std::ofstream& file, const std::vector<T>& values) {
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
}

}  // namespace

KnownLight known_light(const Stage& stage, std::uint64_t rays, std::uint32_t runs, const Settings& settings,
                       const Context& context) {
  const auto bands = stage.patches.band_count();
  const auto path =
      settings.references /
      fmt::format("{:016x}-{}-{}.luxknown", stage.patches.scene_fingerprint, stage.patches.size(), runs);
  KnownLight light;
  light.runs.assign(runs, std::vector<float>(2 * stage.patches.size() * bands));
  std::vector<std::uint64_t> head(2);  // rays requested, and traced
  std::ifstream kept(path, std::ios::binary);
  const bool is_kept =
      kept && read(kept, head) && head[0] == rays &&
      std::all_of(light.runs.begin(), light.runs.end(), [&](auto& run) { return read(kept, run); });
  if (!is_kept) {
    head = {rays, 0};
    for (std::uint32_t k = 0; k < runs; ++k) {
      Solution solution;
      const SampledOptions options{
          .error = 0.0, .rays = rays / runs, .seed = first_truth_seed + k, .smoothing = false};
      head[1] += solve_sampled(stage.patches, stage.tracer, solution, options, context).rays;
      light.runs[k] = both_sides(solution.irradiance.front, solution.irradiance.back, bands);
    }
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    write(file, head);
    for (const auto& run : light.runs) write(file, run);
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
  }
  light.rays = head[1];
  light.irradiance.resize(light.runs[0].size());
  light.variance.resize(light.irradiance.size());
  for (std::size_t i = 0; i < light.irradiance.size(); ++i) {
    const auto [mean, variance] =
        mean_and_variance(runs, [&](std::size_t k) { return static_cast<double>(light.runs[k][i]); });
    light.irradiance[i] = static_cast<float>(mean);
    light.variance[i] = static_cast<float>(variance);
  }
  return light;
}

Coverage coverage_of(const Stage& stage, const Views& views, const KnownLight& truth, double error,
                     std::size_t seeds, std::uint64_t first_seed, const Context& context) {
  Pool pool(stage, views, truth);
  double cpu = 0.0;
  double rays = 0.0;
  for (std::size_t k = 0; k < seeds; ++k) {
    Solution solution;
    SolveReport report;
    cpu += cost([&] {
             report = solve_sampled(stage.patches, stage.tracer, solution,
                                    {.error = error, .seed = first_seed + k}, context);
           }).cpu;
    rays += static_cast<double>(report.rays);
    pool.add(solution, report);
  }
  auto result = pool.result();
  result.asked = error;
  result.cpu_seconds = cpu / static_cast<double>(seeds);
  result.rays = rays / static_cast<double>(seeds);
  return result;
}

}  // namespace luxel::bench
