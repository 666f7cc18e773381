// SPDX-License-Identifier: Apache-2.0
#pragma once

/// \file
/// What most programs need, in the order in which a scene becomes light.

// clang-format off
#include "luxel/version.h"

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/context.h"

#include "luxel/import/load_scene.h"
#include "luxel/scene/scene.h"

#include "luxel/patch/make_patches.h"
#include "luxel/trace/tracer.h"

#include "luxel/solve/bake.h"
#include "luxel/solve/refine_to_light.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/solve_light.h"

#include "luxel/solution/merge_solutions.h"
#include "luxel/solution/solution_file.h"

#include "luxel/surface/smooth_light.h"

#include "luxel/image/image_file.h"
#include "luxel/image/tone.h"
#include "luxel/render/automatic_camera.h"
#include "luxel/render/default_light.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/render/render.h"

#include "luxel/export/export_mesh.h"
// clang-format on
