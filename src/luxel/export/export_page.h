// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/camera.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// The light of one group of lamps, all others dark.
struct GroupLight {
  Solution solution;
  SmoothLight light;
};

struct PageOptions {
  ToneOptions tone;   // the page begins with it; reinhard_local is shown as reinhard
  std::string title;  // of the page
  Camera camera;      // where the page begins; counted from the patches' origin, up is the scene's
  std::vector<std::uint8_t> hidden_backs = {};  // [patch], 1 where it need not be drawn; empty: none
};

// One HTML file that shows the lit scene in any browser with WebGL 2, from disk, without a network: to orbit
// and walk, with exposure, tone curves, a slider for each group of lamps, false colours and a probe.
// docs/html-pages.md shows it.
//
// groups: [light group of the patches], their light smoothed with the same options as `light`; or none, where
// all light is one. Smoothing is not linear to the last per cent, so at each vertex the groups are scaled to
// sum up to `light`: the page begins with the very light of the solution. Light is preserved in halves (0.05
// %) on one scale, errors in steps of 6 %.
//
// The same input gives the same bytes (from one version of zlib). Whole or not at all; throws DeviceError.
// Throws DeviceError where this program was built without Node.js and so has no page, MismatchError where the
// light is not of these patches or has no colour. Cost: linear; 0.6 MB and 10 to 15 bytes per patch
// in the file.
void export_page(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                 const SmoothLight& light, std::span<const GroupLight> groups, const PageOptions& options);

// Why this program has no page, as one sentence; empty where it has one.
std::string page_is_missing();

}  // namespace luxel
