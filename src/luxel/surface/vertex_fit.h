// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/scene/scene.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

/// Light at the vertices that the scene's file has.
struct VertexFit {
  SideValues irradiance;  ///< [scene vertex][band], W/m²; 0 where none is known
  /// area-weighted RMS of smooth light less fitted light, over the RMS of the light
  double difference = 0.0;
};

/// Fits the smooth light to the file's own triangles: values at their vertices whose linear interpolation is
/// nearest in the least-squares sense over all surfaces (Kavan, Bargteil and Sloan, "Least Squares Vertex
/// Baking", 2011, without its regularisation: values stay within the light that the vertex's own triangles
/// have). Vertices that the file splits, for a texture say, where the smooth light goes on get one value.
/// Exact where a triangle is one patch; light finer than the triangles is lost, and `difference` states how
/// much.
///
/// patches must be cut from this scene (PatchSet::triangle). Conjugate gradients on the mass matrix, whose
/// condition does not grow with the mesh; linear cost, on the calling thread. Throws MismatchError where the
/// three are not of one scene.
VertexFit fit_vertices(const Scene& scene, const PatchSet& patches, const SmoothLight& light);

}  // namespace luxel
