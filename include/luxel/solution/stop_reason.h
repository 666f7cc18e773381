// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace luxel {

/// Why a solver stopped.
enum class StopReason {
  converged,        ///< the unshot fraction fell below the tolerance, or the linear system is solved
  error_reached,    ///< the standard error is the requested one
  ray_limit,        ///< the next doubling would exceed the allowed rays, or the allowed time
  time_limit,       ///< the allowed time is over
  stopped_by_user,  ///< the monitor returned stop
  nothing_to_do,    ///< there is no light
  step_limit        ///< the requested bounces are done
};

/// The reason as files and JSON spell it, such as "error_reached".
std::string_view name(StopReason reason);
/// The reason as a phrase for people, such as "error reached".
std::string_view description(StopReason reason);
/// Returns the reason with this name; nothing if there is none.
std::optional<StopReason> stop_reason(std::string_view name);

}  // namespace luxel
