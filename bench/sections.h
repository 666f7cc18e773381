// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace luxel::bench {

using Json = nlohmann::ordered_json;

struct Settings {
  std::filesystem::path references = "out/references";  // folder that keeps converged answers between runs
  bool small = false;  // a tenth of the size and less, to see that it works: the numbers mean nothing
};

// Each section prints a table as it goes and returns the same numbers.

Json against_embree(const Settings& settings);            // the solver against its limit
Json sampled_against_embree(const Settings& settings);    // the sampled operator against its limit
Json against_polygons(const Settings& settings);          // time against polygons at a fixed number of rays
Json against_lamps(const Settings& settings);             // many lamps against one
Json against_facets(const Settings& settings);            // shadow rays to bulbs of many triangles
Json luminaires_against_lamps(const Settings& settings);  // photometric files against square lamps
Json against_threads(const Settings& settings);           // threads
Json error_against_time(const Settings& settings);        // each method on each scene
Json variance_reduction(const Settings& settings);        // each switch of the sampled solver changed
Json stated_against_true(const Settings& settings);       // intervals and the seen error against known light
Json cost_per_patch(const Settings& settings);            // from 2,000 to a million patches
Json ray_order(const Settings& settings);            // rays as they are traced against the same rays shuffled
Json time_to_first_light(const Settings& settings);  // until a first picture is there
Json reconstruction(const Settings& settings);       // the drawn field against the light at points
Json load_to_files(const Settings& settings);        // all steps but the light
Json changed_lamps_and_colours(const Settings& settings);  // relighting
Json hours_against_limits(const Settings& settings);       // a year's products with coefficients
Json processes_against_threads(const Settings& settings);  // mpirun
Json frames_while_solving(const Settings& settings);       // the window's frames, 95th and 99th percentile
Json error_against_patches(const Settings& settings);      // patches of one size, and where light needs them

}  // namespace luxel::bench
