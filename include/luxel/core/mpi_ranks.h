// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/core/ranks.h"

namespace luxel {

/// The ranks that an MPI launcher (mpirun, srun) started beside this process; none where it was not started
/// so or is alone. Where Luxel was built without MPI it throws if there are others. To be called once, before
/// threads are made.
std::unique_ptr<Ranks> join_ranks();

/// Ends all ranks at once, with this exit code: one of them cannot go on. Returns where there are no others.
void leave_ranks(int exit_code);

}  // namespace luxel
