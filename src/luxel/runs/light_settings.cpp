// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/runs/quantity.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

// Parsing and printing of a quantity.
template <typename Parse, typename Print>
struct Notation {
  Parse parse;
  Print print;
  const char* name_of_zero;  // name of the value 0 in the library's own options: "none", "auto"
  const char* expected;
};
template <typename Parse, typename Print>
Notation(Parse, Print, const char*, const char*) -> Notation<Parse, Print>;

template <typename Value, typename Parse, typename Print>
Declaration quantity(const char* name, const char* unit, Value& value, Notation<Parse, Print> in,
                     const char* help) {
  const auto set = [=, &value](const std::string& text) {
    const auto number = text == in.name_of_zero ? std::optional(Value{}) : in.parse(text);
    if (!number)
      throw UsageError(
          fmt::format("--{}: expected {}, or {}, not '{}'", name, in.expected, in.name_of_zero, text));
    value = *number;
  };
  return {name, unit, help, set,
          [=, &value] { return value == Value{} ? in.name_of_zero : in.print(value); }};
}

constexpr const char* by_rows = "dense|hemicube|lines";
constexpr const char* by_bounces = "shooting|dense|hemicube|lines";

const char* name(DenseSolver solver) {
  switch (solver) {
    case DenseSolver::direct:
      return "direct";
    case DenseSolver::jacobi:
      return "jacobi";
    case DenseSolver::gauss_seidel:
      return "gauss-seidel";
  }
  return "";
}

DenseSolver solver_named(const std::string& text) {
  for (const auto solver : {DenseSolver::direct, DenseSolver::jacobi, DenseSolver::gauss_seidel})
    if (text == name(solver)) return solver;
  throw UsageError(fmt::format("--solver: expected one of direct|jacobi|gauss-seidel, not '{}'", text));
}

}  // namespace

void LightSettings::check() const {
  if (method == Method::dense && dense.solver != DenseSolver::jacobi &&
      (dense.iteration.steps > 0 || !each_step.empty()))
    throw UsageError(fmt::format("--{} needs --solver jacobi: --solver {} has no bounces",
                                 each_step.empty() ? "steps" : "each-step", name(dense.solver)));
  const bool is_bounded = sampled.rays > 0 || sampled.seconds > 0.0;
  if (method == Method::sampled && sampled.error == 0.0 && !is_bounded)
    throw UsageError("--error 0 sets no target: give --rays or --time as the limit");
}

void LightSettings::declare_method(OptionSet& set) {
  std::vector<std::string> words;
  for (const auto each : all_methods()) words.emplace_back(name(each));
  set.add({"method", fmt::format("{}", fmt::join(words, "|")),
           "the solver; sampled stops at --error, the others are classical methods, see docs/methods.md",
           [this, words](const std::string& text) {
             const auto named = method_named(text);
             if (!named)
               throw UsageError(
                   fmt::format("--method: expected one of {}, not '{}'", fmt::join(words, "|"), text));
             method = *named;
           },
           [this] { return std::string(name(method)); }});
}

void LightSettings::declare(OptionSet& set) {
  set.heading("Light");
  declare_method(set);
  set.only_with("method", "sampled|shooting");
  declare_rays(set);
  set.only_with("method", "sampled|shooting|lines");
  set.add({"seed", "count", "seed of the random numbers; other seeds give independent solutions",
           [this](const std::string& text) {
             sampled.seed = shooting.seed = lines.lines.seed = parse_count("seed", text);
           },
           [this] { return fmt::format("{}", sampled.seed); }});
  declare_sampled(set);
  declare_shooting(set);
  declare_classical(set);
  set.only_with();
}

void LightSettings::declare_sampled(OptionSet& set) {
  set.heading("Light by --method sampled");
  set.only_with("method", "sampled");
  declare_error_and_time(set);
  declare_ray_budget(set);
  set.add_text("focus", "all|camera|NAME", focus,
               "where the seen error counts: all: everywhere; camera: in the picture of --eye or of the "
               "file's cameras; NAME: on surfaces of this material, object or group (with * and ?)");
  set.add_number("replicates", "count", sampled.replicates, 4u, 32u,
                 "independent estimates; their spread gives the standard errors");
  declare_variance_reduction(set);
}

void LightSettings::declare_rays(OptionSet& set) {
  set.add(
      {"rays", "count",
       "sampled: maximum number of rays, such as 50M; shooting: rays that carry the power of the lamps once",
       [this](const std::string& text) {
         sampled.rays = shooting.rays = text == "auto" ? 0 : parse_count("rays", text);
       },
       [this] { return sampled.rays == 0 ? std::string("auto") : fmt::format("{}", sampled.rays); }});
}

void LightSettings::declare_ray_budget(OptionSet& set) {
  const auto add = [&](const std::string& name, const std::string& help, std::uint64_t& rays) {
    set.add({name, "count", help,
             [&rays, name](const std::string& text) { rays = text == "none" ? 0 : parse_count(name, text); },
             [&rays] {
               constexpr std::uint64_t million = 1'000'000;
               return rays == 0             ? std::string("none")
                      : rays % million == 0 ? fmt::format("{}M", rays / million)
                                            : fmt::format("{}", rays);
             }});
  };
  add("ray-budget",
      "stop near this number of rays, such as 500M, even if the error is not reached; the default has no "
      "effect where --error, --rays or --time is given; none: no bound",
      sampled.ray_budget);
  add("cheap-rays",
      "go on to half of --error where about this number of rays suffices; the default has no effect where "
      "--error, --rays or --time is given; none: stop at --error",
      sampled.cheap_rays);
}

void LightSettings::declare_error_and_time(OptionSet& set) {
  set.add({"error", "fraction",
           "stop at this error, such as 2% or 0.02: the standard error of the visible light, relative to the "
           "brightness there, that 95 % of viewpoints all over the scene stay below (see --error-measure); 0 "
           "disables it",
           [this](const std::string& text) {
             const auto fraction = parse_fraction(text);
             if (!fraction)
               throw UsageError(
                   fmt::format("--error: expected a fraction below 1, such as 1% or 0.01, not '{}'", text));
             sampled.error = *fraction;
           },
           [this] { return sampled.error == 0.0 ? std::string("0") : as_fraction(sampled.error); }});
  set.add(
      {"error-measure", "seen|power",
       "what --error measures, and so where rays are spent; seen: as above, with equal weight for each room "
       "and the outside; power: the area-weighted RMS over all surfaces, dominated by bright ones",
       [this](const std::string& text) {
         if (text != "seen" && text != "power")
           throw UsageError(fmt::format("--error-measure: expected seen or power, not '{}'", text));
         sampled.error_measure = text == "seen" ? ErrorMeasure::seen : ErrorMeasure::power;
       },
       [this] { return std::string(sampled.error_measure == ErrorMeasure::seen ? "seen" : "power"); }});
  set.add(
      quantity("time", "duration", sampled.seconds,
               Notation{parse_duration, as_duration, "none", "a time such as 30s, 5min or 2h"},
               "maximum time of the whole run, from its start to its last file, such as 30s, 5min or 2h"));
}

void LightSettings::declare_memory(OptionSet& set) {
  set.add(quantity("memory", "size", sampled.memory,
                   Notation{parse_bytes, as_bytes, "auto", "a size such as 512MiB or 4GiB"},
                   "maximum memory of the sampled solver, such as 4GiB; less memory makes it slower and "
                   "changes no result; auto: half of the free memory"));
}

void LightSettings::declare_bounds(OptionSet& set) {
  set.heading("Light");
  declare_rays(set);
  declare_error_and_time(set);
  declare_ray_budget(set);
}

void LightSettings::declare_variance_reduction(OptionSet& set) {
  set.add_switch("low-discrepancy", sampled.low_discrepancy,
                 "use Owen-scrambled Sobol points instead of random ones");
  set.add_switch("stratified", sampled.stratified, "stratify samples over neighbouring patches");
  set.add_switch("importance", sampled.importance,
                 "choose lamps in proportion to their possible contribution");
  set.add_switch("control-variate", sampled.control_variate,
                 "use the closed form of unshadowed light as control variate of shadow rays");
  set.add_switch(
      "mis", sampled.multiple_importance,
      "combine lamp samples with cosine rays by multiple importance sampling, instead of the control "
      "variate");
  set.add_switch("both-ways", sampled.both_ways,
                 "use each ray for the surface it hits as well as for the one it leaves");
  set.add_switch("smoothing", sampled.smoothing,
                 "smooth the noise of neighbouring patches by local regression, where they miss the error");
}

void LightSettings::declare_shooting(OptionSet& set) {
  set.heading("Light by --method shooting");
  set.only_with("method", "shooting");
  set.add_number("rays-per-patch", "count", shooting.rays_per_patch, 1.0, 1e9,
                 "rays per patch of '--rays auto'");
  declare_tolerance(set);
}

void LightSettings::declare_tolerance(OptionSet& set) {
  set.only_with("method", by_bounces);
  set.add({"tolerance", "fraction",
           "fraction of the emitted power that may stay unshot, which is the bias; for --solver "
           "gauss-seidel, its error",
           [this](const std::string& text) {
             const auto fraction = parse_double(text);
             if (!fraction || !(*fraction >= 1e-12 && *fraction <= 0.9))
               throw UsageError(
                   fmt::format("--tolerance: expected a number from 1e-12 to 0.9, not '{}'", text));
             shooting.tolerance = dense.iteration.tolerance = hemicube.iteration.tolerance =
                 lines.iteration.tolerance = *fraction;
           },
           [this] { return fmt::format("{}", shooting.tolerance); }});
}

void LightSettings::declare_classical(OptionSet& set) {
  set.heading("Light by --method dense");
  set.only_with("method", "dense");
  set.add({"solver", "direct|jacobi|gauss-seidel", "solver of the linear system",
           [this](const std::string& text) { dense.solver = solver_named(text); },
           [this] { return std::string(name(dense.solver)); }});
  set.add_number("factor-tolerance", "absolute", dense.factors.tolerance, 1e-9, 0.1,
                 "absolute tolerance of partially occluded form factors");
  set.add({"elements", "patches|faces",
           "unknowns; faces: the patches of one flat face that --max-edge leaves uncut have one value",
           [this](const std::string& text) {
             if (text != "patches" && text != "faces")
               throw UsageError(fmt::format("--elements: expected patches or faces, not '{}'", text));
             joins_faces = text == "faces";
           },
           [this] { return std::string(joins_faces ? "faces" : "patches"); }});
  set.heading("Light by --method hemicube");
  set.only_with("method", "hemicube");
  set.add_number("hemicube-resolution", "pixels", hemicube.hemicube.resolution, 2, 4096,
                 "pixels along an edge of the top face, an even number");
  set.add_number("hemicube-points", "count", hemicube.hemicube.points, 1, 256,
                 "sample points per patch: 1, 4, 16, 64 or 256");
  set.heading("Light by --method lines");
  set.only_with("method", "lines");
  set.add_number("lines", "count", lines.lines.lines, 1u, 100'000'000u,
                 "cosine-distributed lines per patch side");
  set.heading("Light by --method dense, hemicube or lines");
  set.only_with("method", by_rows);
  set.add({"steps", "count", "maximum number of bounces, for iterations that follow bounces; 0: unlimited",
           [this](const std::string& text) {
             const auto count = parse_count("steps", text);
             if (count > 100'000) throw UsageError("--steps: expected 0 to 100000 bounces");
             dense.iteration.steps = hemicube.iteration.steps = lines.iteration.steps =
                 static_cast<int>(count);
           },
           [this] { return fmt::format("{}", dense.iteration.steps); }});
}

void LightSettings::declare_run(OptionSet& set) {
  set.heading(RunSettings::heading);
  set.only_with("method", "sampled");
  declare_memory(set);
  set.only_with("method", by_rows);
  set.add_text(
      "each-step", "DIR", each_step,
      "write a picture after every bounce, DIR/step-001.png and so on, all with the exposure of the last");
  set.add_flag("force", force,
               "start even if the predicted time is hours or the predicted memory exceeds the free memory");
  set.only_with();
}

}  // namespace luxel
