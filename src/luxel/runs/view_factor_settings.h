// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "luxel/form_factors/exact_view_factors.h"
#include "luxel/form_factors/sample_view_factors.h"
#include "luxel/form_factors/view_elements.h"
#include "luxel/patch/make_patches.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// The options of `luxel viewfactors`, which fill the library's own.
struct ViewFactorSettings {
  std::string between = "groups";
  std::string sides = "front";
  std::vector<std::string> from;  // names of elements, with * and ?; empty: all
  std::optional<double> error;    // nothing: the library's own where no rays are given, else none
  SampleFactorsOptions sampled;
  ExactFactorsOptions exact;
  bool is_exact = false;
  bool enforce = false;
  bool compress = false;  // HDF5
  bool force = false;

  void declare(OptionSet& set);
  // Separate from the others, since it does not change the factors: listed under the heading Run.
  void declare_memory(OptionSet& set);
  // Throws UsageError where options contradict each other.
  void check() const;

  Between kind() const;
  ElementSides element_sides() const;
  // Returns options that leave triangles uncut for factors between patches, unless an edge is given.
  PatchOptions patch_options(PatchOptions given) const;
  // Returns the options with all defaults resolved; memory in bytes. outputs: to be written.
  SampleFactorsOptions sample_options(const ViewElements& elements,
                                      const std::vector<std::string>& outputs) const;
  // Returns the rows selected by --from, [element]; empty: all. Throws UsageError where a name matches none.
  std::vector<std::uint8_t> rows(const ViewElements& elements) const;
};

}  // namespace luxel
