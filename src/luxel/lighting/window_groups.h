// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "luxel/lighting/coefficients.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Windows whose blinds are operated together.
struct WindowGroup {
  std::string name;             // of their glass's material, object or group; * and ? are wildcards
  double transmittance = 0.05;  // of closed blinds, for all light through these windows
};

// Makes panes of the windows of these groups that let all light pass, by a transmittance just below 1: before
// patches are made. Throws InputError where no glass has the name of a group.
void make_panes_of_groups(std::span<const WindowGroup> groups, Scene& scene);

// The panes of each group, as indices into patches.panes; `patches` are made from the scene. A pane belongs
// to the first group whose name fits it. Throws InputError for a group without panes.
std::vector<std::vector<std::uint32_t>> panes_of_groups(const Scene& scene, const PatchSet& patches,
                                                        std::span<const WindowGroup> groups);

// The same by the names of the panes' materials alone: for patches whose scene is not at hand.
std::vector<std::vector<std::uint32_t>> panes_of_groups(const PatchSet& patches,
                                                        std::span<const WindowGroup> groups);

// The same patches, with these panes dark.
PatchSet with_dark_panes(const PatchSet& patches, std::span<const std::uint32_t> panes);

// The light of windows by groups: that of the whole scene, and that which is left when the windows of one
// group are dark, by the same rays. Light is lost by the part of the difference that closed blinds keep out:
// exact where the blinds of one group are closed, and where all are open. Where several are closed, light
// that crosses windows of two of them is subtracted twice; `twice` measures it.
struct WindowLight {
  std::vector<WindowGroup> groups;
  std::vector<PatchSet> dark;                 // [group]
  std::vector<DaylightCoefficients> without;  // [group]
  // Light that is subtracted twice over all light, mean over the points under the sky of the run, with all
  // blinds closed and opaque.
  double twice = 0.0;
};

// One group, of all windows and openings: closed blinds let this part of all light through.
WindowLight all_windows(double transmittance);

struct WindowRun {
  DaylightRun run;
  const DaylightCoefficients& open;  // of the same run
  std::span<const ProbePoint> points;
};

// Empty after the monitor's stop. Cost: one find_coefficients() per group, one more for several, and the rays
// of the run again for each of them.
WindowLight find_window_light(const WindowRun& run, const Tracer& tracer, std::vector<WindowGroup> groups,
                              std::span<const std::vector<std::uint32_t>> panes,
                              const CoefficientOptions& options, const Context& context);

}  // namespace luxel
