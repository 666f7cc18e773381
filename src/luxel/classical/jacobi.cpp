// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/jacobi.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "luxel/classical/row_turns.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 4096;  // rows per chunk

double power(std::span<const float> radiosity, std::span<const float> less, std::span<const float> area,
             const Context& context) {
  const auto bands = radiosity.size() / area.size();
  return ordered_sum(context, radiosity.size(), [&](std::size_t i) {
    return static_cast<double>(area[i / bands]) *
           std::abs(static_cast<double>(radiosity[i]) - (less.empty() ? 0.0 : static_cast<double>(less[i])));
  });
}

// Progress of the run: the unshot power decreases geometrically.
double done_fraction(double unshot_fraction, double tolerance) {
  return std::clamp(std::log(unshot_fraction) / std::log(tolerance), 0.0, 1.0);
}

// irradiance = F radiosity, in turns of whole blocks; the monitor is polled between them.
bool gather(const TransportOperator& transport, std::span<const float> radiosity, std::span<float> irradiance,
            const Context& context, const std::function<Next(double)>& has_come_so_far) {
  const auto begins = transport.row_begins();
  TurnLength turn(static_cast<std::size_t>(context.threads()));
  for (std::size_t block = 0; block + 1 < begins.size();) {
    const auto next = std::min(block + turn.length(), begins.size() - 1);
    turn.begin();
    transport.apply(radiosity, irradiance, begins[block], begins[next], context);
    turn.end();
    block = next;
    if (has_come_so_far(static_cast<double>(block) / static_cast<double>(begins.size() - 1)) == Next::stop)
      return false;
  }
  return true;
}

}  // namespace

JacobiReport jacobi(const TransportOperator& transport, const JacobiRows& rows, const JacobiOptions& options,
                    const Context& context, const EachStep& each_step) {
  const auto area = rows.area;
  const auto emittance = rows.emittance, outside = rows.outside;
  const auto& scattering = rows.scattering;
  const auto before = rows.before, irradiance = rows.irradiance, radiosity = rows.radiosity;
  assert(area.size() == transport.size());
  assert(emittance.size() == area.size() * transport.bands());
  assert(outside.empty() || outside.size() == emittance.size());
  assert(scattering.reflectance.size() == emittance.size() && before.size() == emittance.size());
  assert(irradiance.size() == emittance.size() && radiosity.size() == emittance.size());
  std::copy(emittance.begin(), emittance.end(), radiosity.begin());
  std::fill(before.begin(), before.end(), 0.0f);
  std::fill(irradiance.begin(), irradiance.end(), 0.0f);
  std::vector<float> next(irradiance.size());
  const auto emitted = power(emittance, {}, area, context) + power(outside, {}, area, context);
  JacobiReport report;
  auto unshot = emitted > 0.0 ? 1.0 : 0.0;
  while (unshot > options.tolerance) {
    if (options.steps > 0 && report.unshot_fraction.size() == static_cast<std::size_t>(options.steps)) {
      report.end = JacobiEnd::step_limit;
      return report;
    }
    const auto begun = options.steps > 0 ? static_cast<double>(report.unshot_fraction.size()) / options.steps
                                         : done_fraction(unshot, options.tolerance);
    const auto left_of_last = report.unshot_fraction.empty() ? 0.3 : 1.0 - begun;
    const auto steps_done = static_cast<double>(std::max<std::size_t>(1, report.unshot_fraction.size()));
    const auto a_step = options.steps > 0 ? 1.0 / options.steps : std::min(left_of_last, begun / steps_done);
    const auto tell_whole = [&](double fraction) {
      return context.report({"light", begun + fraction * a_step});
    };
    if (!gather(transport, radiosity, next, context, tell_whole)) {
      report.end = JacobiEnd::stopped;
      return report;
    }
    std::copy(radiosity.begin(), radiosity.end(), before.begin());
    context.for_chunks(radiosity.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        irradiance[i] = outside.empty() ? next[i] : outside[i] + next[i];
        radiosity[i] = emittance[i] + scattering.reflectance[i] * irradiance[i];
      }
    });
    if (scattering.transmits())
      context.for_chunks(radiosity.size(), grain, [&](std::size_t begin, std::size_t end, int) {
        for (auto i = begin; i < end; ++i)
          radiosity[i] = emittance[i] + scattering.sent_on(irradiance, i, transport.bands());
      });
    unshot = power(radiosity, before, area, context) / emitted;
    report.unshot_fraction.push_back(unshot);
    if (each_step)
      each_step({static_cast<int>(report.unshot_fraction.size()), before, irradiance, radiosity, unshot});
  }
  return report;
}

}  // namespace luxel
