// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/hint.h"
#include "luxel/core/log.h"
#include "luxel/core/vector.h"

namespace luxel {

enum class DiagnosticKind {
  no_lamp,
  lamp_lights_nothing,
  lamp_faces_wall,
  lamp_enclosed,
  lamp_windings,
  luminaire_misplaced,
  unlit,
  lost_at_backs,
  reflectance,
  escape,
  windings,
  units,
  opposite,
  duplicate,
  overlap,
  no_area,
  t_junction,
  open_edge,
  non_manifold_edge,
  sliver,
  opaque_glass,
  doubled_panes,
  clear_panes,
  covered_diffuser,
};

// Place of a diagnostic. Names are those of the file.
struct Place {
  std::uint32_t line = 0;  // in the scene's file, from 1; 0 where unknown
  std::string group = {}, object = {}, material = {};
  Vec3d at{0.0};            // m, as the file counts (times --scale)
  std::string detail = {};  // a property of this place: "2.3 m²"; may be empty
};

struct Diagnostic {
  DiagnosticKind kind = DiagnosticKind::no_lamp;
  Severity severity = Severity::note;
  std::size_t count = 0;           // of the things in `fact`: triangles, edges, loops, materials
  std::string fact = {};           // one sentence: the defect, with numbers
  std::string consequence = {};    // one sentence: how Luxel handles it
  std::string remedy = {};         // one sentence: how to change that
  std::vector<Hint> hints = {};    // the settings that change it, if any
  std::vector<Place> places = {};  // the worst first, as many as requested
  std::size_t all_places = 0;      // in total

  std::vector<std::uint32_t> triangles = {};    // all concerned, as indices in the scene
  std::vector<std::array<Vec3, 2>> edges = {};  // all concerned, m
};

// "t-junction": for reports and files.
std::string_view name(DiagnosticKind kind);
std::string_view name(Severity severity);

// The colour of a kind in all files of diagnostics: linear, and as a word.
struct FaultColour {
  Vec3 linear;
  std::string_view word;
};
FaultColour colour(DiagnosticKind kind);

}  // namespace luxel
