// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/solve_light.h"

#include <algorithm>
#include <chrono>
#include <iterator>

#include <fmt/format.h>

#include "luxel/classical/classical.h"
#include "luxel/classical/forecast.h"
#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/process_usage.h"
#include "luxel/core/work_partition.h"
#include "luxel/patch/check_light.h"
#include "luxel/solve/slow_process.h"

namespace luxel {
namespace {

struct MethodInfo {
  Method method;
  std::string_view name, description;
  SolveReport (*solve)(const PatchSet&, const Tracer&, Solution&, const LightOptions&, const LightSink&,
                       const Context&);
};

constexpr MethodInfo methods[] = {
    {Method::sampled, "sampled", "rays from every patch, with an error bar",
     nullptr},  // which alone takes samples
    {Method::shooting, "shooting", "power shot bounce by bounce: stochastic Jacobi iteration",
     [](const PatchSet& patches, const Tracer& tracer, Solution& solution, const LightOptions& options,
        const LightSink& on_light, const Context& context) {
       return solve_stochastic_jacobi(patches, tracer, solution, options.shooting, context, on_light);
     }},
    {Method::dense, "dense", "the matrix of all form factors, solved without noise",
     [](const PatchSet& patches, const Tracer& tracer, Solution& solution, const LightOptions& options,
        const LightSink& on_light, const Context& context) {
       return solve_dense(patches, tracer, solution, options.dense, context, on_light);
     }},
    {Method::hemicube, "hemicube", "form factors by hemicubes, row by row",
     [](const PatchSet& patches, const Tracer&, Solution& solution, const LightOptions& options,
        const LightSink& on_light, const Context& context) {
       return solve_hemicube(patches, solution, options.hemicube, context, on_light);
     }},
    {Method::lines, "lines", "form factors by local lines, row by row",
     [](const PatchSet& patches, const Tracer& tracer, Solution& solution, const LightOptions& options,
        const LightSink& on_light, const Context& context) {
       return solve_lines(patches, tracer, solution, options.lines, context, on_light);
     }},
};

const MethodInfo& info_of(Method method) {
  return *std::find_if(std::begin(methods), std::end(methods),
                       [&](const MethodInfo& info) { return info.method == method; });
}

SolveReport solve_by_method(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                            const LightOptions& options, const SolveHooks& hooks, const Context& context) {
  if (options.method == Method::sampled)
    return solve_sampled(patches, tracer, solution, options.sampled, hooks, context);
  if (!patches.point_lights.empty())
    throw with_hints(
        InputError(fmt::format("lamp '{}' has no surface: only the sampled method and the path-traced "
                               "reference solve such lamps",
                               patches.point_lights.front().light.name)),
        {{Setting::method, "sampled"}});
  check_no_panes(patches);
  return info_of(options.method).solve(patches, tracer, solution, options, hooks.on_light, context);
}

}  // namespace

std::span<const Method> all_methods() {
  static constexpr Method all[] = {Method::sampled, Method::shooting, Method::dense, Method::hemicube,
                                   Method::lines};
  return all;
}

std::string_view name(Method method) { return info_of(method).name; }

std::string_view description(Method method) { return info_of(method).description; }

std::optional<Method> method_named(std::string_view name) {
  for (const auto& info : methods)
    if (info.name == name) return info.method;
  return {};
}

bool takes_uneven_sky(Method method) { return method == Method::sampled || method == Method::shooting; }

SolveReport solve_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LightOptions& options, const SolveHooks& hooks, const Context& context) {
  const auto begin = std::chrono::steady_clock::now();
  const SharedWork work(context);
  const auto traffic_before = work.traffic();
  const auto processor_before = processor_seconds();
  auto report = solve_by_method(patches, tracer, solution, options, hooks, context);
  if (!work.is_shared()) return report;
  const auto traffic = work.traffic();
  const auto polled = traffic.processor_seconds - traffic_before.processor_seconds;
  const ProcessRecord own = {.rays = report.own_rays,
                             .exchanges = traffic.exchanges - traffic_before.exchanges,
                             .received_bytes = traffic.bytes - traffic_before.bytes,
                             .waited_seconds = traffic.seconds - traffic_before.seconds,
                             .processor_seconds = processor_seconds() - processor_before - polled};
  report.processes = work.all_gather_value(own);
  std::vector<double> waits;
  for (const auto& process : report.processes) waits.push_back(process.waited_seconds);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (const auto slow = slow_process(waits, seconds.count()))
    warn(context.log(), fmt::format("rank {} of {} is slow: each of the others waited {:.0f} s for it",
                                    slow->process, waits.size(), slow->seconds));
  return report;
}

std::optional<Forecast> forecast_light(const PatchSet& patches, const Tracer& tracer,
                                       const LightOptions& options, const Context& context) {
  if (options.method != Method::sampled) check_no_panes(patches);
  switch (options.method) {
    case Method::dense:
      return forecast_dense(patches, tracer, options.dense, context);
    case Method::hemicube:
      return forecast_hemicube(patches, options.hemicube, context);
    case Method::lines:
      return forecast_lines(patches, tracer, options.lines, context);
    case Method::sampled:
    case Method::shooting:
      break;
  }
  return {};
}

bool is_too_much(const Forecast& forecast) {
  constexpr double max_seconds = 3600.0;
  constexpr double max_memory = 0.8;  // of what is free
  const auto free = free_memory();
  return forecast.seconds > max_seconds ||
         (free > 0 && static_cast<double>(forecast.bytes) > max_memory * static_cast<double>(free));
}

}  // namespace luxel
