// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "luxel/core/context.h"
#include "luxel/core/progress.h"

namespace luxel {

// Progress of a refinement and, where a solve of the light follows it, the time that it will take
// (Progress::later), from the first answer on the first mesh: the rays of a solve are in proportion to the
// patches. Has no clock: seconds are those since the refinement began.
class RefineProgress {
 public:
  // later_error: error target of the solve that follows, 0: none follows; later_ray_budget: see
  // SampledOptions. Keeps a reference to the context.
  RefineProgress(double later_error, std::uint64_t later_ray_budget, const Context& context);

  // Begins a mesh; each has more patches than the one before.
  void begin_mesh(std::size_t patches) { patches_ = patches; }
  // Progress of the solve on the first mesh, which may take a budget of rays; 0: without a bound.
  Next report_first_mesh(double seconds, const Progress& solve, std::uint64_t budget);
  // part: of the work on all later meshes; rays: of all meshes.
  Next report_later_mesh(double seconds, double part, std::uint64_t rays, double mesh_error) const;

 private:
  void note_first_answer(double seconds, double rays, double error);
  Next report(double seconds, Progress progress) const;

  double later_error_, later_ray_budget_;
  const Context& context_;
  std::size_t patches_ = 0;  // of the present mesh
  // The solve that follows: its rays per patch, 0 if unknown, and its seconds per ray.
  double later_rays_ = 0.0, later_pace_ = 0.0;
};

}  // namespace luxel
