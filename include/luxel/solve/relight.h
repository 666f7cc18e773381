// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct SampleState;

/// Solves the light of each light group separately: the part `gathered` of a state. Cost: one solve per
/// group, about ten look-ups per ray; memory: one number per receiver, band, group and replicate. The same
/// bits on any number of threads. Null if the monitor stopped it.
std::shared_ptr<const SampleState> with_group_light(const PatchSet& patches, const Tracer& tracer,
                                                    std::shared_ptr<const SampleState> state,
                                                    const SampledOptions& options,
                                                    const Context& context = {});

/// Relights a scene from the stored samples of a run without tracing rays (except if hits were streamed):
/// irradiance is linear in emittance, and the light of other reflectances is solved from the stored hits. All
/// replicates are treated alike, so the standard errors are those of the new light.
///
/// Not for several threads at once; the calls themselves use those of the context.
class Relighter {
 public:
  /// Keeps a reference to the tracer; the context's log and monitor are not used. patches, options: of the
  /// run. If the state has no group light, it is solved first. Throws MismatchError where the state is
  /// not of these patches.
  Relighter(PatchSet patches, const Tracer& tracer, std::shared_ptr<const SampleState> state,
            const SampledOptions& options, const Context& context = {});
  ~Relighter();
  Relighter(const Relighter&) = delete;
  Relighter& operator=(const Relighter&) = delete;

  /// The patches with the current emittances and reflectances, and the fingerprint of the changed scene.
  const PatchSet& patches() const;

  /// Sets the brightness of each light group relative to the run, at least 0: [group * bands + band]. Cost at
  /// 50,000 patches: tens of milliseconds.
  void set_lamps(std::vector<float> weight);
  /// [material * bands + band], in [0, 1). Each later light() costs a solve: about ten look-ups per ray. The
  /// run's own reflectances cost nothing.
  void set_reflectance(const std::vector<float>& reflectance);

  /// The light as it is now, with its errors. method, options and command line are the caller's.
  Solution light() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
