// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "luxel/core/context.h"
#include "luxel/session/session_snapshot.h"
#include "luxel/solve/bounces.h"
#include "luxel/solve/relight.h"

namespace luxel {

// The samples of a session's newest light, and the light computed from them without rays: that of other lamps
// and colours, and that after a number of bounces.
class SampleRelighting {
 public:
  explicit SampleRelighting(const Context& context) : context_(context) {}

  // The mesh of all samples from now on, with its tracer.
  void set_mesh(const SessionMesh& mesh);
  // A solve with these options begins: without samples, or with those of an earlier one.
  void begin(const SampledOptions& options, bool continues);
  void set_samples(std::shared_ptr<const SampleState> samples);

  bool has_samples() const { return samples_ != nullptr; }
  const std::shared_ptr<const SampleState>& samples() const { return samples_; }
  const SampledOptions& options() const { return options_; }
  // Returns whether a solve with these options may continue from the samples: only its limits differ.
  bool fits(const SampledOptions& options) const;

  // Finds the light of each light group, once, unless the monitor stops it. Needs samples.
  void find_group_light(const Monitor& monitor);

  // Light with other lamps and colours, and the patches that have them. Needs samples.
  struct Relit {
    std::shared_ptr<const PatchSet> patches;
    Solution solution;
  };
  Relit relight(const Lighting& lighting);

  // Light after `count` bounces, at least 0, and the light that the last one added. Needs samples.
  struct AfterBounces {
    Solution solution;
    SideValues unshot;
  };
  AfterBounces after_bounces(int count);

 private:
  void forget_light();

  const Context& context_;
  SessionMesh mesh_;
  std::shared_ptr<const SampleState> samples_;
  SampledOptions options_;
  std::unique_ptr<Relighter> relighter_;
  Lighting lighting_;  // of the relighter
  std::unique_ptr<Bounces> bounces_;
};

}  // namespace luxel
