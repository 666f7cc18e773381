// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/stop_reason.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace luxel {
namespace {

struct Entry {
  StopReason reason;
  std::string_view name, description;
};

// In the order of the enumeration.
constexpr auto entries = std::to_array<Entry>({
    {StopReason::converged, "converged", "converged"},
    {StopReason::error_reached, "error_reached", "error reached"},
    {StopReason::ray_limit, "ray_limit", "ray limit"},
    {StopReason::time_limit, "time_limit", "time limit"},
    {StopReason::stopped_by_user, "stopped_by_user", "stopped by user"},
    {StopReason::nothing_to_do, "nothing_to_do", "nothing to do"},
    {StopReason::step_limit, "step_limit", "step limit"},
});

}  // namespace

std::string_view name(StopReason reason) { return entries[static_cast<std::size_t>(reason)].name; }

std::string_view description(StopReason reason) {
  return entries[static_cast<std::size_t>(reason)].description;
}

std::optional<StopReason> stop_reason(std::string_view name) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
  return found == entries.end() ? std::nullopt : std::optional(found->reason);
}

}  // namespace luxel
