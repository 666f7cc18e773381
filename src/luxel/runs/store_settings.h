// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/patch/light_groups.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// Options of data stored beside the light: the state to resume a solve, and the transport to relight the
// scene.
struct StoreSettings {
  bool transport = false;  // the solution file keeps the samples
  std::vector<LightGroupRule> groups;
  std::string checkpoint;  // file; empty: none is written
  double every = 60.0;     // s; at most so often
  bool groups_lamps() const { return transport || !groups.empty(); }
  // Options of the light, then of the run.
  void declare(OptionSet& set);
  void declare_groups(OptionSet& set);
  void declare_run(OptionSet& set);
  void declare_every(OptionSet& set);
};

// "desk=lamp_*" becomes {"desk", "lamp_*"}; throws UsageError naming the option.
std::pair<std::string, std::string> parse_named(const std::string& option, const std::string& text,
                                                const std::string& expected);

}  // namespace luxel
