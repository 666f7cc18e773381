// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/runs/option_set.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/relight.h"

namespace luxel {

// Lamps and colours of a solution to be changed, by name.
class RelightChanges {
 public:
  void declare(OptionSet& set);
  // --reflectance alone.
  void declare_reflectance(OptionSet& set);
  bool has_reflectance() const { return !reflectances_.empty(); }
  // Reflectances of all materials, with the changes: [material * bands + band]. Throws as apply() does.
  std::vector<float> new_reflectances(const std::string& file, const PatchSet& patches) const;
  // resets: whether the relighter had other changes before. Throws UsageError where a value is wrong,
  // InputError, beginning with the file, where a name matches nothing.
  void apply(const std::string& file, const PatchSet& patches, Relighter& relighter,
             bool resets = false) const;

 private:
  // NAME=VALUE, may be repeated.
  struct NamedValue {
    std::string name, text;
  };
  static Declaration named_values(const char* name, const char* unit, const char* expected, const char* help,
                                  std::vector<NamedValue>& values);
  std::vector<float> lamp_weights(const std::string& file, const PatchSet& patches) const;

  std::vector<NamedValue> lights_, tints_, reflectances_;
  std::vector<std::string> off_;
};

// The light of a relighter as a solution of its own, with the provenance of the original one and the changes.
// options: declared and given. Throws what Relighter throws.
Baked relit(const Relighter& relighter, const Solution& before, const OptionSet& options);

}  // namespace luxel
