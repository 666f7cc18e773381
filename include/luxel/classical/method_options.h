// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace luxel {

/// \file
/// Options of the classical methods, for solve_light(). classical.h and stochastic_jacobi.h describe the
/// methods.

struct StochasticJacobiOptions {
  /// Rays that carry the power of lamps and sky once. Reflected light adds rays in proportion to its power,
  /// and so do rays of the sky that meet nothing. 0: automatic.
  std::uint64_t rays = 0;
  double tolerance = 1e-4;  ///< fraction of the power of lamps and sky left unshot, (0, 1): the stated bias
  std::uint64_t seed = 1;   ///< another seed, another independent answer
  double rays_per_patch = 800;  ///< what automatic aims at, over the whole run
  bool shows_bounces = true;    ///< a picture (SolveHooks::on_light) after every bounce
};

struct JacobiOptions {
  double tolerance = 1e-4;  ///< fraction of the power of lamps and sky that may stay unshot: the bias
  int steps = 0;            ///< bounces at most; 0: no bound
};

struct DenseOptions {
  double tolerance = 1e-4;  ///< absolute, of each form factor, where what lies between must be integrated
};

enum class DenseSolver { direct, jacobi, gauss_seidel };

struct DenseSolveOptions {
  DenseOptions factors = {};
  DenseSolver solver = DenseSolver::direct;
  JacobiOptions iteration = {};  ///< of jacobi; of gauss_seidel its tolerance
  /// [patch]: patches of the same face share one value; empty: each its own
  std::vector<std::uint32_t> face = {};
};

struct HemicubeOptions {
  int resolution = 128;  ///< pixels along an edge of the top face: even, 2 to 4096; the four sides have half
  int points = 1;        ///< of the patch that look: centres of 1, 4, 16, 64 or 256 equal parts
};

struct HemicubeSolveOptions {
  HemicubeOptions hemicube = {};
  JacobiOptions iteration = {};
};

struct LinesOptions {
  std::uint32_t lines = 1000;  ///< from each side
  std::uint64_t seed = 1;      ///< another seed, other lines
};

struct LinesSolveOptions {
  LinesOptions lines = {};
  JacobiOptions iteration = {};
};

/// Estimated time and memory of a solve.
struct Forecast {
  std::uint64_t sides = 0;  ///< that gather light
  double seconds = 0.0;
  std::uint64_t bytes = 0;  ///< at the peak, beside patches and tracer
};

}  // namespace luxel
