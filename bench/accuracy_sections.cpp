// SPDX-License-Identifier: Apache-2.0
// Cost of a solution of given accuracy: by method, by switch, by number of patches.
#include <fmt/format.h>

#include "bench/accuracy.h"
#include "bench/gather_rays.h"
#include "bench/same_rays.h"
#include "bench/scenes.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr double target = 0.01;

// A scene and the maximum cost of its reference. The finer the mesh, the coarser the affordable reference;
// its squared error is subtracted from those of the runs.
struct Subject {
  std::string name;
  Scene (*make)(std::size_t triangles);
  std::size_t triangles;
  double reference_seconds;
};

constexpr double reference_error = 0.001;

Stage stage_of(const Subject& subject, const Settings& settings, const Context& context) {
  return {subject.name, subject.make(settings.small ? subject.triangles / 10 : subject.triangles), context};
}

Reference reference_of(const Stage& stage, const Subject& subject, const Settings& settings,
                       const Context& context) {
  return reference_of(stage, settings.small ? 0.005 : reference_error,
                      settings.small ? 2.0 : subject.reference_seconds, settings, context);
}

Scene reading_room_of(std::size_t triangles) {
  int detail = 1;
  while (39'884u * static_cast<unsigned>(detail * detail) < triangles) ++detail;
  return reading_room(detail);
}

Json head_of(const Stage& stage, const Reference& reference) {
  return {{"scene", stage.name},
          {"patches", stage.patches.size()},
          {"reference_error", reference.error},
          {"reference_rays", reference.rays}};
}

void print_runs(const std::string& method, const std::vector<Run>& runs, const Price& price) {
  fmt::print("{:>18} {:>20} {:>9} {:>9} {:>9} {:>10} {:>9} {:>8} {:>9}\n", method, "", "CPU s", "wall s",
             "Mrays", "predicted", "true", "bias", "of power");
  for (const auto& r : runs)
    fmt::print("{:>18} {:>20} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.3f} % {:>9} {:>6.2f} % {:>7.3f} %\n", "",
               r.setting, r.cpu_seconds, r.wall_seconds, 1e-6 * static_cast<double>(r.rays),
               100.0 * r.predicted_error, r.true_error ? fmt::format("{:.3f} %", 100.0 * *r.true_error) : "?",
               100.0 * r.bias, 100.0 * r.power_bias);
  fmt::print("{:>18} {:>20} {:>9.3f} {:>9} {:>9.3f} {}\n", "", "to 1 %", price.cpu_seconds, "",
             1e-6 * price.rays, price.how);
}

Json method_of(const std::string& name, const std::vector<Run>& runs) {
  const auto price = price_of(runs, target);
  print_runs(name, runs, price);
  Json rows = Json::array();
  for (const auto& r : runs) rows.push_back(to_json(r));
  return {{"method", name}, {"runs", rows}, {"to_one_per_cent", to_json(price)}};
}

// One switch of SampledOptions.
struct Switch {
  const char* name;
  bool SampledOptions::*field;
};
constexpr Switch switches[] = {{"low_discrepancy", &SampledOptions::low_discrepancy},
                               {"stratified", &SampledOptions::stratified},
                               {"importance", &SampledOptions::importance},
                               {"control_variate", &SampledOptions::control_variate},
                               {"multiple_importance", &SampledOptions::multiple_importance},
                               {"smoothing", &SampledOptions::smoothing}};

}  // namespace

Json error_against_time(const Settings& settings) {
  const std::vector<Subject> subjects = {
      {"cornell box, 2,000", cornell_box, 2'000, 10.0},   {"cornell box, 10,000", cornell_box, 10'000, 20.0},
      {"cornell box, 50,000", cornell_box, 50'000, 40.0}, {"office, 2,000", office, 2'000, 10.0},
      {"office, 10,000", office, 10'000, 20.0},           {"office, 50,000", office, 50'000, 40.0},
      {"two rooms, 10,000", two_rooms, 10'000, 20.0},     {"reading room", reading_room_of, 39'884, 40.0}};
  fmt::print("\nerror: true error against processor time\n");
  const Context context;
  Json scenes = Json::array();
  for (const auto& subject : subjects) {
    const auto stage = stage_of(subject, settings, context);
    const auto reference = reference_of(stage, subject, settings, context);
    const std::vector<double> errors = {0.08, 0.04, 0.02, 0.01, 0.005};
    const double longest = settings.small ? 1.0 : 30.0;
    auto scene = head_of(stage, reference);
    scene["methods"] = {
        method_of("sampled", sampled_runs(stage, reference, {}, errors, longest, context)),
        method_of("sampled, without smoothing",
                  sampled_runs(stage, reference, {.smoothing = false}, errors, longest, context)),
        // Its rays are stratified over the patches by systematic sampling and otherwise use plain random
        // numbers; with plain random numbers alone it would be slightly worse.
        method_of("shooting", shooting_runs(stage, reference, {25.0, 100.0, 400.0}, context))};
    scenes.push_back(scene);
  }
  return {{"target", target}, {"scenes", scenes}};
}

Json variance_reduction(const Settings& settings) {
  const std::vector<Subject> subjects = {{"cornell box, 10,000", cornell_box, 10'000, 20.0},
                                         {"office, 10,000", office, 10'000, 20.0},
                                         {"two rooms, 10,000", two_rooms, 10'000, 20.0}};
  const std::vector<double> errors = {0.03, 0.015, 0.0075};
  const double longest = settings.small ? 1.0 : 20.0;
  fmt::print("\nvariance: cost of 1 % with each switch changed, over the default's\n");
  const Context context;
  Json scenes = Json::array();
  for (const auto& subject : subjects) {
    const auto stage = stage_of(subject, settings, context);
    const auto reference = reference_of(stage, subject, settings, context);
    const auto price_with = [&](const SampledOptions& options) {
      return price_of(sampled_runs(stage, reference, options, errors, longest, context), target);
    };
    const auto usual = price_with({});
    fmt::print("{:>26} {:>10} {:>10} {:>10} {:>10}\n", "", "CPU s", "ratio", "Mrays", "ratio");
    fmt::print("{:>26} {:>10.3f} {:>10} {:>10.3f} {:>10} {}\n", "default", usual.cpu_seconds, "",
               1e-6 * usual.rays, "", usual.how);
    Json rows = Json::array();
    for (const auto& [name, field] : switches) {
      SampledOptions options;
      options.*field = !(options.*field);
      const auto price = price_with(options);
      const auto word = fmt::format("{} {}", name, options.*field ? "on" : "off");
      const auto cpu_ratio = price.cpu_seconds / usual.cpu_seconds;
      const auto ray_ratio = price.rays / usual.rays;
      fmt::print("{:>26} {:>10.3f} {:>10.2f} {:>10.3f} {:>10.2f} {}\n", word, price.cpu_seconds, cpu_ratio,
                 1e-6 * price.rays, ray_ratio, price.how);
      rows.push_back({{"switch", name},
                      {"state", options.*field ? "on" : "off"},
                      {"to_one_per_cent", to_json(price)},
                      {"cpu_ratio", cpu_ratio},
                      {"ray_ratio", ray_ratio}});
    }
    auto scene = head_of(stage, reference);
    scene["default_to_one_per_cent"] = to_json(usual);
    scene["switches"] = rows;
    scenes.push_back(scene);
  }
  return {{"target", target}, {"scenes", scenes}};
}

Json cost_per_patch(const Settings& settings) {
  const std::vector<Subject> subjects = {{"cornell box, 2,000", cornell_box, 2'000, 10.0},
                                         {"cornell box, 10,000", cornell_box, 10'000, 20.0},
                                         {"cornell box, 50,000", cornell_box, 50'000, 40.0},
                                         {"cornell box, 250,000", cornell_box, 250'000, 50.0},
                                         {"cornell box, 1,000,000", cornell_box, 1'000'000, 100.0}};
  fmt::print("\npatches: cost of 1 % a patch, and what a ray costs Embree alone there\n");
  const Context context;
  Json rows = Json::array();
  for (const auto& subject : subjects) {
    const auto stage = stage_of(subject, settings, context);
    const auto reference = reference_of(stage, subject, settings, context);
    const auto runs = sampled_runs(stage, reference, {}, {0.02, 0.008}, settings.small ? 2.0 : 60.0, context);
    const auto price = price_of(runs, target);
    const auto predicted = predicted_price_of(runs, target);
    print_runs("sampled", runs, price);
    const auto rays = gather_rays(stage.patches, fronts_of(stage.patches, context),
                                  {.most = settings.small ? 100'000u : 2'000'000u}, RayOrder::traced);
    const BareEmbree embree(stage.patches);
    const auto kernel = cost([&] { embree.trace(rays, context); });
    const auto count = static_cast<double>(stage.patches.size());
    const auto us_per_patch = 1e6 * price.cpu_seconds / count;
    const auto ns_per_ray = 1e9 * kernel.cpu / static_cast<double>(rays.size());
    fmt::print(
        "{:>18} {:.1f} us of processor time a patch ({:.1f} by its own error bar); Embree alone {:.0f} ns a "
        "ray in the order of the solver\n",
        "", us_per_patch, 1e6 * predicted.cpu_seconds / count, ns_per_ray);
    auto row = head_of(stage, reference);
    row["runs"] = {to_json(runs.front()), to_json(runs.back())};
    row["to_one_per_cent"] = to_json(price);
    row["to_one_per_cent_predicted"] = to_json(predicted);
    row["cpu_us_per_patch"] = us_per_patch;
    row["embree_cpu_ns_per_ray"] = ns_per_ray;
    rows.push_back(row);
  }
  return {{"target", target}, {"rows", rows}};
}

}  // namespace luxel::bench
