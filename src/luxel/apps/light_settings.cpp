// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/apps/quantity.h"
#include "luxel/apps/settings.h"

namespace luxel {
namespace {

// A quantity whose 0 in the library's own options has a name of its own: "none", "auto".
template <typename Value, typename Parse, typename Print>
Declaration quantity(const char* name, const char* unit, Value& value, const char* name_of_zero, Parse parse,
                     Print print, const char* expected, const char* help) {
  const auto set = [=, &value](const std::string& text) {
    const auto number = text == name_of_zero ? std::optional(Value{}) : parse(text);
    if (!number)
      throw UsageError(fmt::format("--{}: expected {}, or {}, not '{}'", name, expected, name_of_zero, text));
    value = *number;
  };
  return {name, unit, help, set, [=, &value] { return value == Value{} ? name_of_zero : print(value); }};
}

}  // namespace

void LightSettings::check() const {
  const bool is_bounded = sampled.rays > 0 || sampled.seconds > 0.0;
  if (method == by_sampling && sampled.error == 0.0 && !is_bounded)
    throw UsageError("--error 0 asks for no accuracy: give --rays or --time to say when to stop");
}

void LightSettings::declare(OptionSet& set) {
  set.heading("Light");
  set.add_choice("method", {by_sampling, by_shooting}, method,
                 "sampled stops at the error asked for; shooting is plain stochastic Jacobi");
  set.add({"rays", "count",
           "sampled: trace no more than this; shooting: rays that carry the lamps' power once. Such as 50M",
           [this](const std::string& text) {
             sampled.rays = shooting.rays = text == "auto" ? 0 : parse_count("rays", text);
           },
           [this] { return sampled.rays == 0 ? std::string("auto") : fmt::format("{}", sampled.rays); }});
  set.add({"seed", "count", "another seed gives another, independent answer",
           [this](const std::string& text) { sampled.seed = shooting.seed = parse_count("seed", text); },
           [this] { return fmt::format("{}", sampled.seed); }});
  declare_sampled(set);
  declare_shooting(set);
  set.only_with();
}

void LightSettings::declare_sampled(OptionSet& set) {
  set.heading("Light by --method sampled");
  set.only_with("method", by_sampling);
  set.add({"error", "share",
           "stop at this standard error of the whole, such as 1% or 0.01; 0: never for that",
           [this](const std::string& text) {
             const auto share = parse_share(text);
             if (!share)
               throw UsageError(
                   fmt::format("--error: expected a share below 1, such as 1% or 0.01, not '{}'", text));
             sampled.error = *share;
           },
           [this] { return sampled.error == 0.0 ? std::string("0") : as_share(sampled.error); }});
  set.add(quantity("time", "duration", sampled.seconds, "none", parse_duration, as_duration,
                   "a time such as 30s, 5min or 2h", "solve no longer than this, such as 30s, 5min or 2h"));
  set.add_number("replicates", "count", sampled.replicates, 4u, 32u,
                 "independent answers whose spread is the error bar");
  declare_variance_reduction(set);
}

void LightSettings::declare_variance_reduction(OptionSet& set) {
  set.add_switch("low-discrepancy", sampled.low_discrepancy, "Owen-scrambled Sobol points, not random ones");
  set.add_switch("stratified", sampled.stratified, "one sequence runs over neighbouring patches");
  set.add_switch("importance", sampled.importance, "lamps are chosen by what they can contribute");
  set.add_switch("control-variate", sampled.control_variate,
                 "the closed form of unshadowed light carries the shadow rays");
  set.add_switch("mis", sampled.multiple_importance,
                 "cosine rays that meet a lamp count too, in place of the control variate");
  set.add_switch("share", sampled.share,
                 "neighbouring patches share rays where their own do not reach the error");
}

void LightSettings::declare_shooting(OptionSet& set) {
  set.heading("Light by --method shooting");
  set.only_with("method", by_shooting);
  set.add_number("rays-per-patch", "count", shooting.rays_per_patch, 1.0, 1e9, "what '--rays auto' aims at");
  set.add_number("tolerance", "share", shooting.tolerance, 1e-12, 0.9,
                 "share of the emitted power that may stay unshot: the bias");
}

void LightSettings::declare_memory(OptionSet& set) {
  set.heading(RunSettings::heading);
  set.only_with("method", by_sampling);
  set.add(quantity(
      "memory", "size", sampled.memory, "auto", parse_bytes, as_bytes, "a size such as 512MiB or 4GiB",
      "what the sampled solver may hold, such as 4GiB; with less it is slower and gives the same "
      "answer; auto is half of what is free"));
  set.only_with();
}

}  // namespace luxel
