// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/lamp_surfaces.h"
#include "luxel/render/probe_light.h"

namespace luxel {

// Eye and view direction of an observer.
struct GlareObserver {
  Vec3 eye{0.0f};               // m, counted from the patches' origin
  Vec3 view{1.0f, 0.0f, 0.0f};  // unit
};

struct GlareOptions {
  double error = 0.02;             // standard error of the background's sampling, relative
  std::uint32_t max_rays = 65536;  // cosine rays per observer
  std::uint32_t lamp_rays = 64;    // shadow rays per lamp; one per patch of a lamp of more patches
  std::uint64_t seed = 1;
};

// A lamp that dazzles an observer.
struct GlareSource {
  std::string name;             // of the luminaire, or of the lamp's material
  Vec3d position{0.0};          // m, counted from the patches' origin: its middle
  double luminance = 0.0;       // cd/m², towards the eye
  double solid_angle = 0.0;     // sr, of what is visible
  double visible = 1.0;         // fraction of its rays that met nothing
  double position_index = 1.0;  // of Guth
  double squared_error = 0.0;   // of glare: from the sampling of visibility

  // L² omega / p², cd²/m⁴ sr
  double glare() const { return luminance * luminance * solid_angle / (position_index * position_index); }
};

// UGR of one observer (CIE 117:1995): 8 log10(0.25 / L_b sum L² omega / p²).
struct ObservedGlare {
  static constexpr double nothing = -std::numeric_limits<double>::infinity();

  double ugr = nothing;                  // minus infinity: no lamp dazzles; plus infinity: no background
  double low = nothing, high = nothing;  // 95 % interval, by the errors of background and visibility
  double background = 0.0;               // cd/m²: indirect illuminance at the eye / pi
  double background_error = 0.0;         // standard error, cd/m²: of the rays and of the solution
  double sampling = 1.0;                 // fraction of the interval's variance that more rays reduce
  std::vector<GlareSource> sources;      // the largest glare first
  std::size_t ignored = 0;               // visible lamps that UGR ignores, see GlareMeter
  std::size_t large = 0;                 // sources above 0.1 sr, for which UGR is not made
  std::uint64_t rays = 0;                // traced
  bool reached = false;                  // whether the sampling error is the requested one
};

// Measures UGR in a solved scene.
//
// Sources: luminaires with an opening, whose luminance is intensity over projected area, both from the middle
// of the opening; and surfaces that emit, connected patches of one material as one source with its mean
// luminance. Their visible part is found by shadow rays. Position index: see position_index.h; a source
// without one is ignored, and so is a flat opening seen flatter than 5 degrees, whose luminance is not known
// that precisely. Suns, and lamps without an extent, are not sources.
//
// Background: light that reaches the eye from surfaces by reflection, and from the sky, by cosine rays as
// SolutionProbe has them. Errors: its rays, the solution's light that they pick up, and visibility.
class GlareMeter {
 public:
  // Keeps references. up: of the scene, unit.
  GlareMeter(const SolutionProbe& probe, const Vec3d& up);

  // Depends on the arguments alone; any number of threads may call. Costs about 0.1 s.
  ObservedGlare at(const GlareObserver& observer, const GlareOptions& options, std::uint64_t key) const;

  // Number of luminaires and lamp surfaces that may dazzle.
  std::size_t lamps() const { return luminaires_.size() + surfaces_.size(); }

 private:
  struct View;
  void add_luminaire(const View& view, std::uint32_t light, const GlareOptions& options,
                     ObservedGlare& observed) const;
  void add_surface(const View& view, const LampSurface& lamp, const GlareOptions& options,
                   ObservedGlare& observed) const;
  void add_source(const View& view, GlareSource source, std::uint32_t rays, ObservedGlare& observed) const;
  // Returns the part of the standard error that comes from the rays, cd/m².
  double find_background(const View& view, const GlareOptions& options, ObservedGlare& observed) const;

  const SolutionProbe& probe_;
  Vec3d up_;
  std::vector<std::uint32_t> luminaires_;  // indices of point_lights
  std::vector<LampSurface> surfaces_;
};

// Measures many observers; empty where the monitor stopped the work. The same bits on any number of threads;
// an observer's glare depends on its index and on the seed, not on the others. Throws InputError where an
// observer or an option is invalid.
std::vector<ObservedGlare> observe_glare(const GlareMeter& meter, std::span<const GlareObserver> observers,
                                         const GlareOptions& options, const Context& context);

}  // namespace luxel
